#include "bench/claims/tools.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "bench/processor_time.h"
#include "bench/rotation.h"
#include "bench/text_table.h"
#include "bench/verify.h"
#include "sightline/query/accelerator_spec.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/procedural.h"

namespace sightline::bench {
namespace {

volatile double sink;  ///< Results end here, so that nothing of a pass is left out.

double seconds_of(const Line& line, int passes) {
  const double begin = processor_seconds();
  double sum = 0;
  for (int i = 0; i < passes; ++i) sum += line.pass();
  sink = sum;
  return processor_seconds() - begin;
}

}  // namespace

void on_one_thread(const std::function<void()>& run) {
  tbb::task_arena arena(1);
  arena.execute(run);
}

TracerPtr traced(const std::string& spec, const MeshPtr& mesh) {
  AcceleratorSpec parsed = parse_accelerators(spec).front();
  parsed.settings.threads = 1;
  return make_tracer(parsed.accelerator, mesh, parsed.settings);
}

std::vector<Ray<float>> mixed_rays(const MeshPtr& mesh, std::size_t count, std::uint64_t seed) {
  const TracerPtr tracer = traced("wide-tree", mesh);
  std::vector<Ray<float>> rays = random_rays(mesh->bounds(), (count + 1) / 2, seed), bounces;
  // Few rays may hit, so several rounds of them bounce.
  for (std::uint64_t more = 1; more <= 8 && rays.size() < count; ++more) {
    const auto first = random_rays(mesh->bounds(), count, seed + 1000 * more);
    std::vector<Hit<float>> hits(first.size());
    tracer->closest_hits(std::span(first), std::span(hits));
    bounces = bounce_rays(*mesh, first, hits, seed + more);
    bounces.resize(std::min(bounces.size(), count - rays.size()));
    rays.insert(rays.end(), bounces.begin(), bounces.end());
  }
  return rays;
}

void require_same_hits(const std::string& place, std::span<const TracerPtr> tracers, std::span<const Ray<float>> rays) {
  std::vector<Hit<float>> expected(rays.size()), found(rays.size());
  tracers.front()->closest_hits(rays, std::span(expected));
  for (const TracerPtr& tracer : tracers.subspan(1)) {
    tracer->closest_hits(rays, std::span(found));
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (is_same(expected[i], found[i])) continue;
      throw WrongHits(place + " ray " + std::to_string(i) + ": " + std::string(tracers.front()->name()) + " finds " +
                      hit_text(expected[i]) + ", " + std::string(tracer->name()) + " " + hit_text(found[i]) +
                      ", so nothing is timed");
    }
  }
}

Work work_of(const Tracer& tracer, std::span<const Ray<float>> rays) {
  std::vector<Hit<float>> hits(rays.size());
  TraversalStats stats;
  tracer.closest_hits(rays, std::span(hits), stats);
  const double count = static_cast<double>(std::max<std::size_t>(1, rays.size()));
  return {static_cast<double>(stats.nodes) / count, static_cast<double>(stats.leaves) / count,
          static_cast<double>(stats.candidates) / count};
}

Line ray_line(const TracerPtr& tracer, const std::vector<Ray<float>>& rays) {
  auto hits = std::make_shared<std::vector<Hit<float>>>(rays.size());
  return {[tracer, &rays, hits] {
            tracer->closest_hits(std::span<const Ray<float>>(rays), std::span(*hits));
            return static_cast<double>(hits->back().prim_id);
          },
          static_cast<double>(rays.size())};
}

Estimate Times::nanoseconds(std::size_t line) const { return scaled(known(estimate_of_present(rounds_[line])), 1e9); }

Estimate Times::ratio(std::size_t over, std::size_t under) const {
  return known(paired_ratio(rounds_[over], rounds_[under]));
}

Times time_lines(const Effort& effort, const std::string& what, std::span<const Line> lines, double line_seconds) {
  const double slot_seconds = effort.share * (effort.is_quick ? 0.003 : 0.02);
  const auto rounds = static_cast<std::size_t>(effort.rounds);
  std::vector<int> passes;
  for (const Line& line : lines) {
    const double once = seconds_of(line, 1);
    passes.push_back(std::max(1, static_cast<int>(std::ceil(slot_seconds / std::max(once, 0x1p-30)))));
  }
  std::vector<std::vector<double>> seconds(lines.size(), std::vector<double>(rounds, not_asked));
  in_rotation(
      {rounds, lines.size(), line_seconds},
      [&](const std::string& round) { effort.say("timing " + what + ", " + round); },
      [&](std::size_t line, std::size_t round) {
        const double taken = seconds_of(lines[line], passes[line]);
        seconds[line][round] = taken / passes[line] / lines[line].units;
        return taken;
      });
  return Times(std::move(seconds));
}

std::vector<std::size_t> growing_sizes(const Effort& effort, std::size_t full_limit, std::size_t quick_limit) {
  const std::size_t limit = effort.count(full_limit, quick_limit);
  std::vector<std::size_t> sizes;
  for (int half = 0;; ++half) {
    const std::size_t size =
        static_cast<std::size_t>(std::lround(std::min(1.0, effort.share) * 1000 * std::pow(10.0, half / 2.0)));
    if (size > limit) return sizes;
    sizes.push_back(size);
  }
}

MeshPtr mesh_of(std::string_view family, std::size_t triangles) {
  if (family == "soup") return std::make_shared<const TriangleMesh>(make_soup(static_cast<int>(triangles)));
  const int cells = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
  return std::make_shared<const TriangleMesh>(make_terrain(std::max(1, cells)));
}

Growth growth_of(std::string name, std::string x_unit, std::string y_unit, std::vector<double> x, std::vector<double> y,
                 std::string chart) {
  Growth growth{std::move(name), std::move(x_unit), std::move(y_unit), std::move(x), std::move(y), {},
                std::move(chart)};
  growth.fit = fit_power(growth.x, growth.y);
  return growth;
}

}  // namespace sightline::bench
