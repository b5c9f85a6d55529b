#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"
#include "sightline/math/level.h"

namespace sightline::bench {

inline constexpr std::string_view ferrari_name = "Ferrari";

struct TorusPlan {
  std::vector<double> minors{0.5, 0.005};  ///< Radii of the tube, as shares of the ring's.
  std::vector<Level> levels{Level::fast, Level::watertight, Level::precise, Level::exact};
  std::size_t rays = 20'000;
  int rounds = 21;
  std::string spoiled;  ///< The name of a line that is made to lose a root on purpose; usually empty.
  std::string json;
};

/// A line of a table: a level, or the closed form.
struct TorusRow {
  std::string name;
  std::size_t wrong_counts = 0;  ///< Rays with another number of real roots than they truly have.
  /// The largest error among rays with as many roots as they have: of a point, in radii of the ring.
  double worst_error = 0;
  std::vector<double> round_seconds;  ///< Of all rays, once in each round.
  Estimate seconds;
  Estimate ratio;  ///< Of this one's time over the closed form's, in the same round.
};

/// A torus and a set of rays.
struct TorusReportPart {
  double minor = 0;
  std::string name, description;
  std::size_t rays = 0, roots = 0;
  std::vector<TorusRow> rows;  ///< The closed form first.
};

struct TorusReport {
  Machine machine;
  TorusPlan plan;
  std::vector<TorusReportPart> parts;
};

/// Verifies, then measures. Calls see(report, part) when a part is complete.
/// \throws WrongHits where a level that proves its roots has others than the ray truly has.
TorusReport run_torus(const TorusPlan& plan, Progress& progress,
                      const std::function<void(const TorusReport&, const TorusReportPart&)>& see);

std::string head_text(const TorusReport& report);
std::string table_text(const TorusReportPart& part);
std::string json_text(const TorusReport& report);

/// `sightline-bench torus ...`; throws what bench/main.cpp handles.
int run_torus_command(int argc, const char* const* argv);

}  // namespace sightline::bench
