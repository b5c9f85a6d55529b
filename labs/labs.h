#pragma once
/// The labs, in order. Adding one is its folder and its line here.

#include <vector>

#include "labs/check/check.h"

namespace sightline::labs {

Lab first_picture_lab();
Lab perlin_noise_lab();
Lab volumetric_texture_lab();
Lab normal_mapping_lab();
Lab csg_lab();
Lab matrix_stack_lab();
Lab kd_tree_lab();
Lab hard_cases_lab();

inline std::vector<Lab> make_labs() {
  return {first_picture_lab(), perlin_noise_lab(), volumetric_texture_lab(), normal_mapping_lab(), csg_lab(),
          matrix_stack_lab(),  kd_tree_lab(),      hard_cases_lab()};
}

}  // namespace sightline::labs
