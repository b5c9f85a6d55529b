#include "viz/graph/bound_lines.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace sightline::viz {
namespace {

Aabb padded(const Aabb& box, float by) { return {box.lo - by, box.hi + by}; }
Sphere padded(const Sphere& sphere, float by) { return {sphere.center, sphere.radius + by}; }
Cylinder padded(const Cylinder& c, float by) { return {c.center, c.axis, c.radius + by, c.half_length + by}; }

bool is_equal(const Aabb& a, const Aabb& b) { return a == b; }
bool is_equal(const Sphere& a, const Sphere& b) { return a.center == b.center && a.radius == b.radius; }
bool is_equal(const Cylinder& a, const Cylinder& b) {
  return a.center == b.center && a.axis == b.axis && a.radius == b.radius && a.half_length == b.half_length;
}

/// Whether faces lie so near that lines of both would be seen as one.
bool is_near(const Aabb& a, const Aabb& b) {
  const float near = 0.01f * std::max(max_norm(a.extent()), max_norm(b.extent()));
  int faces = 0;
  for (int i = 0; i < 3; ++i) {
    faces += (std::fabs(a.lo[i] - b.lo[i]) < near) + (std::fabs(a.hi[i] - b.hi[i]) < near);
  }
  return faces >= 4;
}
bool is_near(const Sphere& a, const Sphere& b) {
  return max_norm(a.center - b.center) + std::fabs(a.radius - b.radius) < 0.02f * a.radius;
}
bool is_near(const Cylinder& a, const Cylinder& b) {
  return max_norm(a.center - b.center) + std::fabs(a.radius - b.radius) + std::fabs(a.half_length - b.half_length) <
         0.02f * (a.radius + a.half_length);
}

}  // namespace

Cell cell_of(const Bound& bound, double padding, std::uint32_t depth) {
  Cell cell;
  std::visit([&](const auto& volume) { cell.region = padded(volume, static_cast<float>(padding)); }, bound);
  cell.depth = static_cast<int>(depth);
  return cell;
}

bool is_same(const Bound& a, const Bound& b) {
  return std::visit(
      [&]<class V>(const V& volume) { return std::holds_alternative<V>(b) && is_equal(volume, std::get<V>(b)); }, a);
}

std::vector<double> paddings(const SceneGraph& graph, const TreeShape& shape, const Snapshot& snapshot,
                             const std::vector<NodeId>& nodes) {
  std::vector<double> steps(shape.depths.size(), 0), drawn(nodes.size(), 0);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const NodeId node = nodes[i];
    drawn[i] = steps[node];
    const NodeId above = graph.parent(node);
    if (above == no_node) continue;
    const Bound& outer = snapshot.bounds[above];
    const bool is_coincident = std::visit(
        [&]<class V>(const V& volume) {
          return std::holds_alternative<V>(outer) && is_near(std::get<V>(outer), volume);
        },
        snapshot.bounds[node]);
    if (is_coincident) steps[above] = std::max(steps[above], steps[node] + 1);
  }
  return drawn;
}

vtkSmartPointer<vtkPolyData> dashed(vtkPolyData& lines, double length) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto pieces = vtkSmartPointer<vtkCellArray>::New();
  const auto piece = [&](const Vec3d& a, const Vec3d& b) {
    const vtkIdType ids[] = {points->InsertNextPoint(a.x, a.y, a.z), points->InsertNextPoint(b.x, b.y, b.z)};
    pieces->InsertNextCell(2, ids);
  };
  vtkCellArray& paths = *lines.GetLines();
  for (vtkIdType path = 0; path < paths.GetNumberOfCells(); ++path) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    paths.GetCellAtId(path, count, ids);
    double gone = 0;  // along the path
    for (vtkIdType i = 0; i + 1 < count; ++i) {
      Vec3d a, b;
      lines.GetPoint(ids[i], &a[0]);
      lines.GetPoint(ids[i + 1], &b[0]);
      const double way = glm::length(b - a);
      if (!(way > 0)) continue;
      const auto most = static_cast<int>(std::min(2000.0, way / (2 * length))) + 2;
      double begin = std::floor(gone / (2 * length)) * 2 * length;
      for (int dash = 0; dash < most; ++dash, begin += 2 * length) {
        const double from = std::max(begin, gone), to = std::min(begin + length, gone + way);
        if (from < to) piece(a + (from - gone) / way * (b - a), a + (to - gone) / way * (b - a));
      }
      gone += way;
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(pieces);
  return data;
}

}  // namespace sightline::viz
