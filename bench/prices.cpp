#include "bench/prices.h"

#include <algorithm>

#include "bench/text_table.h"

namespace sightline::bench {
namespace {

bool is_one_structure(const SceneReport& scene, std::size_t a, std::size_t b) {
  const auto& contenders = scene.contenders;
  return contenders[a].built_as.value_or(a) == contenders[b].built_as.value_or(b);
}

/// What may be chosen in favour of speed: the same asking with that choice made.
Asking with_less_accuracy(Asking asking) { return {Level::fast, asking.is_stream}; }
Asking with_a_stream(Asking asking) { return {asking.level, true}; }

const ContenderReport* find(const SceneReport& scene, const std::string& name) {
  const auto found = std::find_if(scene.contenders.begin(), scene.contenders.end(),
                                  [&](const ContenderReport& contender) { return contender.name == name; });
  return found == scene.contenders.end() ? nullptr : &*found;
}

std::optional<Estimate> mean_ratio(std::span<const SceneReport> scenes, const Price& price, Workload workload) {
  std::vector<std::vector<double>> ratios;
  for (const SceneReport& scene : scenes) {
    const ContenderReport *own = find(scene, price.name), *over = find(scene, price.over);
    if (!own || !over || !own->at[index_of(workload)] || !over->at[index_of(workload)]) return std::nullopt;
    ratios.push_back(paired_ratios(*over->at[index_of(workload)], *own->at[index_of(workload)]));
  }
  return estimate_of_present(geometric_means(ratios));
}

}  // namespace

std::vector<Price> prices_of(std::span<const SceneReport> scenes) {
  std::vector<Price> prices;
  if (scenes.empty()) return prices;
  const auto& contenders = scenes.front().contenders;
  for (const auto choose : {with_less_accuracy, with_a_stream}) {
    for (std::size_t a = 0; a < contenders.size(); ++a) {
      for (std::size_t b = 0; b < contenders.size(); ++b) {
        const auto &own = contenders[a].asking, &over = contenders[b].asking;
        if (!own || own == over || over != choose(*own) || !is_one_structure(scenes.front(), a, b)) continue;
        Price price{contenders[a].name, contenders[b].name, {}};
        for (const WorkloadInfo& info : workload_infos) {
          if (info.workload == Workload::build) continue;
          price.ratio[index_of(info.workload)] = mean_ratio(scenes, price, info.workload);
        }
        prices.push_back(std::move(price));
      }
    }
  }
  return prices;
}

std::string prices_text(std::span<const SceneReport> scenes, const Plan& plan) {
  const std::vector<Price> prices = prices_of(scenes);
  if (prices.empty() || plan.workloads == std::vector{Workload::build}) return {};
  TextTable table;
  table.add_column("", "time per ray, paired by round");
  for (const Workload w : plan.workloads) {
    if (w == Workload::build) continue;
    table.add_column(std::string(workload_infos[index_of(w)].name), "times");
    table.add_column(std::string(workload_infos[index_of(w)].name), "interval");
  }
  for (const Price& price : prices) {
    std::vector<std::string> row{price.name + " over " + price.over};
    for (const Workload w : plan.workloads) {
      if (w == Workload::build) continue;
      const auto& ratio = price.ratio[index_of(w)];
      row.push_back(ratio ? measured_text(*ratio) + 'x' : "-");
      row.push_back(ratio && ratio->low < ratio->high ? interval_text(*ratio, 3) : "");
    }
    table.add_row(std::move(row));
  }
  return "\n" + table.text();
}

}  // namespace sightline::bench
