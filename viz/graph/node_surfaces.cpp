#include "viz/graph/node_surfaces.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sightline/csg/evaluator.h"
#include "viz/cell_geometry.h"
#include "viz/graph/tree_rows.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr int sides = 64;

struct ProfilePoint {
  double radius, height;
};

/// What a profile sweeps around an axis, `height` along it from `origin`.
New<vtkPolyData> revolved(const Vec3d& origin, const Vec3d& axis, const std::vector<ProfilePoint>& profile) {
  const Vec3d z = glm::normalize(axis), away = std::fabs(z.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d x = glm::normalize(glm::cross(away, z)), y = glm::cross(z, x);
  auto points = New<vtkPoints>::New();
  auto faces = New<vtkCellArray>::New();
  for (const auto& [radius, height] : profile) {
    for (int side = 0; side < sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / sides;
      const Vec3d p = origin + height * z + radius * (std::cos(angle) * x + std::sin(angle) * y);
      points->InsertNextPoint(p.x, p.y, p.z);
    }
  }
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
    const auto first = static_cast<vtkIdType>(ring * sides);
    for (vtkIdType side = 0; side < sides; ++side) {
      const vtkIdType next = (side + 1) % sides;
      const vtkIdType ids[] = {first + side, first + next, first + sides + next, first + sides + side};
      faces->InsertNextCell(4, ids);
    }
  }
  auto surface = New<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(faces);
  return surface;
}

/// An arc around (radius, height), by shares of a whole turn, 0 outward and 0.25 up.
std::vector<ProfilePoint> arc(const ProfilePoint& center, double radius, double from, double to) {
  std::vector<ProfilePoint> points;
  constexpr int steps = sides / 2;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2 * std::numbers::pi * (from + (to - from) * i / steps);
    points.push_back(
        {std::max(0.0, center.radius + radius * std::cos(angle)), center.height + radius * std::sin(angle)});
  }
  return points;
}

struct ShapeSurface {
  New<vtkPolyData> operator()(const solid::Sphere& s) const {
    return revolved(s.center, {0, 1, 0}, arc({0, 0}, s.radius, -0.25, 0.25));
  }
  New<vtkPolyData> operator()(const solid::Box& b) const {
    return cell_surfaces(std::array{Cell{Aabb{Vec3f(b.lo), Vec3f(b.hi)}, 0, true, {}}});
  }
  New<vtkPolyData> operator()(const solid::Cylinder& c) const {
    const double length = glm::length(c.top - c.base);
    return revolved(c.base, c.top - c.base, {{0, 0}, {c.radius, 0}, {c.radius, length}, {0, length}});
  }
  New<vtkPolyData> operator()(const solid::Cone& c) const {
    return revolved(c.base, c.apex - c.base, {{0, 0}, {c.radius, 0}, {0, glm::length(c.apex - c.base)}});
  }
  New<vtkPolyData> operator()(const solid::Torus& t) const {
    return t.minor > t.major ? nullptr : revolved(t.center, t.axis, arc({t.major, 0}, t.minor, 0, 1));
  }
  template <class Shape>
  New<vtkPolyData> operator()(const Shape&) const {
    return nullptr;
  }
};

/// How much of each cell of a grid lies in a solid: the mean over three lines through its middle, along the axes.
class Samples {
 public:
  Samples(const Solid& solid, const Aabb& box) : solid_(solid) {
    const Vec3d size = Vec3d(box.hi) - Vec3d(box.lo);
    step_ = glm::max(size, Vec3d(0x1p-10 * max_norm(size))) / double(count - 4);
    origin_ = 0.5 * (Vec3d(box.lo) + Vec3d(box.hi)) - 0.5 * (count - 1) * step_;
    values_.assign(static_cast<std::size_t>(count) * count * count, 0);
    for (int axis = 0; axis < 3; ++axis) sample_along(axis);
  }

  New<vtkPolyData> surface() const {
    auto values = New<vtkFloatArray>::New();
    values->SetNumberOfTuples(static_cast<vtkIdType>(values_.size()));
    std::copy(values_.begin(), values_.end(), values->GetPointer(0));
    auto image = New<vtkImageData>::New();
    image->SetDimensions(count, count, count);
    image->SetSpacing(step_.x, step_.y, step_.z);
    image->SetOrigin(origin_.x, origin_.y, origin_.z);
    image->GetPointData()->SetScalars(values);
    auto surface = New<vtkFlyingEdges3D>::New();
    surface->SetInputData(image);
    surface->SetValue(0, 0.5);
    surface->ComputeNormalsOff();
    surface->ComputeScalarsOff();
    surface->Update();
    return surface->GetOutput();
  }

 private:
  static constexpr int count = 68;

