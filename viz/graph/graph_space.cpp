#include "viz/graph/graph_space.h"

#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "viz/cell_geometry.h"
#include "viz/graph/bound_lines.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr std::size_t most_things = 20'000;

enum class Standing { known, told, stale, latest, selected, former };

/// Lines that look alike.
struct LineStyle {
  Standing standing;
  std::uint32_t depth;

  bool is_dashed() const {
    return standing == Standing::stale || standing == Standing::latest || standing == Standing::former;
  }
  Rgb color(std::uint32_t deepest) const {
    if (standing == Standing::former) return soft_ink;
    const bool is_plain = standing == Standing::known || standing == Standing::told;
    return is_plain ? color_of_depth(depth, deepest) : accent;
  }
  double width(std::uint32_t deepest) const {
    const double share = deepest == 0 ? 0 : std::min(1.0, double(depth) / deepest);
    switch (standing) {
      case Standing::known:
        return 1.1 + 1.3 * std::pow(1 - share, 2);
      case Standing::former:
        return 1.7;
      case Standing::stale:
        return 1.8;
      case Standing::told:
        return 2.3;
      default:
        return 2.9;
    }
  }
  friend bool operator<(const LineStyle& a, const LineStyle& b) {
    return std::tie(a.standing, a.depth) < std::tie(b.standing, b.depth);
  }
};

void add_lines(vtkRenderer& renderer, const std::vector<Cell>& cells, const LineStyle& style, const SpaceCamera& camera,
               const GraphLook& look, double dash, double scale) {
  vtkSmartPointer<vtkPolyData> lines = cell_outlines(cells, camera.axes.z);
  if (style.is_dashed()) lines = dashed(*lines, dash);
  auto mapper = New<vtkPolyDataMapper>::New();
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  const double order = style.standing == Standing::known ? 0 : 400;
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(
      0, -4 - order - 8.0 * (look.deepest - std::min(look.deepest, style.depth)));
  auto actor = New<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  const Rgb color = style.color(look.deepest);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(style.width(look.deepest) * scale));
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

/// Nodes whose things are drawn: where there are too many, those in the largest bounds.
std::vector<NodeId> nodes_with_things(const DrawnScene& drawn, const Snapshot& snapshot) {
  std::vector<NodeId> nodes;
  for (const NodeId node : drawn.shape.order) {
    if (drawn.surfaces.mapper(node) != nullptr) nodes.push_back(node);
  }
  if (nodes.size() <= most_things) return nodes;
  std::nth_element(nodes.begin(), nodes.begin() + most_things, nodes.end(), [&](NodeId a, NodeId b) {
    return std::pair(-volume_of(snapshot.bounds[a]), a) < std::pair(-volume_of(snapshot.bounds[b]), b);
  });
  nodes.resize(most_things);
  return nodes;
}

void place_actor(vtkActor& actor, const Affine& world) {
  auto matrix = New<vtkMatrix4x4>::New();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) matrix->SetElement(static_cast<int>(i), static_cast<int>(k), world.rows[i][k]);
  }
  actor.SetUserMatrix(matrix);
}

/// By node: whether it is `above` or below it.
std::vector<bool> below(const DrawnScene& drawn, NodeId above) {
  std::vector<bool> is_below(drawn.graph.size(), false);
  for (const NodeId node : drawn.shape.order) {
    is_below[node] = node == above || (node != root_node && is_below[drawn.graph.parent(node)]);
  }
  return is_below;
}

void add_things(GraphSpace& space, const DrawnScene& drawn, const GraphFrame& frame, const GraphLook& look) {
  const std::vector<bool> is_selected = below(drawn, look.selected);
  for (const NodeId node : nodes_with_things(drawn, *frame.places)) {
    auto actor = New<vtkActor>::New();
    actor->SetMapper(drawn.surfaces.mapper(node));
    place_actor(*actor, frame.places->worlds[node]);
    Rgb color = drawn.surfaces.color(node);
    const bool is_chosen = look.selected != root_node && is_selected[node];
    const Rgb other = is_chosen ? accent : Rgb{0.9, 0.9, 0.89};
    for (std::size_t c = 0; c < 3; ++c) color[c] += (is_chosen ? 0.62 : 0.45) * (other[c] - color[c]);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetAmbient(0.24);
    actor->GetProperty()->SetDiffuse(0.8);
    actor->GetProperty()->SetInterpolationToPhong();
    space.renderer->AddActor(actor);
    space.things.emplace_back(actor, node);
  }
}

