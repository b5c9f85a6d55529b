#include "bench/solids/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "bench/processor_time.h"
#include "bench/solids/povray.h"
#include "bench/solids/povray_text.h"
#include "bench/verify.h"

namespace sightline::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Of POV-Ray's over one's own, where both took part.
SolidOptions without_switches() {
  SolidOptions options;
  for (const auto& field : SolidOptions::fields()) {
    if (const auto* member = std::get_if<bool SolidOptions::*>(&field.member)) options.*(*member) = false;
  }
  return options;
}

Difference difference_of(const Picture& a, const Picture& b, int row_step) {
  Difference difference;
  for (int y = 0; y < a.height; y += row_step) {
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
      const bool is_hit = a.shades[i] > 0;
      difference.coverage += is_hit != (b.shades[i] > 0);
      difference.shade += is_hit && b.shades[i] > 0 && std::fabs(a.shades[i] - b.shades[i]) > shade_limit;
    }
  }
  return difference;
}

/// One line, made ready and asked for one picture.
struct Contender {
  SolidAsking asking;
  std::unique_ptr<Painter> painter;
  Picture picture;
  double pass_seconds = 0;
};

class Stage {
 public:
  Stage(const SolidPlan& plan, const SolidScene& scene, Povray* povray, Progress& progress)
      : plan_(plan), scene_(scene), povray_(povray), progress_(progress) {
    report_.name = scene.name;
    report_.description = scene.description;
    report_.solids = scene.solids.size();
    report_.pixels = static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height);
    // Of the registry, what is fastest on these scenes: `bih` takes packets, which pays around a single solid as well.
    const bool is_given = !plan.accelerator.empty();
    const std::string over_operands = is_given ? plan.accelerator : "box-tree";
    report_.accelerator = is_given ? plan.accelerator : "bih";
    for (const SolidAsking& asking : askings_of(plan)) {
      contenders_.push_back(
          {asking,
           make_painter(scene, asking.level, asking.options, report_.accelerator, over_operands, asking.in_packets),
           Picture(plan.width, plan.height), 0});
    }
  }

  SolidSceneReport& report() { return report_; }

  void verify() {
    for (Contender& contender : contenders_) {
      progress_.say(scene_.name, "verifying " + contender.asking.name);
      const double begin = processor_seconds();
      contender.painter->paint(scene_, contender.picture, 1);
      contender.pass_seconds = processor_seconds() - begin;
      if (contender.asking.name == plan_.spoiled) spoil(contender.picture);
      Picture counted(plan_.width, plan_.height);
      report_.rows.push_back(
          {contender.asking.name, contender.painter->count(scene_, counted), {}, {}, {}, {}, {}, {}});
    }
    progress_.say(scene_.name, "verifying by exact lists of everything");
    Picture reference(plan_.width, plan_.height);
    make_painter(scene_, Level::exact, without_switches(), "brute-force", "brute-force", false)
        ->paint(scene_, reference, plan_.reference_step);
    for (const Contender& contender : contenders_) {
      require_near(contender, reference, plan_.reference_step, "brute force without any switch");
      require_near(contender, contenders_.front().picture, 1, contenders_.front().asking.name);
    }
    const auto& shades = contenders_.front().picture.shades;
    const auto hits = std::count_if(shades.begin(), shades.end(), [](float shade) { return shade > 0; });
    report_.hit_share = static_cast<double>(hits) / static_cast<double>(report_.pixels);
    if (povray_) verify_povray();
  }

  void measure() {
    const auto rounds = static_cast<std::size_t>(plan_.rounds);
    if (povray_) report_.rows.push_back({std::string(povray_name), std::nullopt, {}, {}, {}, {}, {}, {}});
    for (SolidRow& row : report_.rows) row.round_seconds.assign(rounds, nan), row.round_elapsed.assign(rounds, nan);
    const std::size_t count = report_.rows.size();
    for (std::size_t round = 0; round < rounds; ++round) {
      progress_.say(scene_.name, "round " + std::to_string(round + 1) + " of " + std::to_string(rounds));
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t row = (k + round) % count;
        if (row == contenders_.size()) {
          const Povray::TraceTime time = povray_->trace(povray_text(scene_), plan_.width, plan_.height);
          report_.rows[row].round_seconds[round] = time.processor;
          report_.rows[row].round_elapsed[round] = time.elapsed;
          continue;
        }
        Contender& contender = contenders_[row];
        if (static_cast<double>(round) * contender.pass_seconds > plan_.row_seconds) continue;
        const auto begin_elapsed = std::chrono::steady_clock::now();
        const double begin = processor_seconds();
        contender.painter->paint(scene_, contender.picture, 1);
        report_.rows[row].round_seconds[round] = processor_seconds() - begin;
        report_.rows[row].round_elapsed[round] =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_elapsed).count();
      }
    }
    for (SolidRow& row : report_.rows) {
      row.seconds = estimate_of_present(row.round_seconds);
      row.elapsed = estimate_of_present(row.round_elapsed);
      if (!povray_ || &row == &report_.rows.back()) continue;
      row.ratio = paired_ratio(report_.rows.back().round_seconds, row.round_seconds);
      row.elapsed_ratio = paired_ratio(report_.rows.back().round_elapsed, row.round_elapsed);
    }
  }

 private:
  /// A hole of one pixel, in the middle of what is seen of the picture.
  void spoil(Picture& picture) const {
    const auto row = static_cast<std::size_t>(plan_.height / 2 / plan_.reference_step * plan_.reference_step);
    for (std::size_t i = row * static_cast<std::size_t>(plan_.width); i < picture.size(); ++i) {
      if (picture.shades[i] == 0) continue;
      picture.shades[i] = 0;
      return;
    }
  }

  /// Levels above fast decide every hit, and so the coverage, alike. What is farther from the light than rounding may
  /// be shadowed or not; so shades may differ in one of a hundred thousand pixels. At level fast a thousandth may
  /// differ.
  void require_near(const Contender& own, const Picture& other, int row_step, const std::string& name) const {
    const Difference difference = difference_of(own.picture, other, row_step);
    const std::size_t some = report_.pixels / 1000, few = report_.pixels / 100'000;
    const bool is_fast = own.asking.level == Level::fast || contenders_.front().asking.level == Level::fast;
    if (difference.coverage <= (is_fast ? some : 0) && difference.shade <= (is_fast ? some : few)) return;
    throw WrongHits(own.asking.name + " is wrong, so no times are shown: " + scene_.name +
                    ": expected the picture of " + name + ", found " + std::to_string(difference.coverage) +
                    " pixels with another coverage and " + std::to_string(difference.shade) + " with another shade");
  }

  void verify_povray() {
    progress_.say(scene_.name, "verifying POV-Ray");
    const Difference difference =
        difference_of(contenders_.front().picture, povray_->paint(povray_text(scene_), plan_.width, plan_.height), 1);
    report_.from_povray = difference;
    if (difference.coverage + difference.shade <= report_.pixels / 500) return;
    throw WrongHits("POV-Ray sees something else, so no times are shown: " + scene_.name +
                    ": expected the picture of " + contenders_.front().asking.name + ", found " +
                    std::to_string(difference.coverage) + " pixels with another coverage and " +
                    std::to_string(difference.shade) + " with another shade");
  }

  const SolidPlan& plan_;
  const SolidScene& scene_;
  Povray* povray_;
  Progress& progress_;
  std::vector<Contender> contenders_;
  SolidSceneReport report_;
};

}  // namespace

