#include "viz/build/build_space.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "viz/cell_geometry.h"
#include "viz/paper.h"
#include "viz/space_actor.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr int slots = 10;  // of each axis, of which the cheapest plane is drawn

void add_lines(vtkRenderer& renderer, vtkPolyData* data, const Rgb& color, double width, double opacity = 1,
               int front = 0) {
  vtkActor& actor = *add_actor(renderer, data, color, opacity);
  actor.GetProperty()->SetLineWidth(static_cast<float>(width));
  actor.GetProperty()->LightingOff();
  actor.GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  actor.GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4.0 * (front + 1));
}

New<vtkPolyData> triangles_of(const TriangleMesh& mesh, std::span<const std::uint32_t> ids) {
  auto points = New<vtkPoints>::New();
  auto faces = New<vtkCellArray>::New();
  for (const std::uint32_t id : ids) {
    vtkIdType corners[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3f& p = mesh.positions()[mesh.triangles()[id][static_cast<std::size_t>(i)]];
      corners[i] = points->InsertNextPoint(p.x, p.y, p.z);
    }
    faces->InsertNextCell(3, corners);
  }
  auto data = New<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(faces);
  return data;
}

/// Where a plane cuts a region, as a convex polygon; empty where it passes it by.
std::vector<Vec3d> section_of(const Cell& cell, const Plane& plane) {
  const auto surface = cell_surfaces(std::span(&cell, 1));
  const std::vector<Vec3d> corners = points_of(*surface);
  std::vector<Vec3d> cut;
  vtkIdType count;
  const vtkIdType* ids;
  vtkCellArray& faces = *surface->GetPolys();
  for (faces.InitTraversal(); faces.GetNextCell(count, ids);) {
    for (vtkIdType i = 0; i < count; ++i) {
      const Vec3d& p = corners[static_cast<std::size_t>(ids[i])];
      const Vec3d& q = corners[static_cast<std::size_t>(ids[(i + 1) % count])];
      const double from = plane.side(p), to = plane.side(q);
      if ((from < 0) != (to < 0)) cut.push_back(p + (from / (from - to)) * (q - p));
    }
  }
  if (cut.size() < 3) return {};
  Vec3d middle(0);
  for (const Vec3d& p : cut) middle += p / double(cut.size());
  const Vec3d normal = glm::normalize(plane.normal);
  const Vec3d away = std::fabs(normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d u = glm::normalize(glm::cross(away, normal)), v = glm::cross(normal, u);
  std::sort(cut.begin(), cut.end(), [&](const Vec3d& a, const Vec3d& b) {
    return std::atan2(glm::dot(a - middle, v), glm::dot(a - middle, u)) <
           std::atan2(glm::dot(b - middle, v), glm::dot(b - middle, u));
  });
  return cut;
}

Plane plane_of(const BuildCandidate& candidate) {
  if (candidate.axis < 0) return candidate.plane;
  Plane plane{Vec3d(0), candidate.position};
  plane.normal[candidate.axis] = 1;
  return plane;
}

New<vtkPolyData> polygons_of(const std::vector<std::vector<Vec3d>>& sections, bool are_filled) {
  auto points = New<vtkPoints>::New();
  auto parts = New<vtkCellArray>::New();
  for (const std::vector<Vec3d>& corners : sections) {
    std::vector<vtkIdType> ids;
    for (const Vec3d& p : corners) ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
    if (!are_filled) ids.push_back(ids.front());
    parts->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto data = New<vtkPolyData>::New();
  data->SetPoints(points);
  are_filled ? data->SetPolys(parts) : data->SetLines(parts);
  return data;
}

/// The cheapest planes: of each axis in each of some intervals, of others over all.
std::vector<std::size_t> telling(const Decision& decision) {
  std::array<std::pair<double, double>, 3> spans;
  spans.fill({1e300, -1e300});
  for (const BuildCandidate& c : decision.candidates) {
    if (c.axis < 0) continue;
    auto& [lo, hi] = spans[static_cast<std::size_t>(c.axis)];
    lo = std::min(lo, c.position), hi = std::max(hi, c.position);
  }
  std::map<std::pair<int, int>, std::size_t> best;
  int others = 0;
  for (std::size_t i = 0; i < decision.candidates.size(); ++i) {
    const BuildCandidate& c = decision.candidates[i];
    std::pair<int, int> slot{-1, others++};
    if (c.axis >= 0) {
      const auto [lo, hi] = spans[static_cast<std::size_t>(c.axis)];
      slot = {c.axis, hi > lo ? std::min(slots - 1, static_cast<int>((c.position - lo) / (hi - lo) * slots)) : 0};
    } else if (c.plane.normal == Vec3d(0)) {
      continue;  // no plane
    }
    const auto [at, is_new] = best.try_emplace(slot, i);
    if (!is_new && c.cost < decision.candidates[at->second].cost) at->second = i;
  }
  std::vector<std::size_t> drawn;
  for (const auto& [slot, i] : best) drawn.push_back(i);
  std::stable_sort(drawn.begin(), drawn.end(), [&](std::size_t a, std::size_t b) {
    return decision.candidates[a].cost < decision.candidates[b].cost;
  });
  if (drawn.size() > 3 * slots) drawn.resize(3 * slots);
  return drawn;
}

constexpr std::size_t most_colors = 64;  // so many children have a color each

/// The color of child i of more than two.
Rgb child_color(std::size_t i, std::size_t count) { return ramp(double(i) / double(count - 1), 0.4, 0.82); }

void add_group(vtkRenderer& space, const TriangleMesh& mesh, const std::vector<std::uint32_t>& ids, const Rgb& color,
               double opacity = 1) {
  if (ids.empty()) return;
  vtkActor& actor = *add_actor(space, triangles_of(mesh, ids), color, opacity);
  actor.GetProperty()->SetAmbient(0.35);
  actor.GetProperty()->SetDiffuse(0.7);
  actor.GetProperty()->SetInterpolationToFlat();
}

void add_triangles(vtkRenderer& space, const BuildStory& story, const Decision& decision) {
  const TriangleMesh& mesh = story.mesh();
  enum : std::uint8_t { in_below = 1, in_above = 2, in_node = 4 };
  std::vector<std::uint8_t> sides(mesh.size());
  for (const std::uint32_t id : decision.primitives) sides[id] = in_node;
  for (const std::uint32_t id : decision.below) sides[id] |= in_below;
  for (const std::uint32_t id : decision.above) sides[id] |= in_above;
  std::array<std::vector<std::uint32_t>, 8> groups;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) groups[sides[id]].push_back(id);
  const bool has_colors = decision.parts.size() <= most_colors;
  for (std::size_t part = 0; has_colors && part < decision.parts.size(); ++part) {
    add_group(space, mesh, decision.parts[part], child_color(part, decision.parts.size()));
  }
  if (decision.parts.empty() || !has_colors) add_group(space, mesh, groups[in_node], {0.84, 0.83, 0.81});
  add_group(space, mesh, groups[in_node | in_below], below_color);
  add_group(space, mesh, groups[in_node | in_above], above_color);
  add_group(space, mesh, groups[in_node | in_below | in_above], both_color);
  add_group(space, mesh, groups[0], {0.75, 0.76, 0.78}, 0.10);
}

}  // namespace

