#include "viz/compare/comparison.h"

#include <bit>
#include <unordered_set>

namespace sightline::viz {

std::string_view name_of(WorkKind kind) {
  return kind == WorkKind::nodes ? "nodes" : kind == WorkKind::candidates ? "candidates" : "all";
}

std::string_view unit_of(WorkKind kind) {
  return kind == WorkKind::nodes        ? "cells opened"
         : kind == WorkKind::candidates ? "candidates tested"
                                        : "steps (cells opened and candidates tested)";
}

std::vector<Walk> walks_of(std::span<const Compared> compared, const Ray<float>& ray) {
  std::vector<Walk> walks;
  for (const Compared& each : compared) {
    if (each.tracer->is_lazy()) record_walk(*each.tracer, ray);
    walks.push_back(record_walk(*each.tracer, ray));
  }
  return walks;
}

TracedPicture trace_grown(const Tracer& tracer, const Camera& camera) {
  if (tracer.is_lazy()) trace_picture(tracer, camera);
  return trace_picture(tracer, camera);
}

std::vector<std::uint32_t> work_of(const TracedPicture& picture, WorkKind kind) {
  if (kind == WorkKind::candidates) return picture.candidates;
  std::vector<std::uint32_t> work = picture.work;
  if (kind == WorkKind::nodes) {
    for (std::size_t i = 0; i < work.size(); ++i) work[i] -= picture.candidates[i];
  }
  return work;
}

bool is_same(const Hit<float>& a, const Hit<float>& b) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  return a.prim_id == b.prim_id && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

std::vector<std::size_t> dissenters(std::span<const Walk> walks) {
  std::vector<std::size_t> all;
  for (std::size_t i = 1; i < walks.size(); ++i) {
    if (!is_same(walks[i].hit, walks.front().hit)) all.push_back(i);
  }
  return all;
}

std::size_t differing_pixels(const TracedPicture& a, const TracedPicture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.hits.size(); ++i) count += !is_same(a.hits[i], b.hits[i]);
  return count;
}

std::vector<std::size_t> openings(const Walk& walk) {
  std::vector<std::size_t> steps;
  std::unordered_set<std::uint32_t> opened;
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep::Kind kind = walk.steps[i].kind;
    if (kind != WalkStep::Kind::visit && kind != WalkStep::Kind::leaf) continue;
    if (opened.insert(walk.steps[i].node).second) steps.push_back(i);
  }
  return steps;
}

}  // namespace sightline::viz
