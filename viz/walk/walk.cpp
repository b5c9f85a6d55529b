#include "viz/walk/walk.h"

#include <algorithm>
#include <unordered_set>

#include "sightline/query/queries.h"

namespace sightline::viz {
namespace {

using Kind = WalkStep::Kind;

/// A leaf's candidates one by one, as closest_hit() takes them.
class CandidateSteps {
 public:
  CandidateSteps(const Tracer& tracer, const Ray<float>& ray)
      : tracer_(tracer), ray_(ray), prepared_(tracer.mesh().prepare(to_double(ray))) {}

  float far() const { return std::min(best_.t, ray_.t_max); }

  void add(const WalkRecorder::Step& leaf, std::vector<WalkStep>& steps) {
    for (const std::uint32_t id : tracer_.leaf_order().subspan(leaf.range.first, leaf.range.count)) {
      WalkStep step{.kind = Kind::candidate, .node = leaf.node, .triangle = id};
      Crossing crossing;
      if (prepared_.intersect(tracer_.mesh()[id], crossing)) {
        const auto t = detail::parameter<float>(crossing);
        const Hit<float> before = best_;
        detail::keep_closer(ray_, id, crossing, best_);
        step.t = t;
        step.is_crossed = detail::is_in_range(ray_, t);
        step.is_hit = best_ != before;
      }
      step.far = far();
      steps.push_back(step);
    }
  }

 private:
  const Tracer& tracer_;
  const Ray<float>& ray_;
  TriangleRay prepared_;
  Hit<float> best_;
};

}  // namespace

TraversalStats Walk::statistics() const {
  TraversalStats stats;
  for (const WalkStep& step : steps) {
    stats.nodes += step.kind == Kind::visit;
    stats.leaves += step.kind == Kind::leaf;
    stats.candidates += step.kind == Kind::candidate;
    stats.culled += step.kind == Kind::cull;
  }
  return stats;
}

std::vector<std::size_t> Walk::pending(std::size_t step) const {
  std::vector<std::size_t> put_aside;
  if (!puts_aside_) return put_aside;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].opened || *cells[i].opened <= step) continue;
    // Structures that open several levels at once name none of the nodes between.
    std::optional<std::size_t> above = cells[i].parent;
    while (above && !cells[*above].opened) above = cells[*above].parent;
    if (above && *cells[*above].opened <= step) put_aside.push_back(i);
  }
  std::ranges::sort(put_aside, {}, [&](std::size_t i) { return *cells[i].opened; });
  return put_aside;
}

Hit<float> Walk::hit_at(std::size_t step) const {
  Hit<float> best;
  for (std::size_t i = 0; i <= step && i < steps.size(); ++i) {
    if (steps[i].is_hit) best = {static_cast<float>(steps[i].t), steps[i].triangle};
  }
  return best;
}

Walk record_walk(const Tracer& tracer, const Ray<float>& ray) {
  Walk walk;
  walk.ray = ray;
  walk.puts_aside_ = tracer.name() != "grid" && tracer.name() != "brute-force";
  WalkRecorder recorder;
  walk.hit = tracer.record(ray, recorder);

  CandidateSteps candidates(tracer, ray);
  std::unordered_map<std::uint32_t, std::size_t> opened;
  for (const WalkRecorder::Step& step : recorder.steps) {
    const Kind kind = step.event == WalkRecorder::Event::node   ? Kind::visit
                      : step.event == WalkRecorder::Event::leaf ? Kind::leaf
                                                                : Kind::cull;
    opened.emplace(step.node, walk.steps.size());
    walk.steps.push_back({.kind = kind, .node = step.node, .t = step.t, .far = candidates.far()});
    if (kind == Kind::leaf) candidates.add(step, walk.steps);
  }

  // The cells from the root down to the one that is being shown; index: of those that are kept already.
  struct Level {
    Cell cell;
    std::optional<std::size_t> index;
  };
  std::vector<Level> path;
  const auto keep = [&](std::size_t level) {
    for (std::size_t i = 0; i <= level; ++i) {
      if (path[i].index) continue;
      path[i].index = walk.cells.size();
      const auto step = opened.find(path[i].cell.node);
      walk.by_node_.emplace(path[i].cell.node, walk.cells.size());
      walk.cells.push_back({path[i].cell, i > 0 ? path[i - 1].index : std::nullopt,
                            step == opened.end() ? std::nullopt : std::optional(step->second)});
    }
  };
  tracer.for_each_cell([&](const Cell& cell) {
    ++walk.all_cells;
    const auto level = static_cast<std::size_t>(cell.depth);
    path.resize(level);
    path.push_back({cell, std::nullopt});
    const bool is_beside = walk.puts_aside_ && level > 0 && opened.contains(path[level - 1].cell.node);
    const bool is_root = level == 0 && !opened.empty();
    if (is_root || is_beside || opened.contains(cell.node)) keep(level);
  });
  // Grids keep no empty cells, though rays pass through them.
  for (const WalkStep& step : walk.steps) {
    if (!walk.cells.empty()) walk.by_node_.emplace(step.node, 0);
  }
  return walk;
}

}  // namespace sightline::viz
