#include "bench/peers/vtk.h"

#include <vtkAbstractCellLocator.h>
#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkCellTreeLocator.h>
#include <vtkGenericCell.h>
#include <vtkModifiedBSPTree.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <cmath>

#include "bench/peers/heap.h"

namespace sightline::bench {
namespace {

vtkSmartPointer<vtkAbstractCellLocator> make_locator(VtkLocator locator) {
  switch (locator) {
    case VtkLocator::static_cell:
      return vtkSmartPointer<vtkStaticCellLocator>::New();
    case VtkLocator::cell:
      return vtkSmartPointer<vtkCellLocator>::New();
    case VtkLocator::cell_tree:
      return vtkSmartPointer<vtkCellTreeLocator>::New();
    case VtkLocator::bsp:
      return vtkSmartPointer<vtkModifiedBSPTree>::New();
    case VtkLocator::obb:
      break;
  }
  return vtkSmartPointer<vtkOBBTree>::New();
}

vtkSmartPointer<vtkPolyData> to_vtk(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.positions().size()));
  vtkIdType next = 0;
  for (const Vec3f& p : mesh.positions()) points->SetPoint(next++, p.x, p.y, p.z);
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.size(), 3 * static_cast<vtkIdType>(mesh.size()));
  for (const auto& corners : mesh.triangles()) cells->InsertNextCell({corners[0], corners[1], corners[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->BuildCells();
  return data;
}

class BuiltVtk final : public Built {
 public:
  BuiltVtk(VtkLocator locator, const TriangleMesh& mesh)
      : before_(heap_bytes()), data_(to_vtk(mesh)), locator_(make_locator(locator)) {
    const Vec3d lo(mesh.bounds().lo), hi(mesh.bounds().hi);
    center_ = 0.5 * (lo + hi);
    radius_ = glm::distance(center_, hi);
    locator_->SetDataSet(data_);
    locator_->SetLazyEvaluation(false);  // vtkModifiedBSPTree would leave the building to the first ray
    locator_->BuildLocator();
    bytes_ = heap_bytes() - before_;
  }

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i]);
  }
  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = nearest(rays[i]).is_hit();
  }
  Bytes bytes() const override { return {bytes_, std::nullopt}; }

 private:
  Hit<float> nearest(const Ray<float>& ray) const {
    const Vec3d origin(ray.origin), direction(ray.direction);
    const double t_min = ray.t_min;
    const double t_max = std::isinf(ray.t_max) ? (glm::distance(origin, center_) + 2 * radius_) / glm::length(direction)
                                               : static_cast<double>(ray.t_max);
    const Vec3d from = origin + t_min * direction, to = origin + t_max * direction;
    double share = 0, at[3], weights[3];
    int part = 0;
    vtkIdType id = -1;
    constexpr double tolerance = 0;
    if (!locator_->IntersectWithLine(&from.x, &to.x, tolerance, share, at, weights, part, id, cell_)) return {};
    return {static_cast<float>(t_min + share * (t_max - t_min)), static_cast<std::uint32_t>(id), 0, 0};
  }

  std::size_t before_, bytes_ = 0;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkAbstractCellLocator> locator_;
  vtkNew<vtkGenericCell> cell_;  ///< Scratch of a query.
  Vec3d center_;
  double radius_;
};

class Vtk final : public Contender {
 public:
  explicit Vtk(VtkLocator locator) : locator_(locator) {}

  std::string name() const override {
    switch (locator_) {
      case VtkLocator::static_cell:
        return "vtk-static-cell";
      case VtkLocator::cell:
        return "vtk-cell";
      case VtkLocator::cell_tree:
        return "vtk-cell-tree";
      case VtkLocator::bsp:
        return "vtk-bsp";
      case VtkLocator::obb:
        break;
    }
    return "vtk-obb";
  }
  Kind kind() const override { return Kind::peer; }
  /// Oriented boxes take milliseconds a ray, the others from a few up to some hundred microseconds.
  double tests_per_ray(std::size_t) const override { return locator_ == VtkLocator::obb ? 200'000 : 10'000; }
  std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const override {
    return std::make_unique<BuiltVtk>(locator_, *mesh);
  }

 private:
  VtkLocator locator_;
};

}  // namespace

std::unique_ptr<Contender> make_vtk(VtkLocator locator) { return std::make_unique<Vtk>(locator); }

}  // namespace sightline::bench
