#pragma once
/// The one implementation of Tracer, over any structure.

#include <tbb/task_arena.h>

#include <cassert>
#include <optional>
#include <type_traits>
#include <utility>

#include "sightline/query/placed_query.h"
#include "sightline/query/primitives_of.h"
#include "sightline/query/queries.h"
#include "sightline/query/stream.h"
#include "sightline/query/tracer.h"

namespace sightline::detail {

/// Queries<float> and Queries<double> over Derived::with_leaves, one T at a time.
template <class Derived, class T, class Base>
class QueriesOf : public Base {
 public:
  void closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, Level level) const override {
    NoProbe probe;
    closest(rays, hits, probe, level);
  }
  void closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, TraversalStats& stats,
                    Level level) const override {
    closest(rays, hits, stats, level);
  }
  void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Level level) const override {
    NoProbe probe;
    any(rays, is_hit, probe, level);
  }
  void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, TraversalStats& stats,
                Level level) const override {
    any(rays, is_hit, stats, level);
  }
  void stream_closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, Level level) const override {
    assert(rays.size() == hits.size());
    self().template with_leaves<T>(level, [&](const auto& accel, const auto& leaves) {
      if constexpr (can_stream<decltype(accel), decltype(leaves)>) {
        sightline::closest_hits(accel, leaves, rays, hits);
      } else {
        closest_hits(rays, hits, level);
      }
    });
  }
  void stream_any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Level level) const override {
    assert(rays.size() == is_hit.size());
    self().template with_leaves<T>(level, [&](const auto& accel, const auto& leaves) {
      if constexpr (can_stream<decltype(accel), decltype(leaves)>) {
        sightline::any_hits(accel, leaves, rays, is_hit);
      } else {
        any_hits(rays, is_hit, level);
      }
    });
  }
  std::vector<Hit<T>> all_hits(const Ray<T>& ray) const override {
    NoProbe probe;
    return sightline::all_hits(self().accel(), self().indexed_leaves(), ray, probe);
  }
  Hit<T> record(const Ray<T>& ray, WalkRecorder& walk) const override {
    return closest_hit(self().accel(), self().indexed_leaves(), ray, walk);
  }
  void visit(PlacedQuery<T>& query, std::uint32_t instance, Level level) const override {
    NoProbe probe;
    self().visit_placed(query, instance, level, probe);
  }
  void visit(PlacedQuery<T>& query, std::uint32_t instance, Level level, TraversalStats& stats) const override {
    self().visit_placed(query, instance, level, stats);
  }

 private:
  template <class Accel, class Leaves>
  static constexpr bool can_stream =
      Steppable<std::remove_cvref_t<Accel>, T>&& FetchingLeaves<std::remove_cvref_t<Leaves>>;

  const Derived& self() const { return static_cast<const Derived&>(*this); }

  template <class Probe>
  void closest(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, Probe& probe, Level level) const {
    assert(rays.size() == hits.size());
    self().template with_leaves<T>(level, [&](const auto& accel, const auto& leaves) {
      for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest_hit(accel, leaves, rays[i], probe);
    });
  }
  template <class Probe>
  void any(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Probe& probe, Level level) const {
    assert(rays.size() == is_hit.size());
    self().template with_leaves<T>(level, [&](const auto& accel, const auto& leaves) {
      for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = any_hit(accel, leaves, rays[i], probe);
    });
  }
};

template <Accelerator A>
class TracerOf final : public QueriesOf<TracerOf<A>, double, QueriesOf<TracerOf<A>, float, Tracer>> {
 public:
  TracerOf(std::shared_ptr<const TriangleMesh> mesh, A accel, bool pack_leaves)
      : mesh_(std::move(mesh)), accel_(std::move(accel)) {
    if (pack_leaves && accel_.is_order_final()) blocks_.emplace(*mesh_, accel_);
  }

  std::string_view name() const override { return A::name; }
  const TriangleMesh& mesh() const override { return *mesh_; }
  std::size_t structure_bytes() const override { return accel_.memory_bytes(); }
  std::size_t leaf_bytes() const override { return blocks_ ? blocks_->memory_bytes() : 0; }
  std::span<const std::uint32_t> leaf_order() const override { return accel_.leaf_order(); }
  bool is_lazy() const override { return !accel_.is_order_final(); }
  void for_each_cell(const std::function<void(const Cell&)>& see) const override { accel_.for_each_cell(see); }

  const A& accel() const { return accel_; }
  IndexedLeaves<TriangleMesh> indexed_leaves() const { return {*mesh_, accel_.leaf_order()}; }

  /// Calls use(structure, leaves) with the leaves that rays of T are tested with.
  template <class T, class Use>
  void with_leaves(Level level, Use&& use) const {
    if constexpr (std::is_same_v<T, double>) {
      if (level == Level::exact) return use(accel_, ExactLeaves(*mesh_, accel_.leaf_order()));
    }
    if (!blocks_) return use(accel_, indexed_leaves());
    if constexpr (std::is_same_v<T, float>) {
      if (level == Level::fast) return use(accel_, packed_leaves<Level::fast>());
    }
    use(accel_, packed_leaves<Level::watertight>());
  }

  template <class T, class Probe>
  void visit_placed(PlacedQuery<T>& query, std::uint32_t instance, Level level, Probe& probe) const {
    const TriangleBlocks* blocks = blocks_ ? &*blocks_ : nullptr;
    if constexpr (std::is_same_v<T, float>) {
      if (level == Level::fast) return query.template visit<Level::fast>(instance, accel_, *mesh_, blocks, probe);
    }
    query.template visit<Level::watertight>(instance, accel_, *mesh_, blocks, probe);
  }

 private:
  template <Level level>
  PackedLeaves<level> packed_leaves() const {
    return {*mesh_, *blocks_};
  }

  std::shared_ptr<const TriangleMesh> mesh_;
  A accel_;
  std::optional<TriangleBlocks> blocks_;  ///< Copies of the triangles, where the order is final and memory allows.
};

template <Accelerator A>
std::unique_ptr<Tracer> make_tracer_of(std::shared_ptr<const TriangleMesh> mesh, const TracerSettings& settings) {
  typename A::Options options;
  for (const auto& [name, value] : settings.options) set_option(A::name, options, name, value);
  const PrimitivesOf primitives(*mesh);
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  return arena.execute(
      [&] { return std::make_unique<TracerOf<A>>(mesh, A::build(primitives, options), settings.pack_leaves); });
}

}  // namespace sightline::detail
