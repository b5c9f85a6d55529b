#include "bench/report.h"

#include <algorithm>
#include <cmath>

#include "bench/peers/peers.h"

namespace sightline::bench {

std::vector<double> paired_ratios(const Measurement& own, const Measurement& reference) {
  std::vector<double> ratios(own.round_seconds.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t round = 0; round < std::min(ratios.size(), reference.round_seconds.size()); ++round) {
    const double own_rate = static_cast<double>(own.rays) / own.round_seconds[round];
    ratios[round] = own_rate / (static_cast<double>(reference.rays) / reference.round_seconds[round]);
  }
  return ratios;
}

const ContenderReport* reference_of(const SceneReport& scene) {
  const auto found = std::find_if(scene.contenders.begin(), scene.contenders.end(),
                                  [](const ContenderReport& contender) { return contender.name == reference_peer; });
  return found == scene.contenders.end() ? nullptr : &*found;
}

void summarize(SceneReport& scene) {
  const ContenderReport* reference = reference_of(scene);
  for (ContenderReport& contender : scene.contenders) {
    for (std::size_t w = 0; w < workload_count; ++w) {
      if (!contender.at[w]) continue;
      Measurement& own = *contender.at[w];
      own.seconds = estimate_of_present(own.round_seconds);
      own.ratio = std::nullopt;
      if (reference && reference->at[w]) own.ratio = estimate_of_present(paired_ratios(own, *reference->at[w]));
    }
    constexpr std::size_t build = index_of(Workload::build);
    if (contender.built_as) contender.at[build] = scene.contenders[*contender.built_as].at[build];
  }
}

}  // namespace sightline::bench
