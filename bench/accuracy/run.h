#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/accuracy/axis.h"
#include "bench/accuracy/front.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

struct AccuracyPlan {
  std::vector<const Axis*> axes;  ///< In the order they are shown.
  int rounds = 21;
  double slot_seconds = 0.004;  ///< A choice's share of a round is at least as long.
  std::uint64_t seed = 1;
  bool is_quick = false;
  std::string data_dir;
  std::string json, html, charts;  ///< Files and a folder to be written; empty for none.
};

struct ChoiceReport {
  std::string name;
  Errors errors;
  std::vector<std::pair<std::string, double>> extras;
  std::vector<double> round_seconds;  ///< Of one unit.
  Estimate seconds;
  Standing standing;
};

struct PanelReport {
  std::string name, description, unit, error_unit;
  ErrorKind kind = ErrorKind::maximum;
  std::string wrong_name;
  std::vector<ChoiceReport> choices;
  Estimate
      same;  ///< The first choice's time over its own, timed a second time: what the machine makes of no difference.
};

struct AxisReport {
  std::string name, question;
  std::vector<PanelReport> panels;
};

struct AccuracyReport {
  Machine machine;
  AccuracyPlan plan;
  std::vector<AxisReport> axes;
};

/// In rounds, each of which begins with the next choice; the first choice twice. \throws std::invalid_argument for a
/// panel without choices.
PanelReport measure(const Panel& panel, int rounds, double slot_seconds);

/// Errors first, then times. see(report, axis) is told of each axis when it is complete.
AccuracyReport run_accuracy(const AccuracyPlan& plan, Progress& progress,
                            const std::function<void(const AccuracyReport&, const AxisReport&)>& see);

std::string head_text(const AccuracyReport& report);
std::string table_text(const AxisReport& axis);
std::string json_text(const AccuracyReport& report);
/// One page that needs nothing else.
std::string page_text(const AccuracyReport& report);

/// "1.2e-07"; empty where there is none.
std::string error_text(double error);
/// "maximum error", "RMS error", or what the panel counts of a million.
std::string kind_name(const PanelReport& panel);
/// "0 to 770": where the true number per million lies with a confidence of 95 %; empty where it is no share.
std::string wrong_interval(const Errors& errors);

/// All that there are.
const std::vector<Axis>& accuracy_axes();

/// Draws a chart of each panel into a folder. \throws what writing does
using DrawCharts = std::function<void(const AccuracyReport&, const std::string& folder)>;

/// `sightline-accuracy ...`; returns the exit status.
int run_accuracy_command(int argc, const char* const* argv, const DrawCharts& draw);

}  // namespace sightline::bench
