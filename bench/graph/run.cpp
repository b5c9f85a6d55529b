#include "bench/graph/run.h"

#include <algorithm>
#include <cmath>

#include "bench/processor_time.h"

namespace sightline::bench {
namespace {

double seconds_of(const GraphContender& contender, int passes) {
  const double begin = processor_seconds();
  for (int i = 0; i < passes; ++i) contender.pass();
  return (processor_seconds() - begin) / passes;
}

void append(std::vector<GraphContender>& all, std::vector<GraphContender> some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

}  // namespace

GraphReport run_graph(const GraphPlan& plan, Progress& progress) {
  GraphReport report{this_machine(), plan, {}};
  progress.say("scene graphs", "verifying");
  std::vector<GraphContender> contenders = world_contenders(plan);
  append(contenders, kind_contenders(plan));
  append(contenders, update_contenders(plan));
  std::vector<int> passes;
  for (const GraphContender& contender : contenders) {
    report.rows.push_back({contender.family, contender.table, contender.name, contender.facts, {}, {}, {}});
    const double once = std::min(seconds_of(contender, 1), seconds_of(contender, 1));
    passes.push_back(static_cast<int>(std::clamp(std::ceil(plan.slot_seconds / once), 1.0, 1e6)));
  }
  for (int round = 0; round < plan.rounds; ++round) {
    progress.say("timing scene graphs", "round " + std::to_string(round + 1) + " of " + std::to_string(plan.rounds));
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const std::size_t c = (i + static_cast<std::size_t>(round)) % contenders.size();
      report.rows[c].round_seconds.push_back(seconds_of(contenders[c], passes[c]) / contenders[c].units);
    }
  }
  const GraphRow* first = nullptr;
  for (GraphRow& row : report.rows) {
    if (first == nullptr || first->table != row.table || first->family != row.family) first = &row;
    row.seconds = estimate(row.round_seconds);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < row.round_seconds.size(); ++i) {
      ratios.push_back(first->round_seconds[i] / row.round_seconds[i]);
    }
    row.ratio = estimate(ratios);
  }
  progress.clear();
  return report;
}

}  // namespace sightline::bench
