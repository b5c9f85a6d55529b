#include "bench/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "bench/prices.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

std::string name_of(Workload workload) { return std::string(workload_infos[index_of(workload)].name); }

std::string percent_text(double share) { return number_text(100 * share, 2) + " %"; }

std::string thread_text(int threads) {
  return threads == 0 ? "all threads" : plural(static_cast<std::size_t>(threads), "thread");
}

std::vector<Workload> ray_workloads(const Plan& plan) {
  std::vector<Workload> list;
  std::copy_if(plan.workloads.begin(), plan.workloads.end(), std::back_inserter(list),
               [](Workload w) { return w != Workload::build; });
  return list;
}

std::string bytes_text(const ContenderReport& contender, std::size_t triangles) {
  if (contender.built_as) return "";
  if (triangles == 0) return "-";
  return number_text(static_cast<double>(contender.bytes.total()) / static_cast<double>(triangles));
}

void add_rows(TextTable& table, const SceneReport& scene, const Plan& plan) {
  const std::vector<Workload> traced = ray_workloads(plan);
  for (const ContenderReport& contender : scene.contenders) {
    std::vector<std::string> row{contender.name};
    if (plan.has(Workload::build)) {
      const Measurement& build = *contender.at[index_of(Workload::build)];
      row.push_back(contender.built_as ? "" : build.seconds ? measured_text(scaled(*build.seconds, 1e3)) : "-");
    }
    row.push_back(bytes_text(contender, scene.triangles));
    for (const Workload w : traced) {
      const Measurement& own = *contender.at[index_of(w)];
      const auto rate = own.mrays_per_second();
      row.push_back(rate ? measured_text(*rate) : "-");
      row.push_back(own.ratio ? '(' + measured_text(*own.ratio) + "x)" : "");
    }
    if (!traced.empty()) {
      const Measurement& first = *contender.at[index_of(traced.front())];
      const double rays = static_cast<double>(first.rays);
      const bool is_counted = first.stats && first.rays > 0;
      row.push_back(is_counted ? number_text(static_cast<double>(first.stats->nodes) / rays) : "-");
      row.push_back(is_counted ? number_text(static_cast<double>(first.stats->candidates) / rays) : "-");
    }
    table.add_row(std::move(row));
  }
}

/// Of the contenders that were asked all.
std::size_t rays_at(const SceneReport& scene, Workload workload) {
  std::size_t rays = 0;
  for (const ContenderReport& contender : scene.contenders) {
    rays = std::max(rays, contender.at[index_of(workload)]->rays);
  }
  return rays;
}

/// Which rays there were, and how many of them hit.
std::string rays_line(const SceneReport& scene, const Plan& plan) {
  std::vector<std::string> parts;
  for (const Workload w : ray_workloads(plan)) {
    const std::size_t rays = rays_at(scene, w);
    const double share = scene.contenders.empty() ? 0 : scene.contenders[0].at[index_of(w)]->hit_share;
    parts.push_back(count_text(rays) + ' ' + name_of(w) + (rays == 0 ? "" : " (" + percent_text(share) + " hit)"));
  }
  return parts.empty() ? "" : "; rays: " + joined(parts);
}

/// What was verified, and where the peers found something else.
std::string verification_note(const SceneReport& scene, const Plan& plan) {
  std::string text = "Hits: ours have the same bits on all rays, and brute force's on " +
                     count_text(scene.sampled_rays) + " of each kind.\n";
  std::vector<std::string> agreeing;
  for (const ContenderReport& contender : scene.contenders) {
    if (contender.kind != Contender::Kind::peer || ray_workloads(plan).empty()) continue;
    std::vector<std::string> parts;
    for (const Workload w : ray_workloads(plan)) {
      const Measurement& own = *contender.at[index_of(w)];
      if (own.disagreeing_rays == 0) continue;
      const double share = static_cast<double>(own.disagreeing_rays) / static_cast<double>(own.rays);
      parts.push_back(count_text(own.disagreeing_rays) + ' ' + name_of(w) + " (" + percent_text(share) + ')');
    }
    if (parts.empty())
      agreeing.push_back(contender.name);
    else
      text += "      " + contender.name + " finds others, beyond its rounding: " + joined(parts) + ".\n";
  }
  if (!agreeing.empty()) {
    text += "      " + joined(agreeing) + (agreeing.size() == 1 ? " agrees" : " agree") + ", within the rounding.\n";
  }
  return text;
}

