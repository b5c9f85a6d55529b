#include "tests/hard_cases/hard_cases.h"

#include <algorithm>
#include <iterator>

namespace sightline::hard {

std::span<const HardCase> hard_cases() {
  static const std::vector<HardCase> all = [] {
    std::vector<HardCase> cases;
    for (auto* const group :
         {build_cases, solver_cases, sphere_cases, plane_cases, box_cases, cylinder_cases, torus_cases, triangle_cases,
          offset_cases, accelerator_cases, csg_cases, noise_cases, normal_cases, matrix_cases}) {
      std::ranges::move(group(), std::back_inserter(cases));
    }
    return cases;
  }();
  return all;
}

const HardCase* hard_case(std::string_view id) {
  const std::span<const HardCase> all = hard_cases();
  const auto found = std::ranges::find(all, id, &HardCase::id);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace sightline::hard
