#include "bench/render/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "bench/processor_time.h"
#include "bench/render/anew.h"
#include "bench/render/canvas.h"
#include "bench/render/instructions.h"
#include "bench/render/pictures.h"
#include "bench/render/stripped.h"
#include "bench/rotation.h"
#include "bench/solids/povray.h"
#include "bench/verify.h"
#include "sightline/render/renderer.h"

namespace sightline::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

RenderSettings settings_of(const RenderPlanOfBench& plan, bool knows_all) {
  RenderSettings settings;
  settings.width = plan.width;
  settings.height = plan.height;
  settings.level = plan.level;
  settings.filters_textures = plan.filters_textures;
  settings.knows_all = knows_all;
  return settings;
}

class Stage {
 public:
  Stage(const RenderPlanOfBench& plan, const RenderPicture& picture, Povray* povray)
      : plan_(plan),
        picture_(picture),
        povray_(povray),
        special_(picture.scene, settings_of(plan, false)),
        superset_(picture.scene, settings_of(plan, true)),
        text_(picture.povray(special_.scene().moments[0]->lens.camera)) {
    report_.name = picture.name;
    report_.description = picture.description;
    report_.integrator = special_.plan().integrator;
    report_.pixels = static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height);
    add(plan_line, "what the scene calls for");
    add(again_line, "the same, to see what is noise");
    add(stripped_line, "all else deleted from it by hand");
    add(anew_line, "by hand for this scene alone");
    add(all_line, "the integrator that knows every effect");
    if (povray) add(povray_line, "");
  }

  RenderPictureReport& report() { return report_; }

  void paint(std::string_view line, Canvas& canvas) {
    RenderCounters counters;
    if (line == stripped_line) {
      canvas.paint([&](TileBuffer& tile, auto) { add_stripped_samples(special_.scene(), tile); });
    } else if (line == anew_line) {
      canvas.paint([&](TileBuffer& tile, auto) { add_anew_samples(special_.scene(), tile); });
    } else {
      const Renderer& renderer = line == all_line ? superset_ : special_;
      canvas.paint([&](TileBuffer& tile, std::span<const std::uint32_t> pixels) {
        renderer.add_samples(tile, pixels, {0, 1}, FactsAsked::none, counters);
      });
    }
    report_.shadow_rays = std::max<std::size_t>(report_.shadow_rays, counters[Effect::hard_shadow]);
  }

  void verify() {
    Canvas reference(plan_.width, plan_.height);
    paint(plan_line, reference);
    for (const RenderRow& row : report_.rows) {
      if (row.name == povray_line) continue;
      Canvas canvas(plan_.width, plan_.height);
      paint(row.name, canvas);
      if (row.name == plan_.spoiled) canvas.tiles().front().sums.front().add(Vec3d(1));
      if (const std::size_t wrong = canvas.differing(reference)) {
        throw WrongHits(row.name + " is wrong, so no times are shown: " + picture_.name +
                        ": expected the plan's picture to the last bit, found " + std::to_string(wrong) +
                        " other pixels");
      }
    }
    if (!povray_) return;
    const Picture own = reference.gray();
    const Picture other = povray_->paint(text_, plan_.width, plan_.height);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      // Where light grazes a surface, or does not come, both may be black.
      const bool is_other = picture_.has_same_shades && std::fabs(own.shades[i] - other.shades[i]) > 1.0f / 256;
      differing += is_other || ((own.shades[i] > 1.0f / 256) != (other.shades[i] > 1.0f / 256) &&
                                std::max(own.shades[i], other.shades[i]) > 4.0f / 256);
    }
    report_.differing_from_povray = differing;
    if (differing <= report_.pixels / 500) return;
    throw WrongHits("POV-Ray sees something else, so no times are shown: " + picture_.name + ": expected the plan's " +
                    "picture, found " + std::to_string(differing) + " other pixels");
  }

  void measure(Progress& progress) {
    const auto rounds = static_cast<std::size_t>(plan_.rounds);
    for (RenderRow& row : report_.rows) row.round_seconds.assign(rounds, nan), row.round_elapsed.assign(rounds, nan);
    Canvas canvas(plan_.width, plan_.height);
    in_rotation(
        {rounds, report_.rows.size(), plan_.row_seconds},
        [&](const std::string& round) { progress.say(picture_.name, round); },
        [&](std::size_t line, std::size_t round) { return time(report_.rows[line], round, canvas); });
    for (RenderRow& row : report_.rows) {
      row.seconds = estimate_of_present(row.round_seconds);
      row.over_plan = paired_ratio(row.round_seconds, report_.rows[0].round_seconds);
      if (!povray_ || row.name == povray_line) continue;
      row.povray_over = paired_ratio(report_.rows.back().round_seconds, row.round_seconds);
      row.povray_elapsed = paired_ratio(report_.rows.back().round_elapsed, row.round_elapsed);
    }
  }

 private:
  void add(std::string_view name, const char* what) {
    report_.rows.push_back({std::string(name), what, {}, {}, {}, {}, {}, {}});
  }

  /// Returns what it took on the wall.
  double time(RenderRow& row, std::size_t round, Canvas& canvas) {
    const auto begin_elapsed = std::chrono::steady_clock::now();
    if (row.name == povray_line) {
      const Povray::TraceTime time = povray_->trace(text_, plan_.width, plan_.height);
      row.round_seconds[round] = time.processor;
      row.round_elapsed[round] = time.elapsed;
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_elapsed).count();
    }
    const double begin = processor_seconds();
    paint(row.name, canvas);
    row.round_seconds[round] = processor_seconds() - begin;
    row.round_elapsed[round] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_elapsed).count();
    return row.round_elapsed[round];
  }

  const RenderPlanOfBench& plan_;
  const RenderPicture& picture_;
  Povray* povray_;
  Renderer special_, superset_;
  std::string text_;
  RenderPictureReport report_;
};

}  // namespace

std::vector<std::string> names_of(const RenderPlanOfBench& plan) {
  std::vector<std::string> names;
  for (const RenderPicture& picture : render_pictures()) {
    const bool is_asked = std::find(plan.scenes.begin(), plan.scenes.end(), picture.name) != plan.scenes.end();
    if (plan.scenes.empty() || is_asked) names.push_back(picture.name);
  }
  return names;
}

RenderBenchReport run_render(const RenderPlanOfBench& plan, Progress& progress,
                             const std::function<void(const RenderBenchReport&, const RenderPictureReport&)>& see) {
  RenderBenchReport report{this_machine(), plan, {}, {}};
  const bool has_povray = plan.has_povray && plan.only.empty();
  std::optional<Povray> povray = has_povray ? Povray::find() : std::nullopt;
  if (povray) report.povray_version = povray->version();
  const std::vector<std::string> names = names_of(plan);
  for (const RenderPicture& picture : render_pictures()) {
    if (std::find(names.begin(), names.end(), picture.name) == names.end()) continue;
    progress.say(picture.name, "verifying");
    Stage stage(plan, picture, povray ? &*povray : nullptr);
    if (!plan.only.empty()) {
      Canvas canvas(plan.width, plan.height);
      paint_once([&] { stage.paint(plan.only, canvas); });
      continue;
    }
    stage.verify();
    stage.measure(progress);
    progress.clear();
    report.pictures.push_back(std::move(stage.report()));
    see(report, report.pictures.back());
  }
  return report;
}

}  // namespace sightline::bench
