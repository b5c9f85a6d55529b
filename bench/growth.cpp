#include "bench/growth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/peers/peers.h"
#include "bench/rounds.h"
#include "bench/stage.h"
#include "bench/text_table.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

constexpr std::string_view soup = "soup", terrain = "terrain";

const ContenderReport* find(const SceneReport& scene, const std::string& name) {
  const auto found = std::find_if(scene.contenders.begin(), scene.contenders.end(),
                                  [&](const ContenderReport& contender) { return contender.name == name; });
  return found == scene.contenders.end() ? nullptr : &*found;
}

/// Of one build, or of one ray.
std::optional<Estimate> seconds_each(const ContenderReport& contender, Workload workload) {
  const auto& own = contender.at[index_of(workload)];
  if (!own || !own->seconds || own->rays == 0) return std::nullopt;
  return scaled(*own->seconds, 1 / static_cast<double>(own->rays));
}

std::string exponent_text(const PowerFit& fit) {
  char text[64];
  std::snprintf(text, sizeof text, fit.standard_error ? "%.2f +- %.2f" : "%.2f", fit.exponent,
                fit.standard_error.value_or(0));
  return text;
}

}  // namespace

bool is_growth_family(std::string_view name) { return name == soup || name == terrain; }

std::vector<std::string> growth_scenes(std::string_view family, std::size_t limit) {
  std::vector<std::string> scenes;
  for (int half_decades = 6;; ++half_decades) {
    const double triangles = std::pow(10, 0.5 * half_decades);
    if (triangles > 1.1 * static_cast<double>(limit)) break;  // 3162 for a limit of 3000
    const double size = family == terrain ? std::sqrt(0.5 * triangles) : triangles;
    scenes.push_back(std::string(family) + ':' + std::to_string(std::lround(size)));
  }
  return scenes;
}

std::vector<GrowthLine> growth_of(std::span<const SceneReport> scenes) {
  std::vector<GrowthLine> lines;
  if (scenes.empty()) return lines;
  for (const ContenderReport& first : scenes.front().contenders) {
    GrowthLine line{first.name, first.built_as.has_value(), {}, 0};
    for (const SceneReport& scene : scenes) {
      if (line.left_out_from == 0 && !find(scene, first.name)) line.left_out_from = scene.triangles;
    }
    for (const WorkloadInfo& info : workload_infos) {
      std::vector<double> triangles, seconds;
      for (const SceneReport& scene : scenes) {
        const ContenderReport* contender = find(scene, first.name);
        const auto each = contender ? seconds_each(*contender, info.workload) : std::nullopt;
        if (!each || !(each->median > 0)) continue;
        triangles.push_back(static_cast<double>(scene.triangles));
        seconds.push_back(each->median);
      }
      line.fit[index_of(info.workload)] = fit_power(triangles, seconds);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<SceneReport> run_growth(const Plan& plan, Progress& progress) {
  std::vector<SceneReport> reports;
  Contenders contenders = make_contenders(plan);
  std::vector<double> build_seconds(contenders.size(), 0);
  std::size_t triangles = 0;  // of the size before
  for (const std::string& scene : growth_scenes(plan.growth, plan.growth_limit)) {
    progress.say("making " + scene);
    const auto mesh = load_scene(scene, plan.data_dir);
    // No structure builds in less than linear time.
    const double growth = triangles == 0 ? 1 : static_cast<double>(mesh->size()) / static_cast<double>(triangles);
    Contenders fast;
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      const bool is_reference = contenders[c]->name() == reference_peer;
      if (is_reference || growth * build_seconds[c] <= plan.growth_build_seconds())
        fast.push_back(std::move(contenders[c]));
    }
    contenders = std::move(fast);
    triangles = mesh->size();

    std::vector<Stage> stages;
    stages.emplace_back(plan, scene, mesh, contenders, progress);
    build_seconds = stages[0].first_build_seconds();
    run_rounds(stages, plan, progress, [](const SceneReport&) {});
    reports.push_back(stages[0].report());
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      // The first build also paid for memory that nothing had touched before.
      const auto& timed = reports.back().contenders[c].at[index_of(Workload::build)];
      if (timed && timed->seconds) build_seconds[c] = std::min(build_seconds[c], timed->seconds->median);
    }
  }
  progress.clear();
  return reports;
}

std::string growth_text(std::span<const SceneReport> scenes, const Plan& plan) {
  std::string text = "Growth of " + plan.growth +
                     "; exponents: time ~ triangles^x by least squares in logarithms, with standard "
                     "error.\nn log n shows as about 1.1, log n as about 0.1, more where a cache is outgrown.\n";
  const std::vector<GrowthLine> lines = growth_of(scenes);
  for (const Workload w : plan.workloads) {
    const bool is_build = w == Workload::build;
    TextTable table;
    table.add_column("", "structure");
    for (const SceneReport& scene : scenes) {
      table.add_column(is_build ? "ms to build so many triangles"
                                : "microseconds a " + std::string(workload_infos[index_of(w)].name) + " ray",
                       count_text(scene.triangles));
    }
    table.add_column("", "exponent");
    for (const GrowthLine& line : lines) {
      if (line.is_shared && is_build) continue;
      std::vector<std::string> row{line.name};
      for (const SceneReport& scene : scenes) {
        const ContenderReport* contender = find(scene, line.name);
        const auto each = contender ? seconds_each(*contender, w) : std::nullopt;
        row.push_back(each ? measured_text(scaled(*each, is_build ? 1e3 : 1e6)) : "-");
      }
      const auto& fit = line.fit[index_of(w)];
      row.push_back(fit ? exponent_text(*fit) : "-");
      table.add_row(std::move(row));
    }
    text += '\n' + table.text();
  }
  std::size_t fewest = scenes.empty() ? 0 : scenes[0].sampled_rays;
  for (const SceneReport& scene : scenes) fewest = std::min(fewest, scene.sampled_rays);
  text += "\nHits: ours have the same bits on all rays, and brute force's on " + count_text(fewest) +
          " or more of each kind and size.\n";
  for (const GrowthLine& line : lines) {
    if (line.left_out_from == 0) continue;
    text += line.name + " is left out from " + count_text(line.left_out_from) +
            " triangles on: building it would take longer than " + number_text(plan.growth_build_seconds(), 2) +
            " s.\n";
  }
  return text;
}

}  // namespace sightline::bench
