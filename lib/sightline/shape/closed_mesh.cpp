#include "sightline/shape/closed_mesh.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

#include "sightline/math/rounding.h"

namespace sightline {
namespace {

using Corners = ClosedMesh::Corners;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("closed mesh: " + what); }

void check(const std::vector<Vec3d>& vertices, const std::vector<Corners>& triangles) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 64;
  if (triangles.empty()) refuse("expected triangles, found none");
  if (triangles.size() > most) refuse("expected fewer triangles, found " + std::to_string(triangles.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!is_finite(vertices[i])) refuse("vertex " + std::to_string(i) + ": expected finite numbers");
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t corner : triangles[i]) {
      if (corner >= vertices.size()) {
        refuse("triangle " + std::to_string(i) + ": expected vertices below " + std::to_string(vertices.size()) +
               ", found " + std::to_string(corner));
      }
    }
  }
}

/// For each vertex the first one at its place.
std::vector<std::uint32_t> places_of(const std::vector<Vec3d>& vertices) {
  const auto key = [&](std::uint32_t i) { return std::tie(vertices[i].x, vertices[i].y, vertices[i].z); };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<std::uint32_t> places(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_first = i == 0 || key(order[i]) != key(order[i - 1]);
    places[order[i]] = is_first ? order[i] : places[order[i - 1]];
  }
  return places;
}

struct Edge {
  std::uint32_t low, high;  ///< The places of its ends.
  bool rises;               ///< Goes from low to high.
  std::uint32_t triangle;
  std::uint32_t corner;  ///< Where it starts.
};

/// C1. Finds the first edge, in the order of the triangles, that has no counterpart.
void check_closed(const std::vector<Vec3d>& vertices, const std::vector<Corners>& triangles) {
  const std::vector<std::uint32_t> places = places_of(vertices);
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = places[triangles[i][corner]], to = places[triangles[i][(corner + 1) % 3]];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to, i, corner});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  std::optional<Edge> offender;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    long rising = 0;
    for (; last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high; ++last)
      rising += edges[last].rises ? 1 : -1;
    if (rising == 0) continue;
    const auto odd = std::find_if(edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end(),
                                  [&](const Edge& edge) { return edge.rises == (rising > 0); });
    if (!offender || std::tie(odd->triangle, odd->corner) < std::tie(offender->triangle, offender->corner))
      offender = *odd;
  }
  if (!offender) return;
  const Corners& corners = triangles[offender->triangle];
  const std::string from = std::to_string(corners[offender->corner]),
                    to = std::to_string(corners[(offender->corner + 1) % 3]);
  refuse("triangle " + std::to_string(offender->triangle) + ": expected its edge from vertex " + from + " to " + to +
         " to be another triangle's from " + to + " to " + from + ", found it open");
}

constexpr double largest = std::numeric_limits<float>::max();

/// Guarded: where x is beyond float, infinity.
float nearest(double x) { return std::fabs(x) > largest ? std::copysign(HUGE_VALF, x > 0 ? 1.f : -1.f) : float(x); }
/// Guarded: not below x.
float rounded_up(double x) { return x > largest ? HUGE_VALF : round_up(std::max(x, -largest)); }

}  // namespace

ClosedMesh::ClosedMesh(std::vector<Vec3d> vertices, std::vector<Corners> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
  check(vertices_, triangles_);
  check_closed(vertices_, triangles_);
  set_boxes();
}

void ClosedMesh::set_boxes() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  lo_ = Vec3d(infinity);
  hi_ = Vec3d(-infinity);
  for (std::uint32_t id = 0; id < size(); ++id) {
    for (const Vec3d& p : facet(id).vertices) {
      lo_ = glm::min(lo_, p);
      hi_ = glm::max(hi_, p);
    }
  }
  middle_ = 0.5 * lo_ + 0.5 * hi_;
  extent_ = max_norm(glm::max(hi_ - middle_, middle_ - lo_)) * (1 + 0x1p-20);
  const std::size_t padded = (size() + block_size - 1) / block_size * static_cast<std::size_t>(block_size);
  for (int axis = 0; axis < 3; ++axis) {
    bounds_.lo[axis] = -rounded_up(-lo_[axis]);
    bounds_.hi[axis] = rounded_up(hi_[axis]);
    std::vector<float>&middles = box_middles_[static_cast<std::size_t>(axis)],
    &reaches = box_reaches_[static_cast<std::size_t>(axis)];
    middles.assign(padded, 0);
    reaches.assign(padded, -std::numeric_limits<float>::max());
    for (std::uint32_t id = 0; id < size(); ++id) {
      const auto [a, b, c] = facet(id).vertices;
      const double lo = std::min({a[axis], b[axis], c[axis]}) - middle_[axis],
                   hi = std::max({a[axis], b[axis], c[axis]}) - middle_[axis];
      const float middle = nearest(0.5 * lo + 0.5 * hi);
      middles[id] = middle;
      // The differences are off by half a unit in the last place of double.
      reaches[id] = rounded_up(std::max(hi - middle, middle - lo) * (1 + 0x1p-40) + extent_ * 0x1p-50);
    }
  }
}

/// In float, seen from the middle of all boxes: what is far from the middle need not be seen sharply. What is not
/// finite is near.
bool ClosedMesh::look_near(const FacetLine& ready, std::uint32_t first, Block& is_near) const {
  const FacetLine::Seen middle = ready.see(middle_);
  // Of the sums below, in float: three roundings of the middle, and five of what reaches to `extent_` at most on the
  // left, three of less than three times that on the right.
  const auto margin = [&](double seen) {
    return rounded_up((ready.error() + 0x1p-22 * std::fabs(seen) + 0x1p-19 * extent_) * (1 + 0x1p-20));
  };
  const float margin_x = margin(middle.x), margin_y = margin(middle.y);
  const float at_x = nearest(middle.x), at_y = nearest(middle.y);
  const float shear_x = nearest(ready.shear_x()), shear_y = nearest(ready.shear_y());
  const float size_x = std::fabs(shear_x), size_y = std::fabs(shear_y);
  const auto of = [&](const std::array<std::vector<float>, 3>& boxes, int axis) {
    return boxes[static_cast<std::size_t>(axis)].data() + first;
  };
  const float *x = of(box_middles_, ready.x_axis()), *y = of(box_middles_, ready.y_axis()),
              *z = of(box_middles_, ready.z_axis());
  const float *reach_x = of(box_reaches_, ready.x_axis()), *reach_y = of(box_reaches_, ready.y_axis()),
              *reach_z = of(box_reaches_, ready.z_axis());
  int any = 0;
  std::array<std::int32_t, block_size> is_inside;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const float off_x = std::fabs(at_x + x[i] - shear_x * z[i]), off_y = std::fabs(at_y + y[i] - shear_y * z[i]);
    const bool misses_x = off_x > reach_x[i] + size_x * reach_z[i] + margin_x,
               misses_y = off_y > reach_y[i] + size_y * reach_z[i] + margin_y;
    is_inside[i] = !(misses_x | misses_y);
    any |= is_inside[i];
  }
  if (any == 0) return false;
  for (std::uint32_t i = 0; i < block_size; ++i) is_near[i] = static_cast<std::uint8_t>(is_inside[i]);
  return true;
}

}  // namespace sightline
