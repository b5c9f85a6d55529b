#pragma once
/// Offers a student's structure, whichever satisfies the contract, to the checks.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "labs/kit/service.h"
#include "labs/kit/structure_questions.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"
#include "sightline/shape/mesh.h"

namespace sightline::labs {

/// Triangles with corners of their own, in the order of their ids.
inline TriangleMesh mesh_of(const std::vector<Triangle>& triangles) {
  std::vector<Vec3f> corners;
  std::vector<TriangleMesh::Corners> ids;
  for (const Triangle& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), {triangle.a, triangle.b, triangle.c});
    ids.push_back({first, first + 1, first + 2});
  }
  return {std::move(corners), std::move(ids)};
}

/// The structure that was built last.
template <Accelerator A>
class StructureService {
 public:
  StructureFacts build(const std::vector<Triangle>& triangles, const std::vector<WantedOption>& wanted) {
    typename A::Options options;
    for (const WantedOption& want : wanted) {
      const auto fields = A::Options::fields();
      const bool has_field =
          std::any_of(fields.begin(), fields.end(), [&](const auto& f) { return f.name == want.name; });
      if (has_field) set_option(A::name, options, want.name, want.value);
    }
    built_.reset();
    mesh_ = mesh_of(triangles);
    built_ = std::make_unique<A>(A::build(PrimitivesOf(mesh_), options));
    const auto order = built_->leaf_order();
    return {std::string(A::name), built_->memory_bytes(), {order.begin(), order.end()}};
  }

  std::vector<Cell> cells() const {
    std::vector<Cell> list;
    accel().for_each_cell([&](const Cell& cell) { list.push_back(cell); });
    return list;
  }

  template <class T>
  TracedRays<T> trace(const std::vector<Ray<T>>& rays) const {
    TracedRays<T> traced;
    for (const Ray<T>& ray : rays) {
      traced.hits.push_back(closest_hit(accel(), leaves(), ray, traced.stats));
      NoProbe silent;
      traced.is_hit.push_back(any_hit(accel(), leaves(), ray, silent));
    }
    return traced;
  }

  RecordedWalk record(const Ray<float>& ray) const {
    WalkRecorder recorder;
    const Hit<float> hit = closest_hit(accel(), leaves(), ray, recorder);
    return {hit, std::move(recorder.steps)};
  }

 private:
  const A& accel() const {
    if (!built_) throw std::logic_error("nothing is built");
    return *built_;
  }
  /// A structure that gives out positions beyond its order would read anything at all: it is told instead.
  struct GuardedLeaves {
    IndexedLeaves<TriangleMesh> leaves;
    std::size_t positions;

    template <class T>
    auto prepare(const Ray<T>& ray) const {
      return leaves.prepare(ray);
    }
    template <class Prepared, class T, class See>
    void for_each_crossing(Prepared& ray, LeafRange leaf, T far, See&& see) const {
      if (std::uint64_t(leaf.first) + leaf.count > positions) {
        throw std::out_of_range("a leaf holds positions " + std::to_string(leaf.first) + " to " +
                                std::to_string(std::uint64_t(leaf.first) + leaf.count) + " of an order of " +
                                std::to_string(positions));
      }
      leaves.for_each_crossing(ray, leaf, far, see);
    }
  };
  GuardedLeaves leaves() const { return {{mesh_, accel().leaf_order()}, accel().leaf_order().size()}; }

  TriangleMesh mesh_;
  std::unique_ptr<A> built_;
};

template <Accelerator A>
void offer_structure(Service& service) {
  const auto structure = std::make_shared<StructureService<A>>();
  service.on("build", [=](const std::vector<Triangle>& triangles, const std::vector<WantedOption>& wanted) {
    return structure->build(triangles, wanted);
  });
  service.on("cells", [=] { return structure->cells(); });
  service.on("trace", [=](const std::vector<Ray<float>>& rays) { return structure->trace(rays); });
  service.on("trace-double", [=](const std::vector<Ray<double>>& rays) { return structure->trace(rays); });
  service.on("record", [=](const Ray<float>& ray) { return structure->record(ray); });
}

}  // namespace sightline::labs
