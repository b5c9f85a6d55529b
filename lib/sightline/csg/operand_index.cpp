#include "sightline/csg/operand_index.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "sightline/accel/box_primitives.h"
#include "sightline/accel/registry.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

template <class Structure>
class IndexOf final : public OperandIndex {
 public:
  explicit IndexOf(std::span<const Aabb> boxes)
      : structure_(Structure::build(BoxPrimitives(boxes), costly_primitives<Structure>())) {}

  void find(const Ray<double>& ray, OperandList& found) const override {
    NoProbe probe;
    // Structures look for hits behind t_min; here the range is closed, and may be a point.
    Ray<double> closed = ray;
    closed.t_min = next_down(ray.t_min);
    structure_.traverse(
        closed,
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