std::vector<SolidAsking> askings_of(const SolidPlan& plan) {
  std::vector<SolidAsking> askings;
  for (const Level level : plan.levels) {
    const std::string name(info_of(level).name);
    askings.push_back({name, level, plan.options, true});
    if (plan.has_single) askings.push_back({name + " single", level, plan.options, false});
  }
  if (!plan.is_ablation) return askings;
  const SolidAsking whole = askings.front();
  for (const auto& field : SolidOptions::fields()) {
    const auto* member = std::get_if<bool SolidOptions::*>(&field.member);
    if (!member || !(whole.options.*(*member))) continue;
    askings.push_back(whole);
    askings.back().name += ", " + std::string(field.name) + " off";
    askings.back().options.*(*member) = false;
  }
  askings.push_back({whole.name + ", all off", whole.level, without_switches()});
  return askings;
}

SolidReport run_solids(const SolidPlan& plan, Progress& progress,
                       const std::function<void(const SolidReport&, const SolidSceneReport&)>& see) {
  SolidReport report{this_machine(), plan, {}, {}};
  std::optional<Povray> povray = plan.has_povray ? Povray::find() : std::nullopt;
  if (povray) report.povray_version = povray->version();
  for (const SolidScene& scene : solid_scenes(plan.width, plan.height)) {
    const auto& names = plan.scenes;
    if (!names.empty() && std::find(names.begin(), names.end(), scene.name) == names.end()) continue;
    Stage stage(plan, scene, povray ? &*povray : nullptr, progress);
    stage.verify();
    stage.measure();
    progress.clear();
    report.scenes.push_back(std::move(stage.report()));
    see(report, report.scenes.back());
  }
  return report;
}

std::vector<SolidGrowth> growth_of(const SolidReport& report) {
  std::vector<SolidGrowth> growth;
  if (report.scenes.empty()) return growth;
  for (const SolidRow& line : report.scenes.front().rows) {
    std::vector<double> counts, seconds;
    for (const SolidSceneReport& scene : report.scenes) {
      for (const SolidRow& row : scene.rows) {
        if (holes_of(scene.name) == 0 || row.name != line.name || !row.seconds) continue;
        counts.push_back(holes_of(scene.name));
        seconds.push_back(row.seconds->median);
      }
    }
    if (const auto fit = fit_power(counts, seconds)) growth.push_back({line.name, *fit});
  }
  return growth;
}

}  // namespace sightline::bench
