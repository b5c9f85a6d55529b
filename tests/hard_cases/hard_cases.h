#pragma once
/// The table of all hard cases.

#include <span>
#include <string_view>
#include <vector>

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

// Each in its file, GROUP_cases.cpp.
std::vector<HardCase> build_cases();
std::vector<HardCase> solver_cases();
std::vector<HardCase> sphere_cases();
std::vector<HardCase> plane_cases();
std::vector<HardCase> box_cases();
std::vector<HardCase> cylinder_cases();
std::vector<HardCase> torus_cases();
std::vector<HardCase> triangle_cases();
std::vector<HardCase> offset_cases();
std::vector<HardCase> accelerator_cases();
std::vector<HardCase> csg_cases();
std::vector<HardCase> noise_cases();
std::vector<HardCase> normal_cases();
std::vector<HardCase> matrix_cases();

/// In the catalogue's order.
std::span<const HardCase> hard_cases();

/// Null where there is none of that id.
const HardCase* hard_case(std::string_view id);

}  // namespace sightline::hard
