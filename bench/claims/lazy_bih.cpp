#include <algorithm>
#include <cmath>

#include "bench/claims/course.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "bench/processor_time.h"
#include "bench/rotation.h"
#include "bench/verify.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

/// The ways to have a tree. An eager one of a user copies triangles into its leaves; that without is the same but for
/// when nodes are made.
enum Way { lazy, eager, eager_copied, way_count };

std::unique_ptr<Tracer> build(Way way, const MeshPtr& mesh) {
  TracerSettings settings{{}, way == eager_copied, 1};
  if (way == lazy) settings.options.push_back({"lazy", "true"});
  return make_tracer("bih", mesh, settings);
}

std::size_t inner_nodes(const Tracer& tracer) {
  std::size_t count = 0;
  tracer.for_each_cell([&](const Cell& cell) { count += !cell.is_leaf; });
  return count;
}

/// Seconds from the mesh to the answers of as many rays, by their numbers.
std::vector<double> run(Way way, const MeshPtr& mesh, std::span<const Ray<float>> rays,
                        std::span<const std::size_t> counts, std::vector<Hit<float>>& hits) {
  std::vector<double> seconds;
  const double begin = processor_seconds();
  const auto tracer = build(way, mesh);
  std::size_t done = 0;
  for (const std::size_t count : counts) {
    tracer->closest_hits(rays.subspan(done, count - done), std::span(hits).subspan(done, count - done));
    done = count;
    seconds.push_back(processor_seconds() - begin);
  }
  return seconds;
}

/// Share of the inner nodes that are made after as many rays; checks hits against those of the eager tree.
std::vector<double> made_shares(const std::string& scene, const MeshPtr& mesh, std::span<const Ray<float>> rays,
                                std::span<const std::size_t> counts) {
  const auto tracer = build(lazy, mesh), whole = build(eager, mesh);
  const double all = static_cast<double>(std::max<std::size_t>(1, inner_nodes(*whole)));
  std::vector<Hit<float>> found(rays.size()), expected(rays.size());
  whole->closest_hits(rays, std::span(expected));
  std::vector<double> shares;
  std::size_t done = 0;
  for (const std::size_t count : counts) {
    tracer->closest_hits(rays.subspan(done, count - done), std::span(found).subspan(done, count - done));
    done = count;
    shares.push_back(static_cast<double>(inner_nodes(*tracer)) / all);
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (is_same(found[i], expected[i])) continue;
    throw WrongHits(scene + " ray " + std::to_string(i) + ": the lazy tree finds " + hit_text(found[i]) +
                    ", the eager one " + hit_text(expected[i]) + ", so nothing is timed");
  }
  return shares;
}

/// By way, checkpoint and round.
using Rounds = std::array<std::vector<std::vector<double>>, way_count>;

/// The number of rays at which the other way overtakes the lazy one, by rounds: between two numbers on a line in
/// logarithms of the ratio. That of the last rays where it has not until then.
Estimate break_even(std::span<const std::size_t> counts, const Rounds& rounds, Way other) {
  std::vector<double> crossings;
  for (std::size_t round = 0; round < rounds[lazy].front().size(); ++round) {
    double before = -1, last = 0, crossing = static_cast<double>(counts.back());
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double now = std::log(rounds[lazy][k][round] / rounds[other][k][round]);
      const double count = std::log(static_cast<double>(counts[k]));
      if (std::isnan(now)) crossing = now;
      if (now >= 0) {
        crossing = k == 0 ? 1 : std::exp(last + (count - last) * -before / (now - before));
        break;
      }
      before = now, last = count;
    }
    crossings.push_back(crossing);
  }
  return known(estimate_of_present(crossings));
}

