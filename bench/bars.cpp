#include "bench/bars.h"

#include <algorithm>
#include <cmath>

#include "bench/peers/peers.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

/// Bounce rays, of which every one goes its own way; otherwise the first kind that there is.
std::optional<Workload> shown_workload(const Plan& plan) {
  if (plan.has(Workload::bounce)) return Workload::bounce;
  for (const Workload workload : plan.workloads) {
    if (workload != Workload::build) return workload;
  }
  return std::nullopt;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace

std::string bar_text(double ratio) {
  const double marks = 2 * std::log2(ratio);
  if (!(ratio > 0) || !std::isfinite(ratio)) return std::string(bar_reach, ' ') + '|' + std::string(bar_reach, ' ');
  const bool is_clipped = std::fabs(marks) >= bar_reach + 0.5;
  const auto length = static_cast<std::size_t>(std::lround(std::min<double>(std::fabs(marks), bar_reach)));
  std::string bar(length, '#');
  const std::string space(bar_reach - length, ' '), nothing(bar_reach, ' ');
  if (marks < 0) {
    if (is_clipped) bar.front() = '<';
    return space + bar + '|' + nothing;
  }
  if (is_clipped) bar.back() = '>';
  return nothing + '|' + bar + space;
}

std::string bars_text(std::span<const SceneReport> scenes, const Plan& plan) {
  const auto workload = shown_workload(plan);
  if (scenes.size() < 2 || !workload) return {};
  constexpr std::size_t name_width = 22, bar_width = 2 * bar_reach + 3;
  std::string lines, heading = std::string(name_width, ' ');
  for (const SceneReport& scene : scenes) heading += padded(scene.name, bar_width);
  for (const ContenderReport& first : scenes.front().contenders) {
    std::string line = padded(first.name, name_width);
    bool is_measured = first.name != reference_peer;
    for (const SceneReport& scene : scenes) {
      const auto own = std::find_if(scene.contenders.begin(), scene.contenders.end(),
                                    [&](const ContenderReport& other) { return other.name == first.name; });
      const bool is_there = own != scene.contenders.end() && own->at[index_of(*workload)];
      const auto ratio = is_there ? own->at[index_of(*workload)]->ratio : std::nullopt;
      is_measured = is_measured && ratio;
      line += padded(bar_text(ratio ? ratio->median : 0), bar_width);
    }
    if (is_measured) lines += without_trailing_spaces(line);
  }
  if (lines.empty()) return {};
  return "speed on " + std::string(workload_infos[index_of(*workload)].name) +
         " rays: Embree's is |, ## to the right are twice it, ## to the left half of it, < and > go on\n\n" +
         without_trailing_spaces(heading) + lines;
}

}  // namespace sightline::bench
