#pragma once
/// What several structures make of the same ray, and of the same picture's rays.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "viz/traced_picture.h"
#include "viz/walk/walk.h"

namespace sightline::viz {

/// One of those that are compared.
struct Compared {
  std::string label;  ///< As it was asked for: "kd-tree:max_leaf_size=8".
  std::shared_ptr<const Tracer> tracer;
};

/// Which steps of a traversal are counted.
enum class WorkKind : std::uint8_t {
  nodes,       ///< Cells opened: inner nodes, leaves, and cells that hold nothing.
  candidates,  ///< Triangles tested.
  all          ///< Both.
};
inline constexpr WorkKind work_kinds[] = {WorkKind::nodes, WorkKind::candidates, WorkKind::all};
std::string_view name_of(WorkKind kind);
/// "cells opened", "candidates tested", "steps": what numbers of this kind count.
std::string_view unit_of(WorkKind kind);

/// The walks of a ray through all. A lazy structure has grown for it before, so that a walk does not depend on what was
/// asked for earlier.
std::vector<Walk> walks_of(std::span<const Compared> compared, const Ray<float>& ray);

/// The same for a picture's rays; lazy structures as above.
TracedPicture trace_grown(const Tracer& tracer, const Camera& camera);

std::vector<std::uint32_t> work_of(const TracedPicture& picture, WorkKind kind);

/// Bit for bit, which tells zeros of either sign apart.
bool is_same(const Hit<float>& a, const Hit<float>& b);

/// Which structures have another hit than the first one, in their order.
std::vector<std::size_t> dissenters(std::span<const Walk> walks);
std::size_t differing_pixels(const TracedPicture& a, const TracedPicture& b);

/// Steps at which cells are opened for the first time, in that order. (A grid counts one for each empty part of a cell
/// that is cut again, by that cell's number.)
std::vector<std::size_t> openings(const Walk& walk);

}  // namespace sightline::viz
