#include "bench/summary.h"

#include <algorithm>
#include <cmath>

#include "bench/peers/peers.h"
#include "bench/prices.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

/// The contender of this name in each scene; empty when it is not in all.
std::vector<const ContenderReport*> in_all(std::span<const SceneReport> scenes, const std::string& name) {
  std::vector<const ContenderReport*> list;
  for (const SceneReport& scene : scenes) {
    for (const ContenderReport& contender : scene.contenders) {
      if (contender.name == name) list.push_back(&contender);
    }
  }
  if (list.size() != scenes.size()) list.clear();
  return list;
}

std::optional<Estimate> mean_ratio(std::span<const SceneReport> scenes, std::span<const ContenderReport* const> own,
                                   std::size_t workload) {
  std::vector<std::vector<double>> ratios;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    const ContenderReport* reference = reference_of(scenes[s]);
    if (!own[s]->at[workload] || !reference || !reference->at[workload]) return std::nullopt;
    ratios.push_back(paired_ratios(*own[s]->at[workload], *reference->at[workload]));
  }
  return estimate_of_present(geometric_means(ratios));
}

}  // namespace

std::vector<SummaryLine> summary_of(std::span<const SceneReport> scenes) {
  std::vector<SummaryLine> lines;
  if (scenes.empty()) return lines;
  for (const ContenderReport& contender : scenes.front().contenders) {
    const auto own = in_all(scenes, contender.name);
    if (own.empty()) continue;
    SummaryLine line{contender.name, contender.built_as.has_value(), {}, {}};
    double logarithms = 0;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      logarithms += std::log(static_cast<double>(own[s]->bytes.total()) / static_cast<double>(scenes[s].triangles));
    }
    const double bytes = std::exp(logarithms / static_cast<double>(scenes.size()));
    if (std::isfinite(bytes)) line.bytes_per_triangle = bytes;
    for (std::size_t w = 0; w < workload_count; ++w) line.ratio[w] = mean_ratio(scenes, own, w);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string summary_text(std::span<const SceneReport> scenes, const Plan& plan) {
  if (scenes.size() < 2) return {};
  TextTable table;
  table.add_column("", "structure");
  table.add_column("memory", "B/tri");
  for (const Workload w : plan.workloads) {
    const std::string name(workload_infos[index_of(w)].name);
    table.add_column(name, "xEmbree");
    table.add_column(name, "interval");
  }
  double least = 1, most = 0;  // confidence
  for (const SummaryLine& line : summary_of(scenes)) {
    std::vector<std::string> row{line.name};
    row.push_back(line.is_shared ? "" : line.bytes_per_triangle ? number_text(*line.bytes_per_triangle) : "-");
    for (const Workload w : plan.workloads) {
      if (line.is_shared && w == Workload::build) {
        row.insert(row.end(), {"", ""});
        continue;
      }
      const auto& ratio = line.ratio[index_of(w)];
      row.push_back(ratio ? measured_text(*ratio) + 'x' : "-");
      const bool is_interval = ratio && ratio->low < ratio->high;
      row.push_back(is_interval ? interval_text(*ratio, 2) : "");
      if (!is_interval) continue;
      least = std::min(least, ratio->confidence);
      most = std::max(most, ratio->confidence);
    }
    table.add_row(std::move(row));
  }
  std::vector<std::string> names;
  for (const SceneReport& scene : scenes) names.push_back(scene.name);
  std::string text = "all " + plural(scenes.size(), "scene") + ": " + joined(names) + "\n\n" + table.text() +
                     prices_text(scenes, plan) +
                     "\nGeometric means over the scenes: of memory, and of speed over Embree's (building: of its time "
                     "over the structure's).\nRound by round the mean of all scenes, then the median of the rounds";
  if (most > 0) text += "; intervals hold it with " + number_text(100 * most, 2) + " %";
  if (least < most) text += ", down to " + number_text(100 * least, 2) + " % where rounds were few";
  return text + ".\n";
}

}  // namespace sightline::bench
