#include "viz/walk/split_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline::viz {
namespace {

constexpr std::array<std::string_view, 3> dividing = {"kd-tree", "bsp-tree", "bih"};

using Face = std::vector<Vec3d>;

std::vector<Face> faces_of_box(const Aabb& box) {
  const Vec3d lo(box.lo), hi(box.hi);
  std::vector<Face> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const Vec3d& side : {lo, hi}) {
      Face face(4, side);
      face[0][u] = face[3][u] = lo[u], face[1][u] = face[2][u] = hi[u];
      face[0][v] = face[1][v] = lo[v], face[2][v] = face[3][v] = hi[v];
      faces.push_back(face);
    }
  }
  return faces;
}

std::vector<Face> faces_of_region(const Polyhedron& region) {
  std::vector<Face> faces;
  for (const auto& corners : region.faces) {
    Face face;
    for (const std::uint32_t corner : corners) face.push_back(region.vertices[corner]);
    faces.push_back(face);
  }
  return faces;
}

std::vector<Face> faces_of(const Cell& cell) {
  if (const auto* box = std::get_if<Aabb>(&cell.region)) return faces_of_box(*box);
  if (const auto* region = std::get_if<Polyhedron>(&cell.region)) return faces_of_region(*region);
  return {};
}

/// Newell's: of any planar polygon, not of unit length.
Vec3d normal_of(const Face& face) {
  Vec3d normal(0);
  for (std::size_t i = 0; i < face.size(); ++i) normal += glm::cross(face[i], face[(i + 1) % face.size()]);
  return normal;
}

/// Whether a face lies in the plane of one of the others. Vertices of polyhedra are rounded, which a hundred thousandth
/// of their size is far above, and far below what is seen.
bool lies_in(const Face& face, const std::vector<Face>& others) {
  Vec3d middle(0);
  for (const Vec3d& p : face) middle += p / double(face.size());
  for (const Face& other : others) {
    Face moved = other;
    double size = 0;
    for (Vec3d& p : moved) p -= middle, size = std::max(size, max_norm(p));
    const Vec3d normal = normal_of(moved);
    const double length = glm::length(normal);
    if (length == 0) continue;
    const auto height = [&](const Vec3d& p) { return std::fabs(glm::dot(p - other.front(), normal)) / length; };
    if (std::ranges::all_of(face, [&](const Vec3d& p) { return height(p) <= 1e-5 * size; })) return true;
  }
  return false;
}

/// Of a bounding interval hierarchy, whose children are shown by the boxes of what they hold: the two planes that clip
/// the node, across the axis along which the children lie farthest apart.
std::vector<Face> clip_planes(const Aabb& node, const Aabb& a, const Aabb& b) {
  int best = 0;
  double widest = -1e300;
  bool is_a_first = true;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_first : {true, false}) {
      const Aabb &lower = is_first ? a : b, &upper = is_first ? b : a;
      const double gap = double(upper.lo[axis]) - double(lower.hi[axis]);
      if (gap > widest) widest = gap, best = axis, is_a_first = is_first;
    }
  }
  std::vector<Face> faces;
  for (const float position : {(is_a_first ? a : b).hi[best], (is_a_first ? b : a).lo[best]}) {
    Aabb flat = node;
    flat.lo[best] = flat.hi[best] = position;
    faces.push_back(faces_of_box(flat)[2 * static_cast<std::size_t>(best)]);
  }
  return faces;
}

}  // namespace

bool has_split_planes(std::string_view structure) { return std::ranges::find(dividing, structure) != dividing.end(); }

std::vector<std::vector<Vec3d>> split_faces(std::string_view structure, const Walk& walk, std::size_t step) {
  if (!has_split_planes(structure) || walk.steps.empty()) return {};
  if (walk.steps[step].kind == WalkStep::Kind::cull) return {};  // it will not be known
  std::size_t cell = current_cell(walk, step);
  const auto is_opened = [&](std::size_t i) { return walk.cells[i].opened && *walk.cells[i].opened <= step; };
  while ((walk.cells[cell].cell.is_leaf || !is_opened(cell)) && walk.cells[cell].parent) {
    cell = *walk.cells[cell].parent;
  }
  const std::vector<Face> outer = faces_of(walk.cells[cell].cell);
  std::vector<Face> faces;
  if (structure == "bih") {
    std::vector<Aabb> boxes;
    for (const WalkCell& child : walk.cells) {
      if (child.parent == cell) boxes.push_back(std::get<Aabb>(child.cell.region));
    }
    const Aabb* node = std::get_if<Aabb>(&walk.cells[cell].cell.region);
    return boxes.size() == 2 && node ? clip_planes(*node, boxes[0], boxes[1]) : faces;
  }
  for (const WalkCell& child : walk.cells) {
    if (child.parent != cell) continue;
    for (const Face& face : faces_of(child.cell)) {
      if (!lies_in(face, outer) && !lies_in(face, faces)) faces.push_back(face);
    }
  }
  return faces;
}

}  // namespace sightline::viz