/// How many rounds stand behind the figures, and how far they scatter.
std::string rounds_note(const SceneReport& scene, const Plan& plan) {
  std::vector<std::string> fewer;
  const Estimate* widest = nullptr;
  std::string widest_name;
  for (const ContenderReport& contender : scene.contenders) {
    for (const Workload w : plan.workloads) {
      const Measurement& own = *contender.at[index_of(w)];
      if (contender.built_as && w == Workload::build) continue;
      if (own.rounds < plan.rounds && own.rays > 0) {
        fewer.push_back(contender.name + ' ' + name_of(w) + ' ' + std::to_string(own.rounds));
      }
      if (!own.ratio || w == Workload::build || contender.is_asked_fewer || own.rounds < 2) continue;
      const auto width = [](const Estimate& e) { return (e.high - e.low) / e.median; };
      if (!widest || width(*own.ratio) > width(*widest)) {
        widest = &*own.ratio;
        widest_name = contender.name + ' ' + name_of(w);
      }
    }
  }
  std::string text = "Times: medians of " + plural(static_cast<std::size_t>(plan.rounds), "round") +
                     (fewer.empty() ? "" : "; fewer of the slow: " + joined(fewer)) + ".\n";
  if (widest && widest->high > widest->low) {
    char interval[64];
    std::snprintf(interval, sizeof interval, "%.3g to %.3g", widest->low, widest->high);
    text += "       Least certain ratio: " + widest_name + ", " + interval + " (" +
            number_text(100 * widest->confidence, 2) + " % interval).\n";
  }
  return text;
}

/// Contenders that were not asked all rays, those with the same number together.
std::string fewer_rays_note(const SceneReport& scene, const Plan& plan) {
  std::size_t all = 0;
  for (const Workload w : ray_workloads(plan)) all = std::max(all, rays_at(scene, w));
  std::map<std::size_t, std::vector<std::string>> names;
  for (const ContenderReport& contender : scene.contenders) {
    std::size_t most = 0;
    for (const Workload w : ray_workloads(plan)) most = std::max(most, contender.at[index_of(w)]->rays);
    if (contender.is_asked_fewer && most < all) names[most].push_back(contender.name);
  }
  std::string text;
  for (const auto& [rays, some] : names) {
    text += joined(some) + (some.size() == 1 ? " is" : " are") + " timed with " + count_text(rays) +
            " rays of each kind, picked at random.\n";
  }
  return text;
}

std::string oddities_note(const SceneReport& scene, const Plan& plan) {
  std::string text = fewer_rays_note(scene, plan);
  const auto is_shared = [](const ContenderReport& contender) { return contender.built_as.has_value(); };
  if (std::any_of(scene.contenders.begin(), scene.contenders.end(), is_shared)) {
    text += "Lines without memory ask the structure above them in another way; it is built once.\n";
  }
  for (const ContenderReport& contender : scene.contenders) {
    if (contender.asking && contender.asking->level != contender.level) {
      text += contender.name + " is " + std::string(bench::name_of(contender.level)) +
              " all the same: a lazy structure has no packed copies of triangles to test in float.\n";
    }
    if (contender.is_lazy() && !contender.built_as && !ray_workloads(plan).empty()) {
      const Measurement& own = *contender.at[index_of(ray_workloads(plan).front())];
      const double extra = own.first_pass_seconds - own.next_pass_seconds;
      text += contender.name + " goes on building while it is asked: the first pass of " +
              name_of(ray_workloads(plan).front()) + " rays took " + number_text(1e3 * std::max(0.0, extra), 2) +
              " ms longer than the next.\n";
    }
  }
  return text;
}

}  // namespace

std::string head_text(const Machine& machine, const Plan& plan) {
  std::string text = machine_text(machine, " beside Embree " + machine.embree_version);
  text +=
      "\nMrays/s  million rays a second, one by one on one thread; (0.25x): a quarter of Embree's speed, paired by "
      "round\n"
      "B/tri    bytes a triangle takes: nodes, leaf order, copies in the leaves\n";
  if (plan.has(Workload::build)) text += "build    with " + thread_text(plan.threads) + '\n';
  if (plan.levels.back() == Level::fast) text += "fast     decided in float throughout; without: exactly, watertight\n";
  if (plan.is_stream) text += "stream   all rays handed over together, several under way at once\n";
  return text;
}

std::string table_text(const SceneReport& scene, const Plan& plan) {
  TextTable table;
  const std::vector<Workload> traced = ray_workloads(plan);
  table.add_column("", "structure");
  if (plan.has(Workload::build)) table.add_column("build", "ms");
  table.add_column("memory", "B/tri");
  for (const Workload w : traced) {
    table.add_column(name_of(w), "Mrays/s");
    table.add_column(name_of(w), "(xEmbree)");
  }
  if (!traced.empty()) {
    table.add_column("per " + name_of(traced.front()) + " ray", "nodes");
    table.add_column("per " + name_of(traced.front()) + " ray", "candidates");
  }
  add_rows(table, scene, plan);
  return scene.name + ": " + plural(scene.triangles, "triangle") + rays_line(scene, plan) + "\n\n" + table.text() +
         prices_text(std::span(&scene, 1), plan) + '\n' + verification_note(scene, plan) + rounds_note(scene, plan) +
         oddities_note(scene, plan);
}

}  // namespace sightline::bench