/// At a node's bound, where it is highest in the picture, and none of `taken` is near.
std::optional<Canvas::Point> place_for_number(const std::vector<Canvas::Point>& corners,
                                              const std::vector<Canvas::Point>& taken, const PanelFrame& panel) {
  constexpr double room = 23, margin = 13;
  if (corners.empty()) return std::nullopt;
  std::vector<Canvas::Point> places = corners;
  std::sort(places.begin(), places.end(),
            [](const auto& a, const auto& b) { return a.y + 0.3 * a.x < b.y + 0.3 * b.x; });
  const Canvas::Point first = places.front();
  for (int step = 1; step < 12; ++step) places.push_back({first.x + step * room, first.y});
  for (Canvas::Point& at : places) {
    at.x = std::clamp(at.x, panel.x + margin, panel.x + panel.width - margin);
    at.y = std::clamp(at.y, panel.y + margin, panel.y + panel.height - margin);
    const auto is_near = [&](const Canvas::Point& other) { return std::hypot(at.x - other.x, at.y - other.y) < room; };
    if (std::none_of(taken.begin(), taken.end(), is_near)) return at;
  }
  return places.front();
}

}  // namespace

Rgb color_of_depth(std::uint32_t depth, std::uint32_t deepest) {
  return ramp(deepest == 0 ? 0.35 : std::min(1.0, double(depth) / deepest));
}

std::uint32_t readable_depth(const TreeShape& shape, const Snapshot& snapshot, BoundKind kind) {
  std::vector<std::size_t> counts(shape.deepest + 1, 0);
  for (const NodeId node : shape.order) {
    const Bound& bound = snapshot.bounds[node];
    if (!is_nothing(bound) && !is_unbounded(bound)) ++counts[shape.depths[node]];
  }
  const std::size_t most = kind == BoundKind::box ? 130 : kind == BoundKind::sphere ? 65 : 33;
  std::uint32_t depth = 0;
  std::size_t sum = counts[0];
  while (depth < shape.deepest && (sum == 0 || sum + counts[depth + 1] <= most)) sum += counts[++depth];
  return depth;
}

std::vector<NodeId> nodes_with_bounds(const DrawnScene& drawn, const GraphFrame& frame, const GraphLook& look) {
  constexpr std::size_t most_bounds = 4000;
  std::vector<bool> is_marked(drawn.graph.size(), false);
  for (const auto& [node, number] : numbered(frame)) is_marked[node] = true;
  is_marked[look.selected] = true;
  std::vector<NodeId> nodes;
  for (const NodeId node : drawn.shape.order) {
    const std::uint32_t depth = drawn.shape.depths[node];
    const bool is_asked = depth >= look.shallowest && depth <= look.deepest && nodes.size() < most_bounds;
    const Bound& bound = frame.bounds->bounds[node];
    if ((is_asked || is_marked[node]) && !is_nothing(bound) && !is_unbounded(bound)) nodes.push_back(node);
  }
  return nodes;
}

namespace {

/// What a camera has to see.
std::vector<Vec3d> points_to_see(const DrawnScene& drawn, const std::vector<GraphFrame>& frames, const GraphLook& look,
                                 const Axes& axes) {
  std::vector<Vec3d> points;
  for (const GraphFrame& frame : frames) {
    std::vector<Cell> cells;
    for (const NodeId node : nodes_with_bounds(drawn, frame, look))
      cells.push_back(cell_of(frame.bounds->bounds[node], 0, 0));
    for (const NodeId node : drawn.shape.order) {
      if (drawn.surfaces.mapper(node) == nullptr) continue;
      const Bound& bound = frame.places->bounds[node];
      if (!is_nothing(bound) && !is_unbounded(bound) && cells.size() < 8000) cells.push_back(cell_of(bound, 0, 0));
    }
    const std::vector<Vec3d> seen = points_of(*cell_outlines(cells, axes.z));
    points.insert(points.end(), seen.begin(), seen.end());
  }
  return points;
}

}  // namespace

SpaceCamera camera_for(const DrawnScene& drawn, const std::vector<GraphFrame>& frames, const GraphLook& look,
                       double aspect) {
  const Axes axes = axes_toward(look.azimuth, look.elevation);
  return fit_camera(axes, points_to_see(drawn, frames, look, axes), aspect, 0.95 * look.zoom);  // room for paddings
}