  std::size_t at(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * count + static_cast<std::size_t>(cell[1])) * count +
           static_cast<std::size_t>(cell[0]);
  }

  void sample_along(int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < count; ++k) {
        Ray<double> ray{origin_, Vec3d(0)};
        ray.origin[u] += i * step_[u], ray.origin[v] += k * step_[v];
        ray.direction[axis] = step_[axis];  // so that t counts cells
        NoSolidProbe probe;
        SolidEvaluator<Level::watertight> evaluator(solid_, ray, probe);
        const SpanList list = evaluator.spans();
        for_each_span(evaluator[list], list.begins_inside, [&](double lo, double hi, const Boundary*, const Boundary*) {
          const double first = std::clamp(lo, 0.0, double(count - 1)), last = std::clamp(hi, 0.0, double(count - 1));
          for (int cell = static_cast<int>(std::lround(first)); cell <= static_cast<int>(std::lround(last)); ++cell) {
            const double share = std::min(hi, cell + 0.5) - std::max(lo, cell - 0.5);
            std::array<int, 3> place{};
            place[static_cast<std::size_t>(axis)] = cell;
            place[static_cast<std::size_t>(u)] = i, place[static_cast<std::size_t>(v)] = k;
            values_[at(place)] += static_cast<float>(std::max(0.0, share) / 3);
          }
        });
      }
    }
  }

  const Solid& solid_;
  Vec3d step_, origin_;
  std::vector<float> values_;
};

void place_in_frame(vtkPolyData& surface, const Frame& frame) {
  const Transform place = Transform::of(frame).inverted();
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    Vec3d p;
    surface.GetPoint(i, &p[0]);
    p = place.point(p);
    surface.GetPoints()->SetPoint(i, &p[0]);
  }
}

vtkSmartPointer<vtkPolyData> surface_of(const Geometry& geometry) {
  if (const auto* tree = std::get_if<SolidTree>(&geometry.shape)) return solid_surface(*tree);
  const auto& mesh = std::get<MeshGeometry>(geometry.shape).mesh;
  return mesh && mesh->size() > 0 ? mesh_surface(*mesh) : nullptr;
}

}  // namespace

vtkSmartPointer<vtkPolyData> solid_surface(const SolidTree& tree) {
  if (tree.kind == SolidTree::Kind::primitive) {
    if (auto surface = std::visit(ShapeSurface(), tree.shape)) {
      if (!(tree.frame == Frame())) place_in_frame(*surface, tree.frame);
      return surface;
    }
  }
  const Solid solid(tree);
  if (!solid.is_bounded() || solid.bounds().is_empty()) return nullptr;
  return Samples(solid, solid.bounds()).surface();
}

NodeSurfaces::NodeSurfaces(const Scene& scene) : graph_(scene.graph), colors_(scene.graph.size()), is_shown_(scene.graph.size()) {
  std::vector<bool> is_used(scene.geometries.size(), false);
  for (NodeId node = 0; node < graph_.size(); ++node) {
    if (graph_.geometry(node) != no_item) is_used[graph_.geometry(node)] = true;
  }
  for (std::size_t i = 0; i < scene.geometries.size(); ++i) {
    mappers_.emplace_back();
    if (!is_used[i]) continue;
    const auto surface = surface_of(scene.geometries[i]);
    if (!surface) {
      if (std::holds_alternative<SolidTree>(scene.geometries[i].shape)) ++endless_;
      continue;
    }
    auto normals = New<vtkPolyDataNormals>::New();
    normals->SetInputData(surface);
    normals->SetFeatureAngle(50);
    normals->ConsistencyOff();
    normals->Update();
    mappers_.back() = New<vtkPolyDataMapper>::New();
    mappers_.back()->SetInputData(normals->GetOutput());
    mappers_.back()->ScalarVisibilityOff();
  }
  constexpr Rgb gray{0.84, 0.83, 0.81};
  for (const NodeId node : TreeShape(graph_).order) {
    is_shown_[node] = graph_.is_visible(node) && (node == root_node || is_shown_[graph_.parent(node)]);
    const std::uint32_t material = graph_.material(node);
    colors_[node] = node == root_node ? gray : colors_[graph_.parent(node)];
    if (material >= scene.materials.size()) continue;
    const Color& color = scene.materials[material].color;
    for (int i = 0; i < 3; ++i) colors_[node][static_cast<std::size_t>(i)] = srgb_from_linear(color[i]);
  }
}

vtkPolyDataMapper* NodeSurfaces::mapper(NodeId node) const {
  const std::uint32_t geometry = graph_.geometry(node);
  return geometry == no_item || !is_shown_[node] ? nullptr : mappers_[geometry].Get();
}

}  // namespace sightline::viz
