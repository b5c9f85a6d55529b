#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bench/plan.h"

namespace sightline::bench {

/// What was asked for cannot be done: exit 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandLine {
  Plan plan;  ///< Its scenes are empty where none was named.
  std::string json;
  std::vector<std::string> google_flags;  ///< All after "--".
  std::string help;                       ///< To be printed, and nothing else done, when not empty.
};

/// \throws UsageError in one line. Structures and their options are known to be valid afterwards; scenes are not looked
/// at.
CommandLine parse_command_line(int argc, const char* const* argv);

/// Levels that tracing triangles knows, the strictest first. \throws UsageError
std::vector<Level> parse_triangle_levels(const std::vector<std::string>& names);

/// Structures as command lines name them, each once, with --set behind what they say themselves; a quality goes to
/// those that have one. \throws std::invalid_argument, UsageError
std::vector<AcceleratorSpec> parse_structures(const std::vector<std::string>& texts,
                                              const std::vector<std::string>& settings,
                                              const std::string& quality = {});

}  // namespace sightline::bench
