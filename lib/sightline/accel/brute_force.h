#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"

namespace sightline {

struct BruteForceOptions {
  static constexpr std::array<OptionField<BruteForceOptions>, 0> fields() { return {}; }
};

/// No structure at all: every primitive is a candidate of every ray. The oracle that all others are tested against.
class BruteForce {
 public:
  static constexpr std::string_view name = "brute-force";
  static constexpr std::string_view description = "no division: every primitive, every ray; the oracle";
  static constexpr std::size_t node_bytes = 0;
  using Options = BruteForceOptions;

  static BruteForce build(const Primitives& primitives, const Options& = {}) {
    BruteForce all;
    all.order_.resize(primitives.size());
    std::iota(all.order_.begin(), all.order_.end(), 0u);
    return refit(std::move(all), primitives);
  }

  static BruteForce refit(BruteForce all, const Primitives& primitives) {
    all.bounds_ = bounds_of(primitives, all.order_, all.all());
    return all;
  }
  bool can_refit() const { return true; }

  std::size_t memory_bytes() const { return order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
    if (order_.empty() || !is_valid(ray)) return;
    probe.leaf(0, all(), ray.t_min);
    visit(all());
  }

  template <class See>
  void for_each_cell(See&& see) const {
    if (!order_.empty()) see(Cell{bounds_, 0, true, all(), 0});
  }

 private:
  LeafRange all() const { return {0, static_cast<std::uint32_t>(order_.size())}; }

  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

static_assert(Refittable<BruteForce>);
static_assert(Accelerator<BruteForce>);

}  // namespace sightline
