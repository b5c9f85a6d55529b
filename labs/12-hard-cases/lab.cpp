/// Lab 12: what is asked where rounding decides.

#include <array>
#include <cmath>
#include <cstdio>

#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/ray.h"

namespace sightline::labs {
namespace {

std::string text_of(const Vec3f& v) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.9g %.9g %.9g)", double(v.x), double(v.y), double(v.z));
  return text;
}
std::string text_of(const Ray<float>& ray) {
  return "ray from " + text_of(ray.origin) + " along " + text_of(ray.direction);
}
Ray<float> line(const Vec3f& origin, const Vec3f& direction) {
  Ray<float> ray{origin, direction};
  ray.t_min = -std::numeric_limits<float>::infinity();
  return ray;
}

Check make_check(std::string name, std::string section, std::string why, std::vector<std::string> hints,
                 const Recipe& recipe, int count) {
  return {std::move(name), std::move(section), std::move(why), std::move(hints), recipe, count, false, {}, {}, {}};
}

// ---- Products

Check difference_check() {
  Check check = make_check("difference", "1. Products that cancel",
                           "Discriminants, determinants and cross products are this; where they vanish, rays miss.",
                           {"std::fma(a, b, x) is a b + x, rounded once.",
                            "Round c d. What that lost, fma(-c, d, product) tells exactly: it has to be added again."},
                           {4, 0, 0, 9}, 300);
  // Neighbors of 2^27 in steps of 1: their products have 55 bits, two more than a double keeps.
  const auto factor = [](const Case& at, std::size_t i) { return (std::int64_t{1} << 27) + at.head[i]; };
  check.describe = [factor](const Case& at) {
    const auto text = [&](std::size_t i) { return std::to_string(factor(at, i)); };
    return text(0) + " * " + text(1) + " - " + text(2) + " * " + text(3);
  };
  check.ask = [factor](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto f = [&](std::size_t i) { return factor(at, i); };
    const auto expected = double(f(0) * f(1) - f(2) * f(3));  // whole, below 2^36: exact
    const auto got = subject.ask<double>("difference", double(f(0)), double(f(1)), double(f(2)), double(f(3)));
    if (std::fabs(got - expected) <= 0x1p-52 * std::fabs(expected)) return std::nullopt;
    return Trouble{number(expected), number(got)};
  };
  return check;
}

// ---- Boxes

struct Slabs {
  Ray<float> ray;
  Vec3f lo, hi;
};

/// Mostly of numbers below 8, so that rays run in faces; two of three aim at an edge, and at times by larger.
Slabs slabs_of(const Case& at) {
  const int mode = std::abs(at.head[12]);
  const bool is_aimed = mode % 3 != 0;
  const auto part = [&](std::size_t i) { return float(is_aimed && mode % 2 != 0 ? at.head[i] : at.head[i] % 8); };
  Slabs s{line({part(0), part(1), part(2)}, {part(3), part(4), part(5)}), {part(6), part(7), part(8)}, {}};
  s.ray.t_min = 0;
  for (int axis = 0; axis < 3; ++axis) s.hi[axis] = s.lo[axis] + std::fabs(part(std::size_t(9 + axis)));
  if (is_aimed) {
    s.ray.direction = Vec3f(s.hi.x, s.lo.y, s.lo.z) - s.ray.origin;
    if (s.lo.x == s.hi.x && s.lo.y == s.hi.y) s.hi.y += 1;  // an edge at least
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (s.ray.direction[axis] == 0 && mode % 2 != 0) s.ray.direction[axis] = -0.0f;
  }
  if (s.ray.direction == Vec3f(0)) s.ray.direction.z = 1;
  return s;
}

