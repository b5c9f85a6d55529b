#pragma once
/// Every structure, in the order in which they are shown. Adding one is its file and its line here: tests, benchmarks,
/// drawing and help follow this list.

#include "sightline/accel/brute_force.h"
#include "sightline/accel/type_list.h"

namespace sightline {

using Accelerators = TypeList<BruteForce>;

}  // namespace sightline
