#pragma once

#include <string>
#include <string_view>

namespace sightline::bench {

/// What stands before the options, and what stands after them.
std::string_view introduction();
std::string_view reading();

/// Workloads, scenes, structures with their options, and peers.
std::string catalogue();

}  // namespace sightline::bench
