#include "viz/partition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

namespace sightline::viz {
namespace {

double volume(const Aabb& box) {
  const Vec3d e = Vec3d(box.hi) - Vec3d(box.lo);
  return box.is_empty() ? 0 : e.x * e.y * e.z;
}
double volume(const Sphere& sphere) {
  const double r = sphere.radius;
  return 4 * std::numbers::pi / 3 * r * r * r;
}
double volume(const Cylinder& cylinder) {
  const double r = cylinder.radius;
  return std::numbers::pi * r * r * 2 * cylinder.half_length;
}

/// Sum of the signed cones from one vertex to the faces.
double volume(const Polyhedron& solid) {
  double six_volumes = 0;
  for (const auto& face : solid.faces) {
    const Vec3d apex = solid.vertices[solid.faces[0][0]], a = solid.vertices[face[0]] - apex;
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Vec3d b = solid.vertices[face[i - 1]] - apex, c = solid.vertices[face[i]] - apex;
      six_volumes += glm::dot(a, glm::cross(b, c));
    }
  }
  return std::fabs(six_volumes) / 6;
}

Extent extent(const Aabb& box, int axis) { return {box.lo[axis], box.hi[axis]}; }
Extent extent(const Sphere& sphere, int axis) {
  return {double(sphere.center[axis]) - sphere.radius, double(sphere.center[axis]) + sphere.radius};
}
Extent extent(const Cylinder& cylinder, int axis) {
  const double along = cylinder.axis[axis];
  const double half =
      std::fabs(along) * cylinder.half_length + cylinder.radius * std::sqrt(std::fmax(0, 1 - along * along));
  return {cylinder.center[axis] - half, cylinder.center[axis] + half};
}
Extent extent(const Polyhedron& solid, int axis) {
  Extent all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3d& p : solid.vertices) all = {std::fmin(all.lo, p[axis]), std::fmax(all.hi, p[axis])};
  return all;
}

/// How many cells of each depth pass the filter, whatever its depth range.
std::vector<std::size_t> count_by_depth(const Tracer& tracer, const auto& passes, Partition& partition,
                                        std::size_t& readable) {
  std::vector<std::size_t> counts;
  tracer.for_each_cell([&](const Cell& cell) {
    ++partition.total;
    partition.total_deepest = std::max(partition.total_deepest, cell.depth);
    if (cell.depth == 0) readable = CellFilter::readable_cells(cell);
    if (!passes(cell)) return;
    counts.resize(std::max(counts.size(), static_cast<std::size_t>(cell.depth) + 1));
    ++counts[static_cast<std::size_t>(cell.depth)];
  });
  return counts;
}

/// The deepest depth down to which no more than `readable` cells pass; at least the first that has any.
int readable_depth(const std::vector<std::size_t>& counts, int shallowest, std::size_t readable) {
  std::size_t sum = 0;
  int deepest = shallowest;
  for (int depth = shallowest; depth < static_cast<int>(counts.size()); ++depth) {
    const std::size_t count = counts[static_cast<std::size_t>(depth)];
    if (sum > 0 && sum + count > readable) break;
    sum += count;
    deepest = depth;
  }
  return deepest;
}

}  // namespace

double Slice::position(const Aabb& bounds) const {
  return (1 - share) * double(bounds.lo[axis]) + share * double(bounds.hi[axis]);
}

std::size_t CellFilter::readable_cells(const Cell& root) {
  if (std::holds_alternative<Cylinder>(root.region)) return 33;
  return std::holds_alternative<Sphere>(root.region) ? 65 : 130;
}

Extent extent_along(const Cell& cell, int axis) {
  return std::visit([&](const auto& region) { return extent(region, axis); }, cell.region);
}

double volume_of(const Cell& cell) {
  return std::visit([](const auto& region) { return volume(region); }, cell.region);
}

Partition select_cells(const Tracer& tracer, const CellFilter& filter) {
  Partition partition;
  const double plane = filter.slice ? filter.slice->position(tracer.mesh().bounds()) : 0;
  const auto passes = [&](const Cell& cell) {
    if (filter.leaves_only && !cell.is_leaf) return false;
    if (!filter.slice) return true;
    const Extent along = extent_along(cell, filter.slice->axis);
    return along.lo <= plane && plane <= along.hi;
  };
  std::size_t readable = 0;
  const std::vector<std::size_t> counts = count_by_depth(tracer, passes, partition, readable);
  const bool shows_all_depths = filter.leaves_only || filter.slice;
  const int deepest = filter.deepest     ? *filter.deepest
                      : shows_all_depths ? partition.total_deepest
                                         : readable_depth(counts, filter.shallowest, readable);

  tracer.for_each_cell([&](const Cell& cell) {
    if (cell.depth >= filter.shallowest && cell.depth <= deepest && passes(cell)) partition.cells.push_back(cell);
  });
  partition.passing = partition.cells.size();
  if (partition.cells.size() > filter.max_cells) {
    std::vector<std::pair<double, std::size_t>> by_volume;
    for (std::size_t i = 0; i < partition.cells.size(); ++i) by_volume.push_back({-volume_of(partition.cells[i]), i});
    std::sort(by_volume.begin(), by_volume.end());
    std::vector<Cell> largest;
    for (std::size_t i = 0; i < filter.max_cells; ++i) largest.push_back(partition.cells[by_volume[i].second]);
    partition.cells = std::move(largest);
  }
  std::stable_sort(partition.cells.begin(), partition.cells.end(),
                   [](const Cell& a, const Cell& b) { return a.depth < b.depth; });
  if (!partition.cells.empty()) {
    partition.shallowest = partition.cells.front().depth;
    partition.deepest = partition.cells.back().depth;
  }
  return partition;
}

}  // namespace sightline::viz
