#include "bench/report.h"

#include <cmath>

namespace sightline::bench {

void summarize(SceneReport& scene) {
  const ContenderReport* reference = nullptr;
  for (const ContenderReport& contender : scene.contenders) {
    if (contender.name == reference_peer) reference = &contender;
  }
  for (ContenderReport& contender : scene.contenders) {
    for (std::size_t w = 0; w < workload_count; ++w) {
      if (!contender.at[w]) continue;
      Measurement& own = *contender.at[w];
      std::vector<double> seconds, ratios;
      for (std::size_t round = 0; round < own.round_seconds.size(); ++round) {
        if (std::isnan(own.round_seconds[round])) continue;
        seconds.push_back(own.round_seconds[round]);
        if (!reference || !reference->at[w] || round >= reference->at[w]->round_seconds.size()) continue;
        const Measurement& other = *reference->at[w];
        if (std::isnan(other.round_seconds[round])) continue;
        const double own_rate = static_cast<double>(own.rays) / own.round_seconds[round];
        const double other_rate = static_cast<double>(other.rays) / other.round_seconds[round];
        ratios.push_back(own_rate / other_rate);
      }
      own.seconds = seconds.empty() ? std::nullopt : std::optional(estimate(seconds));
      own.ratio = ratios.empty() ? std::nullopt : std::optional(estimate(ratios));
    }
  }
}

}  // namespace sightline::bench