SpaceTold show_space(vtkRenderer& space, const BuildStory& story, const BuildStep& step, const BuildLook& look,
                     double aspect, double scale) {
  const Decision& decision = step.decision;
  const BuildNode& node = story.tree()[step.node];
  const Axes axes = axes_toward(look.azimuth, look.elevation);
  add_triangles(space, story, decision);

  SpaceTold told;
  const std::vector<std::size_t> drawn = telling(decision);
  for (const BuildCandidate& c : decision.candidates) told.planes += c.axis >= 0 || c.plane.normal != Vec3d(0);
  if (!drawn.empty()) {
    told.cheapest = decision.candidates[drawn.front()].cost;
    told.dearest = decision.candidates[drawn.back()].cost;
  }
  for (std::size_t i = drawn.size(); i-- > 0;) {
    const BuildCandidate& candidate = decision.candidates[drawn[i]];
    const std::vector<Vec3d> corners = section_of(node.cell, plane_of(candidate));
    if (corners.empty()) continue;
    ++told.planes_drawn;
    const double span = told.dearest - told.cheapest;
    const Rgb color = ramp(span > 0 ? (candidate.cost - told.cheapest) / span : 0);
    add_lines(space, polygons_of({corners}, false), color, 1.2 * scale, 0.85);
  }

  std::vector<Cell> children;
  for (const std::size_t child : node.children) children.push_back(story.tree()[child].cell);
  for (const Aabb& box : decision.merged) {
    const Cell cell{box, 0, false, {}, 0};
    add_lines(space, cell_outlines(std::span(&cell, 1), axes.z), {0.55, 0.57, 0.62}, 1.4 * scale, 0.9, 2);
  }
  const bool is_crowded = children.size() > most_colors;  // of a grid
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (is_crowded) {
      add_lines(space, cell_outlines(children, axes.z), {0.10, 0.45, 0.70}, 0.8 * scale, 0.35);
      break;
    }
    const Rgb color = children.size() > 2 ? child_color(i, children.size())
                      : i == 0            ? Rgb{0.10, 0.45, 0.70}
                                          : Rgb{0.75, 0.52, 0.05};
    add_lines(space, cell_outlines(std::span(&children[i], 1), axes.z), color, 3.4 * scale, 1, 3);
  }
  const auto outline = cell_outlines(std::span(&node.cell, 1), axes.z);
  add_lines(space, outline, ink, 2.2 * scale, 1, 1);
  if (decision.chosen) {
    const std::vector<Vec3d> corners = section_of(node.cell, plane_of(decision.candidates[*decision.chosen]));
    if (!corners.empty()) {
      vtkActor& fill = *add_actor(space, polygons_of({corners}, true), ink, 0.22);
      fill.GetProperty()->LightingOff();
      add_lines(space, polygons_of({corners}, false), ink, 4.5 * scale, 1, 5);
    }
  }
  std::vector<Vec3d> seen = points_of(*outline);
  for (const Cell& child : children) {
    if (is_crowded) break;
    for (const Vec3d& p : points_of(*cell_outlines(std::span(&child, 1), axes.z))) seen.push_back(p);
  }
  Vec3d lo = seen.front(), hi = lo;
  for (const Vec3d& p : seen) lo = glm::min(lo, p), hi = glm::max(hi, p);
  const Vec3d middle = 0.5 * lo + 0.5 * hi;
  for (Vec3d& p : seen) p -= middle;  // fit_camera leaves room in proportion to the distance from the origin
  SpaceCamera camera = fit_camera(axes, seen, aspect, look.zoom);
  camera.eye += middle;
  camera.focus += middle;
  camera.aim(*space.GetActiveCamera());
  space.ResetCameraClippingRange();
  return told;
}

}  // namespace sightline::viz
