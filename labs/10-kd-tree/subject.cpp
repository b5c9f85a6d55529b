#include "kd_tree.h"
#include "labs/kit/structure_service.h"

void sightline::labs::offer(Service& service) {
  service.on("split-cost", [](const Aabb& cell, int axis, float split, std::uint32_t below, std::uint32_t above) {
    return student::split_cost(cell, axis, split, below, above, {});
  });
  service.on("sides", [](float lo, float hi, float split) {
    const student::Sides sides = student::sides_of(lo, hi, split);
    return static_cast<std::uint8_t>((sides.is_below ? 1 : 0) | (sides.is_above ? 2 : 0));
  });
  offer_structure<student::KdTree>(service);
}
