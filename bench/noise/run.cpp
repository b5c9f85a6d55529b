#include "bench/noise/run.h"

#include <algorithm>
#include <cmath>

#include "bench/peers/noise_peers.h"
#include "bench/processor_time.h"

namespace sightline::bench {
namespace {

double seconds_of(const NoiseContender& contender, int passes) {
  const double begin = processor_seconds();
  for (int i = 0; i < passes; ++i) contender.pass();
  return (processor_seconds() - begin) / passes;
}

/// The row that ratios of a table refer to: the first peer's at the same points; those of other tables at the random
/// ones.
const NoiseRow* reference_of(const std::vector<NoiseRow>& rows, const NoiseRow& row) {
  const auto is_reference = [](const NoiseRow& r) { return r.name == noise_peers().front().name; };
  const NoiseRow* any = nullptr;
  for (const NoiseRow& other : rows) {
    if (!is_reference(other)) continue;
    if (other.table == row.table) return &other;
    if (!any) any = &other;
  }
  return row.table == "octaves" ? any : nullptr;
}

}  // namespace

NoiseReport run_noise(const NoisePlan& plan, Progress& progress) {
  NoiseReport report{this_machine(), plan, {}, {}, {}};
  for (const NoisePeer& peer : noise_peers()) {
    if (!peer.values) report.missing.emplace_back(peer.package);
  }
  progress.say("noise", "verifying");
  const std::vector<NoiseContender> contenders = make_noise_contenders(plan);
  std::vector<int> passes;
  for (const NoiseContender& contender : contenders) {
    report.rows.push_back({contender.table, contender.name, contender.is_peer, contender.error, {}, {}, {}});
    const double once = std::min(seconds_of(contender, 1), seconds_of(contender, 1));
    passes.push_back(std::max(1, static_cast<int>(std::ceil(plan.slot_seconds / once))));
  }
  for (int round = 0; round < plan.rounds; ++round) {
    progress.say("timing noise", "round " + std::to_string(round + 1) + " of " + std::to_string(plan.rounds));
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const std::size_t c = (i + static_cast<std::size_t>(round)) % contenders.size();
      report.rows[c].round_seconds.push_back(seconds_of(contenders[c], passes[c]) / static_cast<double>(plan.points));
    }
  }
  for (NoiseRow& row : report.rows) row.seconds = estimate(row.round_seconds);
  for (NoiseRow& row : report.rows) {
    const NoiseRow* const reference = reference_of(report.rows, row);
    if (!reference) continue;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < row.round_seconds.size(); ++i) {
      ratios.push_back(reference->round_seconds[i] / row.round_seconds[i]);
    }
    row.ratio = estimate(ratios);
  }
  progress.say("noise", "floats against doubles");
  report.accuracy = accuracy_of_floats();
  progress.clear();
  return report;
}

}  // namespace sightline::bench
