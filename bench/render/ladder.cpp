#include "bench/render/ladder.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "bench/processor_time.h"
#include "bench/render/canvas.h"
#include "bench/rotation.h"
#include "bench/verify.h"
#include "sightline/render/renderer.h"

namespace sightline::bench {
namespace {

class Ladder {
 public:
  Ladder(const LadderPlan& plan, Progress& progress)
      : plan_(plan), progress_(progress), canvas_(plan.width, plan.height) {
    report_.machine = this_machine();
    report_.plan = plan;
    for (Rung& rung : make_ladder(plan.data_dir)) {
      progress.say("building", rung.name);
      renderers_.push_back(std::make_unique<Renderer>(rung.scene, rung.settings(plan.width, plan.height, plan.level)));
      RungReport row;
      row.integrator = renderers_.back()->plan().integrator;
      row.rung = std::move(rung);
      row.round_seconds.assign(static_cast<std::size_t>(plan.rounds), std::numeric_limits<double>::quiet_NaN());
      report_.rungs.push_back(std::move(row));
    }
  }

  LadderReport run() {
    for (std::size_t i = 0; i < renderers_.size(); ++i) verify(i);
    in_rotation(
        {static_cast<std::size_t>(plan_.rounds), renderers_.size(), plan_.row_seconds},
        [&](const std::string& round) { progress_.say("measuring", round); },
        [&](std::size_t i, std::size_t round) {
          const double begin = processor_seconds();
          paint(*renderers_[i], canvas_);
          return report_.rungs[i].round_seconds[round] = processor_seconds() - begin;
        });
    for (RungReport& row : report_.rungs) estimate_of(row);
    progress_.clear();
    return std::move(report_);
  }

 private:
  static RenderCounters paint(const Renderer& renderer, Canvas& canvas) {
    RenderCounters counters;
    canvas.paint([&](TileBuffer& tile, std::span<const std::uint32_t> pixels) {
      renderer.add_samples(tile, pixels, {0, renderer.samples()}, FactsAsked::none, counters);
    });
    return counters;
  }

  const RungReport* below(const RungReport& row) const {
    const auto is_below = [&](const RungReport& other) { return other.rung.name == row.rung.over; };
    const auto found = std::find_if(report_.rungs.begin(), report_.rungs.end(), is_below);
    return found == report_.rungs.end() ? nullptr : &*found;
  }
  Effects simulated(const RungReport& row) const {
    return renderers_[static_cast<std::size_t>(&row - report_.rungs.data())]->scene().effects;
  }

  void verify(std::size_t i) {
    RungReport& row = report_.rungs[i];
    progress_.say("verifying", row.rung.name);
    const RungReport* const lower = below(row);
    Effects added = simulated(row);
    for (std::size_t e = 0; lower && e < effect_count; ++e) {
      if (simulated(*lower).has(static_cast<Effect>(e))) added.remove(static_cast<Effect>(e));
    }
    if (added != row.rung.adds) refuse(row, "expected no effects but those that it is there for, found others");

    row.counters = paint(*renderers_[i], canvas_);
    if (row.rung.name == plan_.spoiled) canvas_.tiles().front().sums.front().add(Vec3d(1));
    RenderSettings settings = row.rung.settings(plan_.width, plan_.height, plan_.level);
    settings.knows_all = true;
    Canvas other(plan_.width, plan_.height);
    const RenderCounters others = paint(Renderer(row.rung.scene, settings), other);
    for (const RenderCounters& counters : {row.counters, others}) {
      if (const auto effect = counted_though_off(simulated(row), counters)) {
        refuse(row, "expected a count of 0 of what is off, found " + std::to_string(counters[*effect]) + " of " +
                        std::string(effect_names[index_of(*effect)]));
      }
    }
    if (const std::size_t wrong = canvas_.differing(other)) {
      refuse(row, "expected the picture of the integrator that knows every effect, found " + std::to_string(wrong) +
                      " other pixels");
    }
  }

  [[noreturn]] static void refuse(const RungReport& row, const std::string& why) {
    throw WrongHits(row.rung.name + " is wrong, so no times are shown: " + why);
  }

  void estimate_of(RungReport& row) const {
    row.seconds = estimate_of_present(row.round_seconds);
    const RungReport* const lower = below(row);
    if (!lower) return;
    row.over = paired_ratio(row.round_seconds, lower->round_seconds);
    std::vector<double> differences(row.round_seconds.size());
    for (std::size_t i = 0; i < differences.size(); ++i)
      differences[i] = row.round_seconds[i] - lower->round_seconds[i];
    row.added = estimate_of_present(std::move(differences));
  }

  const LadderPlan& plan_;
  Progress& progress_;
  Canvas canvas_;
  std::vector<std::unique_ptr<Renderer>> renderers_;
  LadderReport report_;
};

}  // namespace

std::optional<Effect> counted_though_off(Effects on, const RenderCounters& counters) {
  for (std::size_t i = 0; i < effect_count; ++i) {
    if (counters.counts[i] > 0 && !on.has(static_cast<Effect>(i))) return static_cast<Effect>(i);
  }
  return std::nullopt;
}

LadderReport run_ladder(const LadderPlan& plan, Progress& progress) { return Ladder(plan, progress).run(); }

}  // namespace sightline::bench
