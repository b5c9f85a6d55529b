#include "viz/cell_geometry.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace sightline::viz {
namespace {

constexpr std::size_t many_cells = 400;  // above, round regions get half the facets

/// Gathers polygons or lines and what is known of their cells.
class Builder {
 public:
  Builder() {
    points_->SetDataTypeToFloat();
    const char* names[] = {"depth", "leaf", "candidates", "node"};
    for (std::size_t i = 0; i < arrays_.size(); ++i) arrays_[i]->SetName(names[i]);
  }

  vtkIdType point(const Vec3d& p) { return points_->InsertNextPoint(p.x, p.y, p.z); }

  void part(const Cell& cell, const std::vector<vtkIdType>& corners) {
    parts_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    arrays_[0]->InsertNextValue(static_cast<std::uint32_t>(cell.depth));
    arrays_[1]->InsertNextValue(cell.is_leaf);
    arrays_[2]->InsertNextValue(cell.range.count);
    arrays_[3]->InsertNextValue(cell.node);
  }

  /// The polyline through `path`.
  void line(const Cell& cell, std::span<const Vec3d> path) {
    std::vector<vtkIdType> corners;
    for (const Vec3d& p : path) corners.push_back(point(p));
    part(cell, corners);
  }

  vtkSmartPointer<vtkPolyData> polygons() { return finish(true); }
  vtkSmartPointer<vtkPolyData> lines() { return finish(false); }

 private:
  vtkSmartPointer<vtkPolyData> finish(bool are_polygons) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    if (are_polygons) {
      data->SetPolys(parts_);
    } else {
      data->SetLines(parts_);
    }
    for (const auto& array : arrays_) data->GetCellData()->AddArray(array);
    return data;
  }

  template <class T>
  using New = vtkSmartPointer<T>;
  New<vtkPoints> points_ = New<vtkPoints>::New();
  New<vtkCellArray> parts_ = New<vtkCellArray>::New();
  std::array<New<vtkUnsignedIntArray>, 4> arrays_{New<vtkUnsignedIntArray>::New(), New<vtkUnsignedIntArray>::New(),
                                                  New<vtkUnsignedIntArray>::New(), New<vtkUnsignedIntArray>::New()};
};

/// Two unit vectors at right angles to a unit `axis` and to each other, right-handed with it.
std::pair<Vec3d, Vec3d> frame_around(const Vec3d& axis) {
  const Vec3d away = std::fabs(axis.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d x = glm::normalize(glm::cross(away, axis));
  return {x, glm::cross(axis, x)};
}

/// `count` points counter-clockwise around `axis`, the first one not repeated.
std::vector<Vec3d> circle(const Vec3d& center, const Vec3d& axis, double radius, int count) {
  const auto [x, y] = frame_around(axis);
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

std::vector<Vec3d> closed(std::vector<Vec3d> path) {
  path.push_back(path.front());
  return path;
}

/// Quads between one ring of `count` vertices and the next, both counter-clockwise seen from above.
void join_rings(Polyhedron& solid, std::uint32_t lower, std::uint32_t upper, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    solid.faces.push_back({lower + i, lower + next, upper + next, upper + i});
  }
}

Polyhedron solid_of(const Aabb& box, int) {
  const Hull corners = hull_of(box);
  Polyhedron solid;
  for (const Vec3f& p : corners.points) solid.vertices.push_back(Vec3d(p));
  solid.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return solid;
}

Polyhedron solid_of(const Cylinder& cylinder, int facets) {
  Polyhedron solid;
  const auto count = static_cast<std::uint32_t>(facets);
  const Vec3d axis = glm::normalize(Vec3d(cylinder.axis));
  for (const double end : {-1.0, 1.0}) {
    const Vec3d center = Vec3d(cylinder.center) + end * double(cylinder.half_length) * axis;
    for (const Vec3d& p : circle(center, axis, cylinder.radius, facets)) solid.vertices.push_back(p);
  }
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < count; ++i) {
    bottom.push_back(count - 1 - i);
    top.push_back(count + i);
  }
  solid.faces = {bottom, top};
  join_rings(solid, 0, count, count);
  return solid;
}

Polyhedron solid_of(const Sphere& sphere, int facets) {
  Polyhedron solid;
  const Vec3d center(sphere.center);
  const int rings = facets / 2 - 1;
  const auto count = static_cast<std::uint32_t>(facets);
  for (int ring = 1; ring <= rings; ++ring) {
    const double angle = std::numbers::pi * ring / (rings + 1);
    const Vec3d middle = center - Vec3d(0, 0, sphere.radius * std::cos(angle));
    for (const Vec3d& p : circle(middle, {0, 0, 1}, sphere.radius * std::sin(angle), facets)) {
      solid.vertices.push_back(p);
    }
  }
  const auto south = static_cast<std::uint32_t>(solid.vertices.size()), north = south + 1;
  solid.vertices.push_back(center - Vec3d(0, 0, sphere.radius));
  solid.vertices.push_back(center + Vec3d(0, 0, sphere.radius));
  const std::uint32_t last = count * static_cast<std::uint32_t>(rings - 1);
  for (std::uint32_t ring = 0; ring < last; ring += count) join_rings(solid, ring, ring + count, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    solid.faces.push_back({south, next, i});
    solid.faces.push_back({north, last + i, last + next});
  }
  return solid;
}

