/// Why nothing is lost. Let A be, by axis, sum |m_k| r_k + |t|, with r_k the farthest the thing reaches from the origin
/// along k by any of its three volumes; no part of a point's image is larger. Placing in float rounds the map, 2^-24
/// A, and the place, as much again; denormal floats are off by 2^-150 each, times r for the map. All that is computed
/// here is a few dozen roundings, each at most 2^-52 of numbers that A, or its length, is not below: 2^-40 A at most.
/// So 2^-22 A, twice what float takes, pays for everything.

#include "sightline/math/enclosure_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/math/rounding.h"

namespace sightline {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

double largest_sum(const std::array<Vec3d, 3>& rows) {
  double largest = 0;
  for (const Vec3d& row : rows) largest = std::max(largest, std::fabs(row.x) + std::fabs(row.y) + std::fabs(row.z));
  return largest;
}

float radius_up(double x) { return std::isfinite(x) ? round_up(x) : infinity; }

/// How far the farthest corner of a parallelepiped is from its middle, of half its edges.
double diagonal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto square = [](const Vec3d& v) { return glm::dot(v, v); };
  return std::sqrt(
      std::max(std::max(square(a + b + c), square(a + b - c)), std::max(square(a - b + c), square(a - b - c))));
}

Vec3d across(const Vec3d& v, const Vec3d& n) { return v - glm::dot(v, n) * n; }

/// Two directions of unit length at right angles to one such, and to each other.
std::array<Vec3d, 2> directions_across(const Vec3d& n) {
  const Vec3d a = glm::abs(n);
  const Vec3d least = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0) : a.y <= a.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d u = glm::normalize(glm::cross(n, least));
  return {u, glm::cross(n, u)};
}

}  // namespace

/// The Nth power of the largest eigenvalue of a symmetric matrix is that of its Nth power, which no row's sum is below
/// and the largest is at most the square root of three times: for the square of the stretch and N = 32, its 64th root.
double stretch_of(const std::array<Vec3d, 3>& columns) {
  std::array<Vec3d, 3> power;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) power[i][static_cast<int>(k)] = glm::dot(columns[i], columns[k]);
  }
  double stretch = std::sqrt(largest_sum(power));
  double root = stretch;
  for (int n = 2; n <= 32; n *= 2) {
    std::array<Vec3d, 3> square;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) square[i][static_cast<int>(k)] = glm::dot(power[i], power[k]);
    }
    power = square;
  }
  root = largest_sum(power);
  for (int n = 64; n > 1; n /= 2) root = std::sqrt(root);
  return std::min(stretch, root);
}

/// A cylinder around the image's own middle, in the map's scale: which axis, and how far from the middle it reaches.
struct EnclosureImage::Candidate {
  Vec3d center{0};      ///< In the thing's coordinates.
  Vec3f axis{0, 0, 1};  ///< As it will be stored.
  double radius = infinity, half_length = infinity;

  double area() const { return radius * (radius + 2 * half_length); }
};

EnclosureImage::EnclosureImage(const Affine& map, const Enclosure& thing) : thing_(thing), translation_(map.column(3)) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, max_norm(map.column(i)));
  if (!(largest <= 0x1p+128))
    translation_ = Vec3d(infinity);  // the image leaves the range of float: held by everything
  else if (largest > 0)
    scale_ = std::ldexp(1.0, std::max(std::ilogb(largest), -1000));
  for (int k = 0; k < 3; ++k) {
    columns_[static_cast<std::size_t>(k)] = map.column(k) / scale_;
    for (int i = 0; i < 3; ++i) rows_[static_cast<std::size_t>(i)][k] = columns_[static_cast<std::size_t>(k)][i];
  }
  Vec3d reach = glm::max(glm::abs(Vec3d(thing.box.lo)), glm::abs(Vec3d(thing.box.hi)));
  reach = glm::max(reach, glm::abs(Vec3d(thing.sphere.center)) + double(thing.sphere.radius));
  reach = glm::max(reach, glm::abs(Vec3d(thing.cylinder.center)) + double(thing.cylinder.radius) +
                              double(thing.cylinder.half_length));
  for (int i = 0; i < 3; ++i) {
    const double most =
        glm::dot(glm::abs(rows_[static_cast<std::size_t>(i)]), reach) * scale_ + std::fabs(translation_[i]);
    slack_[i] = 0x1p-22 * most + 0x1p-148 * (1 + reach.x + reach.y + reach.z);
  }
  slack_size_ = slack_.x + slack_.y + slack_.z;
}

Aabb EnclosureImage::box() const {
  if (is_nothing(thing_.box)) return {};
  const Vec3d lo(thing_.box.lo), hi(thing_.box.hi);
  const Sphere& ball = thing_.sphere;
  const Cylinder& rod = thing_.cylinder;
  const Vec3d axis = glm::normalize(Vec3d(rod.axis));
  Aabb image;
  for (int i = 0; i < 3; ++i) {
    const Vec3d& row = rows_[static_cast<std::size_t>(i)];
    const Vec3d a = row * lo, b = row * hi, least = glm::min(a, b), most = glm::max(a, b);
    double low = least.x + least.y + least.z, high = most.x + most.y + most.z;
    const double ball_middle = glm::dot(row, Vec3d(ball.center)), ball_reach = ball.radius * glm::length(row);
    low = std::max(low, ball_middle - ball_reach);
    high = std::min(high, ball_middle + ball_reach);
    const double along = glm::dot(row, axis), rod_middle = glm::dot(row, Vec3d(rod.center));
    const double rod_reach = rod.half_length * std::fabs(along) + rod.radius * glm::length(row - along * axis);
    low = std::max(low, rod_middle - rod_reach) * scale_ + translation_[i] - slack_[i];
    high = std::min(high, rod_middle + rod_reach) * scale_ + translation_[i] + slack_[i];
    if (!std::isfinite(low) || !std::isfinite(high)) return everything<Aabb>();
    image.lo[i] = round_down(low);
    image.hi[i] = round_up(high);
  }
  return image;
}

