#include "bench/accuracy/run.h"

#include <cmath>
#include <stdexcept>

#include "bench/processor_time.h"
#include "bench/rotation.h"

namespace sightline::bench {
namespace {

volatile double sink;  ///< Results end here, so that nothing of a pass is left out.

double seconds_of(const Choice& choice, int passes) {
  const double begin = processor_seconds();
  double sum = 0;
  for (int i = 0; i < passes; ++i) sum += choice.pass();
  sink = sum;
  return processor_seconds() - begin;
}

}  // namespace

PanelReport measure(const Panel& panel, int rounds, double slot_seconds) {
  if (panel.choices.empty()) throw std::invalid_argument(panel.name + ": no choices");
  PanelReport report{panel.name, panel.description, panel.unit, panel.error_unit, panel.kind, panel.wrong_name, {}, {}};
  std::vector<int> passes;
  for (const Choice& choice : panel.choices) {
    report.choices.push_back({choice.name, choice.errors, choice.extras, {}, {}, {}});
    double once = seconds_of(choice, 1);
    if (once < slot_seconds) once = std::min(once, seconds_of(choice, 1));
    passes.push_back(std::max(1, static_cast<int>(std::ceil(slot_seconds / std::max(once, 0x1p-30)))));
  }
  // The last line is the first choice again.
  const std::size_t count = panel.choices.size();
  std::vector<double> again;
  for (ChoiceReport& choice : report.choices) choice.round_seconds.assign(static_cast<std::size_t>(rounds), not_asked);
  again.assign(static_cast<std::size_t>(rounds), not_asked);
  in_rotation(
      {static_cast<std::size_t>(rounds), count + 1, 60}, [](const std::string&) {},
      [&](std::size_t line, std::size_t round) {
        const std::size_t c = line == count ? 0 : line;
        const double seconds = seconds_of(panel.choices[c], passes[c]);
        const double of_one = seconds / passes[c] / panel.units;
        (line == count ? again : report.choices[c].round_seconds)[round] = of_one;
        return seconds;
      });
  std::vector<Candidate> candidates;
  for (ChoiceReport& choice : report.choices) {
    choice.seconds = *estimate_of_present(choice.round_seconds);
    candidates.push_back({error_of(choice.errors, panel.kind), choice.round_seconds});
  }
  report.same = *paired_ratio(again, report.choices[0].round_seconds);
  const auto all = standings(candidates);
  for (std::size_t i = 0; i < count; ++i) report.choices[i].standing = all[i];
  return report;
}

AccuracyReport run_accuracy(const AccuracyPlan& plan, Progress& progress,
                            const std::function<void(const AccuracyReport&, const AxisReport&)>& see) {
  AccuracyReport report{this_machine(), plan, {}};
  for (const Axis* axis : plan.axes) {
    const std::string name(axis->name);
    progress.say(name, "errors");
    const Effort effort{plan.is_quick, plan.seed, plan.data_dir,
                        [&](const std::string& what) { progress.say(name, what); }};
    AxisReport own{name, std::string(axis->question), {}};
    for (const Panel& panel : axis->panels(effort)) {
      progress.say(name, "timing " + panel.name);
      own.panels.push_back(measure(panel, plan.rounds, plan.slot_seconds));
    }
    progress.clear();
    report.axes.push_back(std::move(own));
    see(report, report.axes.back());
  }
  return report;
}

}  // namespace sightline::bench