/// Entering and leaving as fractions of whole numbers.
bool truly_meets(const Slabs& s) {
  std::int64_t enter = 0, enter_below = 1, leave = 1, leave_below = 0;  // 0 and infinity
  for (int axis = 0; axis < 3; ++axis) {
    std::int64_t near = std::int64_t(s.lo[axis] - s.ray.origin[axis]),
                 far = std::int64_t(s.hi[axis] - s.ray.origin[axis]);
    std::int64_t speed = std::int64_t(s.ray.direction[axis]);
    if (speed == 0) {
      if (near > 0 || far < 0) return false;
      continue;
    }
    if (speed < 0) std::swap(near, far), near = -near, far = -far, speed = -speed;
    if (near * enter_below > enter * speed) enter = near, enter_below = speed;
    if (far * leave_below < leave * speed) leave = far, leave_below = speed;
  }
  return enter * leave_below <= leave * enter_below;
}

Check box_check() {
  Check check = make_check("box", "2. Boxes that keep NaN",
                           "A box that is missed hides all it holds: a black line through the picture.",
                           {"In the plane of a face 0 / 0 is NaN, and every comparison with NaN is false.",
                            "Write each comparison so that its being false keeps what is known already.",
                            "-0 is not smaller than 0, but x / -0 is -infinity: std::signbit tells them apart."},
                           {13, 0, 0, 100}, 1500);
  check.describe = [](const Case& at) {
    const Slabs s = slabs_of(at);
    return text_of(s.ray) + "\nbox from " + text_of(s.lo) + " to " + text_of(s.hi);
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Slabs s = slabs_of(at);
    const bool expected = truly_meets(s), got = subject.ask<std::uint8_t>("box", s.ray, s.lo, s.hi) != 0;
    if (expected == got) return std::nullopt;
    return Trouble{expected ? "hit" : "miss", got ? "hit" : "miss"};
  };
  check.draw = [](const Case& at, Subject&) {
    const Slabs s = slabs_of(at);
    const auto point = [](const Vec3f& p) { return Point3{p.x, p.y, p.z}; };
    const float far = 2 * (glm::distance(s.ray.origin, s.lo) + glm::distance(s.lo, s.hi) + 1);
    SpacePanel panel;
    panel.boxes.push_back({point(s.lo), point(s.hi), Role::cell, -1, "box"});
    const Vec3f end = s.ray.origin + far / glm::length(s.ray.direction) * s.ray.direction;
    panel.lines.push_back({{point(s.ray.origin), point(end)}, Role::ray, true, "ray"});
    return Drawing{"A ray and a box", "", {{"", std::move(panel)}}};
  };
  return check;
}

// ---- Spheres

std::string text_of(const std::optional<std::array<float, 2>>& chord) {
  return chord ? "t = " + number((*chord)[0]) + " and " + number((*chord)[1]) : "no hit";
}

Check far_sphere_check() {
  Check check = make_check("far-sphere", "3. Spheres far away",
                           "Small balls far away swell to blobs, then vanish: half their digits are in the distance.",
                           {"Which two numbers are subtracted, and how large are they beside the radius squared?",
                            "Take the ray's nearest point to the center first, as a vector, and square that.",
                            "The discriminant is a (r r - nearest . nearest)."},
                           {3, 0, 0, 16}, 200);
  struct Far {
    double distance, impact, half;
  };
  const auto far_of = [](const Case& at) {
    const double impact = (std::abs(at.head[1]) % 13) / 16.0;  // up to 3/4 of the radius, 1
    return Far{std::ldexp(1, std::abs(at.head[0])), impact, std::sqrt(1 - impact * impact)};
  };
  const auto ray_of = [](const Far& f) { return line({float(f.impact), 0, float(f.distance)}, {0, 0, -1}); };
  check.describe = [=](const Case& at) { return text_of(ray_of(far_of(at))) + "\nball around (0 0 0) of radius 1"; };
  check.ask = [=](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Far f = far_of(at);
    const auto got = subject.ask<std::optional<std::array<float, 2>>>("sphere", ray_of(f), Vec3f(0), 1.0f);
    const std::array<float, 2> expected{float(f.distance - f.half), float(f.distance + f.half)};
    // Eight roundings of the distance; nothing else is inexact on this axis.
    const double room = 8 * 0x1p-24 * (f.distance + 1);
    if (got && std::fabs((*got)[0] - (f.distance - f.half)) <= room &&
        std::fabs((*got)[1] - (f.distance + f.half)) <= room)
      return std::nullopt;
    return Trouble{text_of(std::optional(expected)), text_of(got)};
  };
  return check;
}