Sphere EnclosureImage::sphere() const {
  if (is_nothing(thing_.box)) return Enclosure().sphere;
  const Vec3d lo(thing_.box.lo), hi(thing_.box.hi), half = 0.5 * (hi - lo);
  const double of_ball = thing_.sphere.radius * stretch_of(columns_);
  const double of_box = diagonal(half.x * columns_[0], half.y * columns_[1], half.z * columns_[2]);
  const Vec3d middle = of_ball <= of_box ? Vec3d(thing_.sphere.center) : 0.5 * (lo + hi);
  Vec3d exact;
  for (int i = 0; i < 3; ++i)
    exact[i] = glm::dot(rows_[static_cast<std::size_t>(i)], middle) * scale_ + translation_[i];
  const Vec3f center(exact);
  const double moved = glm::length(Vec3d(center) - exact);
  const float radius = radius_up(std::min(of_ball, of_box) * scale_ + moved + slack_size_);
  return is_finite(center) && std::isfinite(radius) ? Sphere{center, radius} : everything<Sphere>();
}

/// Of the points c + h a + r u, where a is the axis and u at right angles to it. Across the image's axis, the images of
/// u make an ellipse, whose longer half axis is that of a matrix of two rows and columns.
EnclosureImage::Candidate EnclosureImage::of_cylinder() const {
  const Cylinder& rod = thing_.cylinder;
  const auto map = [&](const Vec3d& v) { return v.x * columns_[0] + v.y * columns_[1] + v.z * columns_[2]; };
  const Vec3d axis = glm::normalize(Vec3d(rod.axis)), along = map(axis);
  Candidate made;
  made.center = Vec3d(rod.center);
  made.axis = Vec3f(glm::normalize(along));
  const Vec3d n = glm::normalize(Vec3d(made.axis));
  const auto [u, v] = directions_across(axis);
  const auto [p, q] = directions_across(n);
  const Vec3d image_u = map(u), image_v = map(v);
  const double a = glm::dot(p, image_u), b = glm::dot(p, image_v), c = glm::dot(q, image_u), d = glm::dot(q, image_v);
  const double ellipse =
      0.5 * (std::sqrt((a + d) * (a + d) + (c - b) * (c - b)) + std::sqrt((a - d) * (a - d) + (c + b) * (c + b)));
  const double raised =
      std::sqrt(glm::dot(n, image_u) * glm::dot(n, image_u) + glm::dot(n, image_v) * glm::dot(n, image_v));
  made.radius = rod.half_length * glm::length(across(along, n)) + rod.radius * ellipse;
  made.half_length = rod.half_length * std::fabs(glm::dot(along, n)) + rod.radius * raised;
  return made;
}

/// Along the image of one of the box's edges.
EnclosureImage::Candidate EnclosureImage::of_box_along(int edge) const {
  const Vec3d lo(thing_.box.lo), hi(thing_.box.hi), half = 0.5 * (hi - lo);
  const std::array<Vec3d, 3> edges{half.x * columns_[0], half.y * columns_[1], half.z * columns_[2]};
  Candidate made;
  made.center = 0.5 * (lo + hi);
  made.axis = Vec3f(glm::normalize(columns_[static_cast<std::size_t>(edge)]));
  const Vec3d n = glm::normalize(Vec3d(made.axis));
  made.radius = diagonal(across(edges[0], n), across(edges[1], n), across(edges[2], n));
  made.half_length =
      std::fabs(glm::dot(edges[0], n)) + std::fabs(glm::dot(edges[1], n)) + std::fabs(glm::dot(edges[2], n));
  return made;
}

Cylinder EnclosureImage::cylinder() const {
  if (is_nothing(thing_.box)) return Enclosure().cylinder;
  Candidate best = of_cylinder();
  for (int edge = 0; edge < 3; ++edge) {
    const Candidate other = of_box_along(edge);
    if (other.area() < best.area() || std::isnan(best.area())) best = other;
  }
  Vec3d exact;
  for (int i = 0; i < 3; ++i)
    exact[i] = glm::dot(rows_[static_cast<std::size_t>(i)], best.center) * scale_ + translation_[i];
  const Vec3f center(exact);
  const double more = glm::length(Vec3d(center) - exact) + slack_size_;
  const float radius = radius_up(best.radius * scale_ + more),
              half_length = radius_up(best.half_length * scale_ + more);
  const bool is_bounded = is_finite(center) && is_finite(best.axis) && best.axis != Vec3f(0) && std::isfinite(radius) &&
                          std::isfinite(half_length);
  return is_bounded ? Cylinder{center, best.axis, radius, half_length} : everything<Cylinder>();
}

}  // namespace sightline
