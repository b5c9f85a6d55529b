#include "sightline/csg/operand_index.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "sightline/accel/primitives.h"
#include "sightline/accel/registry.h"

namespace sightline {
namespace {

/// Boxes as primitives.
class Boxes final : public Primitives {
 public:
  explicit Boxes(std::span<const Aabb> boxes) : boxes_(boxes) {}

  std::uint32_t size() const override { return static_cast<std::uint32_t>(boxes_.size()); }
  Aabb bounds(std::uint32_t id) const override { return boxes_[id]; }
  Aabb clip(std::uint32_t id, const Aabb& box) const override {
    const Aabb clipped = intersection(boxes_[id], box);
    return clipped.is_empty() ? Aabb{} : clipped;
  }
  Hull hull(std::uint32_t id) const override { return hull_of(boxes_[id]); }
  CandidatePlanes planes(std::uint32_t id) const override { return faces_of(boxes_[id]); }

 private:
  std::span<const Aabb> boxes_;
};

/// Testing an operand takes longer than a node.
template <class Structure>
typename Structure::Options small_leaves() {
  typename Structure::Options options;
  if constexpr (requires { options.max_leaf_size; }) options.max_leaf_size = 1;
  return options;
}

template <class Structure>
class IndexOf final : public OperandIndex {
 public:
  explicit IndexOf(std::span<const Aabb> boxes)
      : structure_(Structure::build(Boxes(boxes), small_leaves<Structure>())) {}

  void find(const Ray<double>& ray, OperandList& found) const override {
    NoProbe probe;
    structure_.traverse(
        ray,
        [&](LeafRange leaf) {
          for (const std::uint32_t id : structure_.leaf_order().subspan(leaf.first, leaf.count)) found.push(id);
          return ray.t_max;
        },
        probe);
  }

 private:
  Structure structure_;
};

}  // namespace

std::shared_ptr<const OperandIndex> make_operand_index(std::string_view accelerator, std::span<const Aabb> boxes) {
  std::shared_ptr<const OperandIndex> index;
  std::string names;
  Accelerators::for_each([&]<class Structure>(auto) {
    names += (names.empty() ? "" : ", ") + std::string(Structure::name);
    if (Structure::name == accelerator) index = std::make_shared<IndexOf<Structure>>(boxes);
  });
  if (!index) {
    throw std::invalid_argument("unknown accelerator '" + std::string(accelerator) + "'; expected one of " + names);
  }
  return index;
}

}  // namespace sightline