const Polyhedron& solid_of(const Polyhedron& solid, int) { return solid; }

int facets_for(std::size_t cells) { return cells > many_cells ? 24 : 48; }

template <class Region>
void outline(Builder& builder, const Cell& cell, const Region& region, int facets,
             const std::optional<Vec3d>& eye_direction) {
  if constexpr (std::is_same_v<Region, Sphere>) {
    if (eye_direction) {
      builder.line(cell, closed(circle(Vec3d(region.center), *eye_direction, region.radius, facets)));
      return;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d around(0);
      around[axis] = 1;
      builder.line(cell, closed(circle(Vec3d(region.center), around, region.radius, facets)));
    }
  } else if constexpr (std::is_same_v<Region, Cylinder>) {
    const Vec3d axis = glm::normalize(Vec3d(region.axis)), half = axis * double(region.half_length);
    const auto low = circle(Vec3d(region.center) - half, axis, region.radius, facets);
    const auto high = circle(Vec3d(region.center) + half, axis, region.radius, facets);
    builder.line(cell, closed(low));
    builder.line(cell, closed(high));
    for (int side = 0; side < 4; ++side) {
      const auto i = static_cast<std::size_t>(side * facets / 4);
      builder.line(cell, std::array{low[i], high[i]});
    }
  } else {
    const auto& solid = solid_of(region, facets);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& face : solid.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        edges.insert(std::minmax({face[i], face[(i + 1) % face.size()]}));
      }
    }
    for (const auto& [a, b] : edges) builder.line(cell, std::array{solid.vertices[a], solid.vertices[b]});
  }
}

/// Corners of the convex polygon in which the plane cuts the solid, in order; fewer than three where it only touches.
std::vector<Vec3d> section(const Polyhedron& solid, int axis, double position) {
  std::vector<Vec3d> corners;
  for (const auto& face : solid.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      Vec3d p = solid.vertices[face[i]], q = solid.vertices[face[(i + 1) % face.size()]];
      if (p[axis] > q[axis]) std::swap(p, q);  // so that the other face of this edge gives the very same corner
      const double from = p[axis] - position, to = q[axis] - position;
      if ((from < 0) == (to < 0)) continue;
      Vec3d corner = p + (from / (from - to)) * (q - p);
      corner[axis] = position;
      corners.push_back(corner);
    }
  }
  Vec3d middle(0);
  for (const Vec3d& p : corners) middle += p / double(corners.size());
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::sort(corners.begin(), corners.end(), [&](const Vec3d& a, const Vec3d& b) {
    return std::atan2(a[v] - middle[v], a[u] - middle[u]) < std::atan2(b[v] - middle[v], b[u] - middle[u]);
  });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

vtkSmartPointer<vtkPolyData> cell_surfaces(std::span<const Cell> cells) {
  Builder builder;
  for (const Cell& cell : cells) {
    std::visit(
        [&](const auto& region) {
          const auto& solid = solid_of(region, facets_for(cells.size()));
          std::vector<vtkIdType> ids;
          for (const Vec3d& p : solid.vertices) ids.push_back(builder.point(p));
          for (const auto& face : solid.faces) {
            std::vector<vtkIdType> corners;
            for (const std::uint32_t corner : face) corners.push_back(ids[corner]);
            builder.part(cell, corners);
          }
        },
        cell.region);
  }
  return builder.polygons();
}

vtkSmartPointer<vtkPolyData> cell_outlines(std::span<const Cell> cells, const std::optional<Vec3d>& eye_direction) {
  Builder builder;
  const int facets = facets_for(cells.size());
  for (const Cell& cell : cells) {
    std::visit([&](const auto& region) { outline(builder, cell, region, facets, eye_direction); }, cell.region);
  }
  return builder.lines();
}

Sections cell_sections(std::span<const Cell> cells, int axis, double position) {
  Builder polygons, outlines;
  for (const Cell& cell : cells) {
    const auto corners = std::visit(
        [&](const auto& region) { return section(solid_of(region, facets_for(cells.size())), axis, position); },
        cell.region);
    if (corners.size() < 3) continue;
    polygons.line(cell, corners);
    outlines.line(cell, closed(corners));
  }
  return {polygons.polygons(), outlines.lines()};
}

std::vector<Vec3d> points_of(vtkPolyData& data) {
  std::vector<Vec3d> points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i) data.GetPoint(static_cast<vtkIdType>(i), &points[i][0]);
  return points;
}

vtkSmartPointer<vtkPolyData> mesh_surface(const TriangleMesh& mesh) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.positions().size()));
  for (std::size_t i = 0; i < mesh.positions().size(); ++i) {
    points->SetPoint(static_cast<vtkIdType>(i), &mesh.positions()[i][0]);
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  std::set<TriangleMesh::Corners> drawn;
  for (const TriangleMesh::Corners& corners : mesh.triangles()) {
    TriangleMesh::Corners sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (!drawn.insert(sorted).second) continue;
    const vtkIdType ids[] = {corners[0], corners[1], corners[2]};
    triangles->InsertNextCell(3, ids);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

}  // namespace sightline::viz