double aspect_of(const DrawnScene& drawn, const std::vector<GraphFrame>& frames, const GraphLook& look) {
  const Axes axes = axes_toward(look.azimuth, look.elevation);
  const std::vector<Vec3d> points = points_to_see(drawn, frames, look, axes);
  const SpaceCamera camera = fit_camera(axes, points, 1, 1);
  glm::dvec2 lo(1), hi(-1);
  for (const Vec3d& p : points) {
    if (const auto on_screen = camera.project(p)) lo = glm::min(lo, *on_screen), hi = glm::max(hi, *on_screen);
  }
  const glm::dvec2 size = hi - lo;
  return size.x > 0 && size.y > 0 ? std::clamp(size.x / size.y, 0.2, 5.0) : 1;
}

std::vector<std::pair<NodeId, std::size_t>> numbered(const GraphFrame& frame) {
  constexpr std::size_t most = 14, first = 4;
  std::vector<std::pair<NodeId, std::size_t>> numbers;
  if (frame.moved == no_node) return numbers;
  const std::size_t count = frame.told.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (count <= most || i < first || i + (most - first) >= count) numbers.emplace_back(frame.told[i], i + 1);
  }
  return numbers;
}

void draw_number(Canvas& canvas, const Canvas::Point& at, std::size_t number, bool is_latest) {
  const Rgb white{1, 1, 1};
  canvas.disc(at, 12, white);
  canvas.disc(at, 10.5, accent);
  if (!is_latest) canvas.disc(at, 8.5, white);
  const std::string text = std::to_string(number);
  canvas.text({at.x, at.y + 0.5}, text,
              {text.size() > 2 ? 9.0 : 13.5, is_latest ? white : accent, Canvas::Align::center, true});
}

GraphSpace space_of(const DrawnScene& drawn, const GraphFrame& frame, const GraphLook& look, const SpaceCamera& camera,
                    const PanelFrame& panel, const PartPlace& place, Canvas& over) {
  GraphSpace space{place.renderer(panel), {}};
  light_space(*space.renderer);
  if (look.has_things) add_things(space, drawn, frame, look);

  const std::vector<NodeId> nodes = nodes_with_bounds(drawn, frame, look);
  std::map<NodeId, std::size_t> numbers;
  for (const auto& [node, number] : numbered(frame)) numbers[node] = number;
  const std::vector<double> pads = paddings(drawn.graph, drawn.shape, *frame.bounds, nodes);
  const double pixel = 2 * camera.half_height_at(camera.focus) / panel.height;  // of the world, for one unit
  std::map<LineStyle, std::vector<Cell>> lines;
  std::vector<Canvas::Point> taken;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const NodeId node = nodes[i];
    const std::uint32_t depth = drawn.shape.depths[node];
    const auto number = numbers.find(node);
    const bool is_told = number != numbers.end(), is_latest = is_told && number->second == frame.told.size();
    Standing standing = Standing::known;
    if (is_told) standing = !frame.is_stale ? Standing::told : is_latest ? Standing::latest : Standing::stale;
    if (!is_told && node == look.selected && node != root_node) standing = Standing::selected;
    const Cell cell = cell_of(frame.bounds->bounds[node], 3.2 * pixel * pads[i], depth);
    lines[{standing, depth}].push_back(cell);
    if (!frame.former || !(is_told || (frame.moved == no_node && node == look.selected))) continue;
    const Bound& former = frame.former->bounds[node];
    const bool has_changed =
        !(is_nothing(former) || is_unbounded(former)) && !is_same(former, frame.bounds->bounds[node]);
    if (has_changed) lines[{Standing::former, depth}].push_back(cell_of(former, 3.2 * pixel * pads[i], depth));
  }
  for (const auto& [style, cells] : lines) {
    add_lines(*space.renderer, cells, style, camera, look, 7 * pixel, place.scale);
  }

  for (const auto& [node, number] : numbered(frame)) {
    const auto at = std::find(nodes.begin(), nodes.end(), node);
    if (at == nodes.end()) continue;
    const double pad = 3.2 * pixel * pads[static_cast<std::size_t>(at - nodes.begin())];
    std::vector<Canvas::Point> corners;
    for (const Vec3d& p :
         points_of(*cell_outlines(std::array{cell_of(frame.bounds->bounds[node], pad, 0)}, camera.axes.z))) {
      if (const auto on_screen = camera.project(p)) {
        corners.push_back(
            {panel.x + (on_screen->x + 1) / 2 * panel.width, panel.y + (1 - on_screen->y) / 2 * panel.height});
      }
    }
    if (const auto spot = place_for_number(corners, taken, panel)) {
      taken.push_back(*spot);
      draw_number(over, *spot, number, number == frame.told.size());
    }
  }
  camera.aim(*space.renderer->GetActiveCamera());
  space.renderer->ResetCameraClippingRange();
  return space;
}

}  // namespace sightline::viz
