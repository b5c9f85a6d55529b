#include "bench/render/scaling.h"

#include <tbb/global_control.h>

#include <chrono>
#include <limits>

#include "bench/rotation.h"
#include "bench/verify.h"
#include "sightline/render/exposure.h"
#include "sightline/render/ray_count.h"
#include "sightline/render/renderer.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::shared_ptr<const Scene> scene_of(const std::string& name, const std::filesystem::path& data_dir) {
  const std::filesystem::path file = data_dir / "scenes" / (name + ".json");
  return std::make_shared<const Scene>(make_scene(std::filesystem::exists(file) ? file.string() : name, data_dir));
}

FilmState exposed(const Renderer& renderer, int threads) {
  const std::atomic<bool> stops = false;
  Film film(blank_film(renderer.width(), renderer.height(), renderer.samples(), 0));
  expose(film, renderer, {.threads = threads}, stops);
  return film.state();
}

RenderSettings settings_of(const ScalingPlan& plan) {
  RenderSettings settings;
  settings.width = plan.width;
  settings.height = plan.height;
  settings.samples = plan.samples;
  settings.level = plan.level;
  return settings;
}

void verify(const Renderer& renderer, const ScalingPlan& plan, ScalingSceneReport& report) {
  const FilmState reference = exposed(renderer, plan.threads.front());
  report.rays = rays_of(reference.counters);
  for (const int threads : plan.threads) {
    FilmState film = exposed(renderer, threads);
    if (std::to_string(threads) == plan.spoiled) film.sums.front().color.x += 1;
    if (film == reference) continue;
    throw WrongHits("the picture by " + std::to_string(threads) +
                    " threads is wrong, so no times are shown: " + report.name + ": expected that by " +
                    std::to_string(plan.threads.front()) + " to the last bit, found another");
  }
}

ScalingSceneReport measure(const std::string& name, const ScalingPlan& plan, Progress& progress) {
  ScalingSceneReport report;
  report.name = name;
  progress.say(name, "building");
  const auto scene = scene_of(name, plan.data_dir);
  const Clock::time_point start = Clock::now();
  const Renderer renderer(scene, settings_of(plan));
  report.build_seconds = seconds_since(start);
  report.integrator = renderer.plan().integrator;
  const auto rounds = static_cast<std::size_t>(plan.rounds);
  for (const int threads : plan.threads) {
    report.rows.push_back({threads, std::vector<double>(rounds, std::numeric_limits<double>::quiet_NaN()), {}, {}});
  }
  progress.say(name, "verifying");
  verify(renderer, plan, report);
  in_rotation(
      {rounds, report.rows.size(), plan.row_seconds}, [&](const std::string& round) { progress.say(name, round); },
      [&](std::size_t line, std::size_t round) {
        const Clock::time_point begin = Clock::now();
        exposed(renderer, report.rows[line].threads);
        return report.rows[line].round_seconds[round] = seconds_since(begin);
      });
  for (ThreadsRow& row : report.rows) {
    row.seconds = estimate_of_present(row.round_seconds);
    row.speed_up = paired_ratio(report.rows.front().round_seconds, row.round_seconds);
  }
  return report;
}

}  // namespace

std::vector<std::string> scaling_scenes() { return {"wood", "csg", "forest", "chess", "glass", "cornell"}; }

int most_threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

ScalingReport run_scaling(const ScalingPlan& plan, Progress& progress) {
  ScalingReport report{this_machine(), plan, {}};
  for (const std::string& name : plan.scenes) report.scenes.push_back(measure(name, plan, progress));
  progress.clear();
  return report;
}

}  // namespace sightline::bench
