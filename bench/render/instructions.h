#pragma once
/// Instructions that rendering a picture takes, as valgrind counts them: a figure that does not depend on how fast the
/// machine is, or on what else it does.

#include <functional>
#include <string>
#include <vector>

#include "bench/render/run.h"

namespace sightline::bench {

/// Calls paint. Callgrind counts what runs within, by this function's name.
void paint_once(const std::function<void()>& paint);

struct InstructionCounts {
  std::string picture;
  std::size_t plan = 0, stripped = 0, all_effects = 0;
};

struct InstructionReport {
  Machine machine;
  RenderPlanOfBench plan;
  std::vector<InstructionCounts> pictures;
};

/// Runs this program under callgrind, once a line, as `plan` says of scenes, sizes, level and textures.
/// \throws std::runtime_error in one line where valgrind is missing, where this build has instructions that valgrind
/// does not know, and where it fails.
InstructionReport count_instructions(const RenderPlanOfBench& plan, Progress& progress);

std::string text_of(const InstructionReport& report);
std::string json_text(const InstructionReport& report);

/// The number behind "totals:" in what callgrind writes. \throws std::runtime_error where there is none above 0.
std::size_t total_of(const std::string& callgrind);

}  // namespace sightline::bench
