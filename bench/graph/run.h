#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

struct GraphPlan {
  std::vector<std::size_t> depths{1, 4, 16, 64, 256};
  std::vector<std::size_t> sizes{1'000, 10'000, 100'000};  ///< Nodes of the graphs that are updated.
  int rounds = 9;
  double slot_seconds = 0.02;  ///< A contender's share of a round is at least as long.
  bool is_spoiled = false;     ///< Takes one hit for a miss: the run has to refuse.
  std::string json;
};

/// What was counted of a contender, outside the timing.
using Facts = std::vector<std::pair<std::string, double>>;

/// One way to do the work of a table. Tables of a family have the same columns.
struct GraphContender {
  std::string family;  ///< "worlds", "rays", "views", "updates"
  std::string table;   ///< "depth 16"
  std::string name;
  std::function<void()> pass;
  double units = 1;  ///< Questions in a pass.
  Facts facts;
};

struct GraphRow {
  std::string family, table, name;
  Facts facts;
  std::vector<double> round_seconds;  ///< Of one question.
  Estimate seconds;
  Estimate ratio;  ///< Of the table's first row's time over this one's, paired by round.
};

struct GraphReport {
  Machine machine;
  GraphPlan plan;
  std::vector<GraphRow> rows;
};

/// Places by cached products against products computed anew. \throws WrongHits where they differ in a bit.
std::vector<GraphContender> world_contenders(const GraphPlan& plan);
/// Kinds of bounds against rays and cameras. \throws WrongHits where one hides what is hit or seen.
std::vector<GraphContender> kind_contenders(const GraphPlan& plan);
/// One change against all anew. \throws WrongHits where bounds differ from those of a new scene.
std::vector<GraphContender> update_contenders(const GraphPlan& plan);

/// Verifies, then measures in rounds, each of which begins with the next contender.
GraphReport run_graph(const GraphPlan& plan, Progress& progress);

std::string text_of(const GraphReport& report);
std::string json_text(const GraphReport& report);

/// `sightline-bench graph ...`; throws what bench/main.cpp handles.
int run_graph_command(int argc, const char* const* argv);

/// Keeps a result from being optimized away.
inline void use(std::size_t result) {
  [[maybe_unused]] static volatile std::size_t sink;
  sink = result;
}

}  // namespace sightline::bench