void measure_scene(const Effort& effort, const std::string& scene, Finding& finding,
                   std::vector<Condition>& conditions) {
  effort.say(scene);
  const MeshPtr mesh = load_scene(scene, effort.data_dir);
  std::vector<std::size_t> counts;
  const std::size_t most = effort.count(1'000'000, 100'000);
  for (std::size_t count = 1; count <= most; count *= 10) counts.push_back(count);
  const auto rays = random_rays(mesh->bounds(), counts.back(), effort.seed);
  const auto shares = made_shares(scene, mesh, rays, counts);
  std::vector<Hit<float>> hits(rays.size());
  Rounds rounds;
  const auto round_count = static_cast<std::size_t>(effort.rounds);
  for (auto& way : rounds) way.assign(counts.size(), std::vector<double>(round_count, not_asked));
  in_rotation(
      {round_count, way_count, effort.is_quick ? 1.0 : 20.0},
      [&](const std::string& round) { effort.say("timing " + scene + ", " + round); },
      [&](std::size_t way, std::size_t round) {
        const auto seconds = run(static_cast<Way>(way), mesh, rays, counts, hits);
        for (std::size_t k = 0; k < counts.size(); ++k) rounds[way][k][round] = seconds[k];
        return seconds.back();
      });

  std::vector<double> x(counts.begin(), counts.end());
  const char* const names[] = {"lazy", "eager", "eager, triangles copied"};
  for (std::size_t way = 0; way < way_count; ++way) {
    std::vector<double> ms;
    for (const auto& k : rounds[way]) ms.push_back(1e3 * known(estimate_of_present(k)).median);
    finding.growths.push_back(
        {scene + ": building and rays, " + names[way], "rays", "ms", x, std::move(ms), {}, scene});  // no power law
  }
  finding.growths.push_back(
      {scene + ": share of inner nodes made", "rays", "", x, shares, {}, "share of inner nodes made"});
  const Figure first{scene + ": time to the first answer, eager over lazy",
                     known(paired_ratio(rounds[eager].front(), rounds[lazy].front())), "x"};
  const Figure made = exact_figure(scene + ": inner nodes made by the first ray", 100 * shares.front(), "%");
  const std::string number = count_text(counts.back());
  const Figure last{scene + ": time of building and " + number + " rays, eager over lazy",
                    known(paired_ratio(rounds[eager].back(), rounds[lazy].back())), "x"};
  const Figure copied{scene + ": the same, eager with triangles copied over lazy",
                      known(paired_ratio(rounds[eager_copied].back(), rounds[lazy].back())), "x"};
  for (const Figure& figure : {first, made}) finding.figures.push_back(figure);
  finding.figures.push_back(
      exact_figure(scene + ": inner nodes made by " + number + " rays", 100 * shares.back(), "%"));
  for (const Figure& figure : {last, copied}) finding.figures.push_back(figure);
  for (const auto& [name, other] :
       {std::pair{"eager", eager}, std::pair{"eager with triangles copied", eager_copied}}) {
    finding.figures.push_back(
        {scene + ": rays from which on " + name + " is ahead", break_even(counts, rounds, other), "rays"});
  }
  conditions.push_back({Condition::Kind::needed, first, Side::above, 1});
  conditions.push_back({Condition::Kind::needed, made, Side::below, 50});
  conditions.push_back({Condition::Kind::wanted, last, Side::above, 1});
  conditions.push_back({Condition::Kind::wanted, copied, Side::above, 1});
}

Finding measure_lazy_bih(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  const auto size = [&](std::size_t full, std::size_t quick) { return std::to_string(effort.count(full, quick)); };
  on_one_thread([&] {
    measure_scene(effort, "teapot:" + size(48, 24), finding, conditions);
    measure_scene(effort, "terrain:" + size(400, 120), finding, conditions);
    measure_scene(effort, "soup:" + size(300'000, 30'000), finding, conditions);
  });
  conclude(finding, conditions,
           "Few rays are answered long before a whole tree would stand; for many, building beforehand is ahead");
  return finding;
}

}  // namespace

const Claim lazy_bih_claim{
    "lazy_bih", "A bounding interval hierarchy can be built as rays are fired.",
    "Trees that divide a node when the first ray reaches it, and trees built beforehand, each from the mesh to the "
    "answers of 1, 10, ... 1,000,000 (quick: 100,000) rays between random points around the scene; one thread's "
    "processor time. A tree built beforehand may also copy its triangles into its leaves, as it does unless told "
    "otherwise. All hits are the same, or nothing is timed.",
    "Holds if the first answer comes sooner from the lazy tree, with fewer than half of the nodes made, and the last "
    "one too; holds with a limit if by the last ray building beforehand is ahead.",
    measure_lazy_bih};

}  // namespace sightline::bench
