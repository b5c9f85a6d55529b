#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"
#include "sightline/math/level.h"

namespace sightline::bench {

struct RenderPlanOfBench {
  std::vector<std::string> scenes;  ///< Names of render_pictures; all where empty.
  int width = 800, height = 600;
  bool is_quick = false;  ///< Of a quarter of that size.
  int rounds = 201;
  double row_seconds = 60;  ///< A line that would take longer for all its rounds takes part in fewer.
  Level level = Level::watertight;
  bool filters_textures = true;
  bool has_povray = true;
  std::string only;  ///< Renders that line alone, once, and measures nothing: for those who count instructions.
  std::string spoiled;
  std::string json;
};

/// A line of a picture's table.
struct RenderRow {
  std::string name, what;
  std::vector<double> round_seconds, round_elapsed;  ///< NaN where it did not take part.
  std::optional<Estimate> seconds;
  std::optional<Estimate> over_plan;                    ///< This one's time over the plan's, in the same round.
  std::optional<Estimate> povray_over, povray_elapsed;  ///< POV-Ray's time over this one's: processor, wall.
};

struct RenderPictureReport {
  std::string name, description, integrator;
  std::size_t pixels = 0, shadow_rays = 0;
  std::optional<std::size_t> differing_from_povray;  ///< Pixels of another coverage, or more than 1/256 of shade.
  std::vector<RenderRow> rows;
};

struct RenderBenchReport {
  Machine machine;
  RenderPlanOfBench plan;
  std::string povray_version;  ///< Empty without it.
  std::vector<RenderPictureReport> pictures;
};

/// Lines: the plan, the plan once more (what differs there is noise), the renderer stripped by hand,
/// one written anew, the integrator that
/// knows all effects, POV-Ray.
inline constexpr std::string_view plan_line = "plan", again_line = "plan again", stripped_line = "stripped",
                                  anew_line = "written anew", all_line = "all effects", povray_line = "POV-Ray";

/// Verifies, then measures, on one thread. Calls see(report, picture) when one is complete.
/// \throws WrongHits where a line's picture is not that of the plan, bit for bit, or POV-Ray sees something else.
RenderBenchReport run_render(const RenderPlanOfBench& plan, Progress& progress,
                             const std::function<void(const RenderBenchReport&, const RenderPictureReport&)>& see);

/// Of the pictures that it asks for.
std::vector<std::string> names_of(const RenderPlanOfBench& plan);

std::string head_text(const RenderBenchReport& report);
std::string table_text(const RenderBenchReport& report, const RenderPictureReport& picture);
std::string json_text(const RenderBenchReport& report);

/// `sightline-bench render ...`; throws what bench/main.cpp handles.
int run_render_command(int argc, const char* const* argv);

}  // namespace sightline::bench
