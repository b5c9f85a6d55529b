#pragma once
/// What the command lines of `solids` and `torus` share.

#include <string>
#include <vector>

#include "sightline/math/level.h"

namespace sightline::bench {

/// Each once, in the order given. \throws UsageError
std::vector<Level> parse_levels(const std::vector<std::string>& names);

/// \throws UsageError where `name` is not `known`; `what` says of what it is one.
void require_known(const std::string& what, const std::string& name, const std::vector<std::string>& known);

/// On standard output, at once. \throws std::runtime_error
void print(const std::string& text);

}  // namespace sightline::bench