Check near_root_check() {
  Check check = make_check("near-root", "3. Spheres far away",
                           "Just above a planet the ground is at the wrong height: all digits of the near root cancel.",
                           {"Where b is nearly as large as the root, one sign subtracts them.",
                            "Compute q = -(b + sign(b) root) first, then q / a and c / q."},
                           {4, 0, 0, 20}, 100);
  // Whole numbers below 2^11, so that even float knows c; rays pass the center at no more than half the radius.
  const auto radius_of = [](const Case& at) { return float(1 + at.head[0] * at.head[0]); };
  const auto ray_of = [=](const Case& at) {
    return line({0, 0, radius_of(at) + 1}, {float(at.head[1]), float(at.head[2]), at.head[3] < 0 ? 60.0f : -60.0f});
  };
  check.describe = [=](const Case& at) {
    return text_of(ray_of(at)) + "\nball around (0 0 0) of radius " + number(radius_of(at));
  };
  check.ask = [=](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Ray<float> ray = ray_of(at);
    const double radius = radius_of(at), a = glm::dot(Vec3d(ray.direction), Vec3d(ray.direction));
    // All exact in double but the root, the quotients and the last sum.
    const double b = double(ray.origin.z) * ray.direction.z, c = double(ray.origin.z) * ray.origin.z - radius * radius;
    const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
    const double near = c / q, far = q / a;
    const auto got = subject.ask<std::optional<std::array<float, 2>>>("sphere", ray, Vec3f(0), float(radius));
    // The discriminant is more than half of b b, and float is off by some dozen roundings of that.
    const auto is_close = [](double x, double t) { return std::fabs(x - t) <= 32 * 0x1p-24 * std::fabs(t); };
    const double enter = std::min(near, far), leave = std::max(near, far);
    if (got && is_close((*got)[0], enter) && is_close((*got)[1], leave)) return std::nullopt;
    return Trouble{text_of(std::optional(std::array{float(enter), float(leave)})), text_of(got)};
  };
  return check;
}

}  // namespace

std::vector<Check> hard_triangle_checks();

Lab hard_cases_lab() {
  Lab lab{"12", "hard-cases", "Hard cases", {"robust.h"}, {}, {}, ""};
  lab.checks = {difference_check(), box_check(), far_sphere_check(), near_root_check()};
  for (Check& check : hard_triangle_checks()) lab.checks.push_back(std::move(check));
  lab.picture = [](Subject& subject) {
    ChartPanel chart{"distance (radii)", "length of the chord at half the radius", true, false, {}};
    ChartPanel::Curve mine{"yours", Role::right, {}, true}, truth{"true", Role::note, {}, false};
    for (int k = 1; k < 20; ++k) {
      const double distance = std::ldexp(1, k);
      const Ray<float> ray = line({0.5f, 0, float(distance)}, {0, 0, -1});
      const auto chord = subject.ask<std::optional<std::array<float, 2>>>("sphere", ray, Vec3f(0), 1.0f);
      mine.points.push_back({distance, chord ? double((*chord)[1]) - (*chord)[0] : 0.0});
      truth.points.push_back({distance, std::sqrt(3.0)});
    }
    chart.curves = {truth, mine};
    return Drawing{"A ball far away", "In float, t can tell no more than a rounding of the distance.", {{"", chart}}};
  };
  return lab;
}

}  // namespace sightline::labs
