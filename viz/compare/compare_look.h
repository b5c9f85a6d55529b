#pragma once
/// What a comparison shows and from where, and the command line that shows the same again.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/compare/comparison.h"

namespace sightline::viz {

enum class CompareKind : std::uint8_t { walk, work, difference, histogram };
inline constexpr std::array compare_kinds{CompareKind::walk, CompareKind::work, CompareKind::difference,
                                          CompareKind::histogram};
std::string_view name_of(CompareKind kind);

/// The state of a comparison that hands can change.
struct CompareLook {
  CompareKind kind = CompareKind::walk;
  WorkKind work = WorkKind::all;
  std::size_t against = 0;           ///< The structure that others are subtracted from.
  std::optional<std::size_t> alone;  ///< Only this one, large.
  double azimuth = 24, elevation = 20, zoom = 1;
  Ray<float> ray;

  friend bool operator==(const CompareLook& a, const CompareLook& b);
};

/// What of a command line stays as it was asked for.
struct CompareSource {
  std::string accelerators, scene;
  std::vector<std::string> labels;    ///< One a structure.
  std::vector<std::string> settings;  ///< --set
  std::vector<std::string> common;    ///< Further words, such as --data and its folder.
  std::string name = "compare";       ///< The subcommand's; heat shows the work of one structure.
};

/// Quoted for a shell where that is needed.
std::string command_line(const CompareSource& source, const CompareLook& look, int width, int height);

}  // namespace sightline::viz
