#include "bench/render/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "bench/processor_time.h"
#include "bench/render/anew.h"
#include "bench/render/pictures.h"
#include "bench/render/stripped.h"
#include "bench/solids/povray.h"
#include "bench/verify.h"
#include "sightline/render/renderer.h"

namespace sightline::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int tile_side = 32;

/// A picture in tiles, kept between rounds so that only rendering is timed.
class Canvas {
 public:
  Canvas(int width, int height) {
    for (int y = 0; y < height; y += tile_side) {
      for (int x = 0; x < width; x += tile_side) {
        tiles_.emplace_back(TileRect{x, y, std::min(tile_side, width - x), std::min(tile_side, height - y)});
      }
    }
    for (std::uint32_t i = 0; i < tile_side * tile_side; ++i) pixels_.push_back(i);
  }

  template <class Paint>
  void paint(const Paint& paint) {
    for (TileBuffer& tile : tiles_) {
      std::fill(tile.sums.begin(), tile.sums.end(), PixelSum{});
      paint(tile, std::span<const std::uint32_t>(pixels_).first(tile.rect.pixels()));
    }
  }

  Picture gray(int width, int height) const {
    Picture picture(width, height);
    for (const TileBuffer& tile : tiles_) {
      for (std::size_t i = 0; i < tile.sums.size(); ++i) {
        const std::size_t x = static_cast<std::size_t>(tile.rect.x) + i % static_cast<std::size_t>(tile.rect.width);
        const std::size_t y = static_cast<std::size_t>(tile.rect.y) + i / static_cast<std::size_t>(tile.rect.width);
        picture.shades[y * static_cast<std::size_t>(width) + x] = static_cast<float>(tile.sums[i].color.x);
      }
    }
    return picture;
  }

  std::vector<TileBuffer>& tiles() { return tiles_; }
  std::size_t differing(const Canvas& other) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < tiles_.size(); ++k) {
      for (std::size_t i = 0; i < tiles_[k].sums.size(); ++i) count += !(tiles_[k].sums[i] == other.tiles_[k].sums[i]);
    }
    return count;
  }

 private:
  std::vector<TileBuffer> tiles_;
  std::vector<std::uint32_t> pixels_;
};

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
    const Picture own = reference.gray(plan_.width, plan_.height);
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
    const std::size_t count = report_.rows.size();
    for (RenderRow& row : report_.rows) row.round_seconds.assign(rounds, nan), row.round_elapsed.assign(rounds, nan);
    Canvas canvas(plan_.width, plan_.height);
    std::vector<double> spent(count);
    for (std::size_t round = 0; round < rounds; ++round) {
      progress.say(picture_.name, "round " + std::to_string(round + 1) + " of " + std::to_string(rounds));
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t line = (k + round) % count;
        if (spent[line] > plan_.row_seconds) continue;
        spent[line] += time(report_.rows[line], round, canvas);
      }
    }
    for (RenderRow& row : report_.rows) {
      row.seconds = estimate_of_present(row.round_seconds);
      row.over_plan = ratio(row.round_seconds, report_.rows[0].round_seconds);
      if (!povray_ || row.name == povray_line) continue;
      row.povray_over = ratio(report_.rows.back().round_seconds, row.round_seconds);
      row.povray_elapsed = ratio(report_.rows.back().round_elapsed, row.round_elapsed);
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

  static std::optional<Estimate> ratio(const std::vector<double>& over, const std::vector<double>& under) {
    std::vector<double> ratios(over.size());
    for (std::size_t i = 0; i < over.size(); ++i) ratios[i] = over[i] / under[i];
    return estimate_of_present(ratios);
  }

  const RenderPlanOfBench& plan_;
  const RenderPicture& picture_;
  Povray* povray_;
  Renderer special_, superset_;
  std::string text_;
  RenderPictureReport report_;
};

}  // namespace

RenderBenchReport run_render(const RenderPlanOfBench& plan, Progress& progress,
                             const std::function<void(const RenderBenchReport&, const RenderPictureReport&)>& see) {
  RenderBenchReport report{this_machine(), plan, {}, {}};
  const bool has_povray = plan.has_povray && plan.only.empty();
  std::optional<Povray> povray = has_povray ? Povray::find() : std::nullopt;
  if (povray) report.povray_version = povray->version();
  for (const RenderPicture& picture : render_pictures()) {
    const auto& names = plan.scenes;
    if (!names.empty() && std::find(names.begin(), names.end(), picture.name) == names.end()) continue;
    progress.say(picture.name, "verifying");
    Stage stage(plan, picture, povray ? &*povray : nullptr);
    if (!plan.only.empty()) {
      Canvas canvas(plan.width, plan.height);
      stage.paint(plan.only, canvas);
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
