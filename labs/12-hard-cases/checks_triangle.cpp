/// Lab 12: triangles without gaps, and where rays begin.

#include <cmath>
#include <cstdio>

#include "labs/check/check.h"
#include "sightline/math/expansion.h"
#include "sightline/math/ray.h"

namespace sightline::labs {
std::vector<Check> hard_triangle_checks();
namespace {

__extension__ using Wide = __int128;
using Whole = std::array<std::int64_t, 3>;

std::string text_of(const Vec3f& v) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.9g %.9g %.9g)", double(v.x), double(v.y), double(v.z));
  return text;
}
Vec3f vector_of(const Whole& w) { return Vec3f(float(w[0]), float(w[1]), float(w[2])); }

Check make_check(std::string name, std::string section, std::string why, std::vector<std::string> hints,
                 const Recipe& recipe, int count) {
  return {std::move(name), std::move(section), std::move(why), std::move(hints), recipe, count, false, {}, {}, {}};
}

/// Two triangles, a b c and b a e, and a line. Coordinates are below 2^24 in magnitude: float holds them.
struct Pair {
  Whole origin, direction, a, b, c, e;
  Ray<float> ray() const { return {vector_of(origin), vector_of(direction)}; }
};

/// Corners are far from each other by `far`: differences of their coordinates lose nothing, products in double do.
Pair pair_of(const Case& at, bool is_aimed) {
  const auto h = [&](std::size_t i) { return std::int64_t(at.head[i]); };
  const std::int64_t far = (std::int64_t(1) << (std::abs(at.head[18]) % 20)) - 1;
  const auto corner = [&](std::size_t i, int x, int y, int z) {
    return Whole{h(i) + x * far, h(i + 1) + y * far, h(i + 2) + z * far};
  };
  Pair p{{h(0), h(1), h(2)}, {}, corner(3, 1, -1, 1), corner(6, 1, 1, -1), corner(9, -1, 1, 1), corner(12, 1, 1, 1)};
  const bool is_in_plane = !is_aimed && h(17) % 3 == 0 && h(16) % 3 == 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_in_plane) p.origin[axis] = p.a[axis] + p.b[axis] - p.c[axis];
    // Through a point of the edge from a to b: four times the way there.
    const std::int64_t part = std::abs(h(15)) % 5;
    p.direction[axis] = 4 * (p.a[axis] - p.origin[axis]) + part * (p.b[axis] - p.a[axis]);
    if (!is_aimed && !is_in_plane) p.direction[axis] += h(15 + axis);
  }
  if (p.direction == Whole{0, 0, 0}) p.direction = {0, 0, 1};
  return p;
}

/// Below 2^24 each: six products of three stay below 2^75.
int true_sign(const Pair& p, const Whole& a, const Whole& b) {
  Whole to_a, to_b;
  for (std::size_t i = 0; i < 3; ++i) to_a[i] = a[i] - p.origin[i], to_b[i] = b[i] - p.origin[i];
  Wide sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += Wide(p.direction[i]) * (Wide(to_a[j]) * to_b[k] - Wide(to_a[k]) * to_b[j]);
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

bool truly_crosses(const Pair& p, const Whole& a, const Whole& b, const Whole& c) {
  const int u = true_sign(p, b, c), v = true_sign(p, c, a), w = true_sign(p, a, b);
  const int most = std::max({u, v, w}), least = std::min({u, v, w});
  return (most > 0 || least < 0) && !(most > 0 && least < 0);
}

std::string describe_line(const Pair& p) {
  return "line from " + text_of(vector_of(p.origin)) + " along " + text_of(vector_of(p.direction));
}
std::string describe_triangle(const Whole& a, const Whole& b, const Whole& c) {
  return "triangle " + text_of(vector_of(a)) + " " + text_of(vector_of(b)) + " " + text_of(vector_of(c));
}

Drawing draw_pair(const Pair& p, bool has_both) {
  const auto point = [](const Whole& w) { return Point3{double(w[0]), double(w[1]), double(w[2])}; };
  SpacePanel panel;
  panel.triangles.push_back({{point(p.a), point(p.b), point(p.c)}, Role::scene, "a b c"});
  if (has_both) panel.triangles.push_back({{point(p.b), point(p.a), point(p.e)}, Role::scene, "b a e"});
  Point3 end{};
  for (std::size_t i = 0; i < 3; ++i) end[i] = double(p.origin[i]) + 0.5 * double(p.direction[i]);
  panel.lines.push_back({{point(p.origin), end}, Role::ray, true, "ray"});
  return {"Where the line passes", "", {{"", std::move(panel)}}};
}

Check edge_check(std::string name, std::string question) {
  Check check = make_check(std::move(name), "4. The sign of an edge",
                           "A sign that rounding made up differs from the neighbor's, and light falls through between.",
                           {"exact_difference(p[axis], o[axis]) is an Expansion; so are sums and products of them.",
                            "How far can six products of three rounded differences be off? A few dozen roundings of "
                            "the largest one.",
                            "Trust the estimate only beyond that bound; a sign of 0 is never to be trusted."},
                           {19, 0, 0, 30}, 500);
  check.describe = [](const Case& at) {
    const Pair p = pair_of(at, at.head[17] % 2 != 0);
    return describe_line(p) + "\nedge from " + text_of(vector_of(p.a)) + " to " + text_of(vector_of(p.b));
  };
  check.ask = [question](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Pair p = pair_of(at, at.head[17] % 2 != 0);
    const int expected = true_sign(p, p.a, p.b);
    const int got = subject.ask<int>(question, p.ray(), vector_of(p.a), vector_of(p.b));
    if (got == expected) return std::nullopt;
    return Trouble{"sign " + std::to_string(expected), "sign " + std::to_string(got)};
  };
  return check;
}

Check work_check() {
  Check check = make_check("edge-work", "4. The sign of an edge",
                           "Exact sums cost a hundred times as much; nearly every edge is far from needing them.",
                           {"Ask for the exact sign only where the estimate is within its error bound."}, {}, 1);
  check.is_budget = true;
  check.describe = [](const Case&) { return "1024 rays from (0 0 10) past the edge from (0 0 0) to (1 0 0)"; };
  check.ask = [](const Case&, Subject& subject) -> std::optional<Trouble> {
    std::vector<Ray<float>> rays;
    for (int i = 0; i < 1024; ++i) {
      // On a lattice that leaves the edge's line out: half a step beside it at the nearest.
      rays.push_back({{0, 0, 10}, {float(i % 32 - 16) / 32, (float(i) / 32 - 16.0f) / 32 + 0.001f, -1}});
    }
    const auto got = subject.ask<long>("edge-work", rays, Vec3f(0), Vec3f(1, 0, 0));
    if (got == 0) return std::nullopt;
    return Trouble{"no exact sign", std::to_string(got) + " exact signs"};
  };
  return check;
}

Check triangle_check() {
  Check check =
      make_check("triangle", "5. Triangles without gaps",
                 "Spikes, holes and ghosts: what a line meets is a matter of three signs.",
                 {"Two signs that differ, and the line passes outside. What do three zeros mean?"}, {19, 0, 0, 9}, 600);
  check.describe = [](const Case& at) {
    const Pair p = pair_of(at, false);
    return describe_line(p) + "\n" + describe_triangle(p.a, p.b, p.c);
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Pair p = pair_of(at, false);
    const bool expected = truly_crosses(p, p.a, p.b, p.c);
    const bool got =
        subject.ask<std::uint8_t>("triangle", p.ray(), vector_of(p.a), vector_of(p.b), vector_of(p.c)) != 0;
    if (expected == got) return std::nullopt;
    return Trouble{expected ? "crossed" : "missed", got ? "crossed" : "missed"};
  };
  check.draw = [](const Case& at, Subject&) { return draw_pair(pair_of(at, false), false); };
  return check;
}

Check watertight_check() {
  Check check = make_check("watertight", "5. Triangles without gaps",
                           "A line just through the shared edge of two triangles must not pass between them.",
                           {"A sign of 0 agrees with both others."}, {19, 0, 0, 30}, 400);
  check.describe = [](const Case& at) {
    const Pair p = pair_of(at, true);
    return describe_line(p) + ", just through the shared edge of\n" + describe_triangle(p.a, p.b, p.c) + "\n" +
           describe_triangle(p.b, p.a, p.e);
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Pair p = pair_of(at, true);
    const bool expected[] = {truly_crosses(p, p.a, p.b, p.c), truly_crosses(p, p.b, p.a, p.e)};
    const auto crosses = [&](const Whole& a, const Whole& b, const Whole& c) {
      return subject.ask<std::uint8_t>("triangle", p.ray(), vector_of(a), vector_of(b), vector_of(c)) != 0;
    };
    const bool got[] = {crosses(p.a, p.b, p.c), crosses(p.b, p.a, p.e)};
    if (got[0] == expected[0] && got[1] == expected[1]) return std::nullopt;
    const auto text = [](const bool* x) {
      return x[0] && x[1] ? "both crossed" : x[0] ? "the first crossed" : x[1] ? "the second crossed" : "none crossed";
    };
    return Trouble{text(expected), text(got)};
  };
  check.draw = [](const Case& at, Subject&) { return draw_pair(pair_of(at, true), true); };
  return check;
}

// ---- Where a ray begins

struct Departure {
  Vec3f a, b, c;
  float u, v;
};

Departure departure_of(const Case& at) {
  const auto scale = float(std::pow(10.0, at.head[0] < 0 ? -std::abs(at.head[0]) % 5 : at.head[0] % 8));
  const auto vector = [&](std::size_t i) { return vector_of({at.head[i], at.head[i + 1], at.head[i + 2]}); };
  const Vec3f third(1.0f / 3);  // so that coordinates have all digits
  Departure d{
      scale * (vector(1) + third), {}, {}, float(std::abs(at.head[10])) / 61, float(std::abs(at.head[11])) / 61};
  d.b = d.a + scale * vector(4), d.c = d.a + scale * vector(7);
  const Vec3f one = vector(4), other = vector(7);
  if (glm::length(glm::cross(one, other)) < 0.25f * glm::length(one) * glm::length(other) || one == Vec3f(0) ||
      other == Vec3f(0)) {
    d.b = d.a + scale * Vec3f(1, 0, 0), d.c = d.a + scale * Vec3f(0, 1, 0);  // slivers are not asked for
  }
  return d;
}

/// (b - a) x (c - a) . (p - a), without rounding.
Expansion<192> height_of(const Departure& d, const Vec3f& p) {
  const auto e = [&](const Vec3f& to, int axis) { return exact_difference(to[axis], d.a[axis]); };
  const auto term = [&](int i, int j, int k) { return e(p, i) * (e(d.b, j) * e(d.c, k) - e(d.b, k) * e(d.c, j)); };
  return term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1);
}

Check leave_check() {
  Check check =
      make_check("leave", "6. Where a ray begins",
                 "From below its own surface a ray meets that first, and the picture has acne; from too far "
                 "above it, it has passed through the next wall.",
                 {"How far may the arithmetic of point_of have put the point from the true one, axis by axis?",
                  "Go along the normal until even the worst such error is made up: |n| . error along n.",
                  "The sum is rounded once more, perhaps back: std::nextafter, away from the surface."},
                 {12, 0, 0, 30}, 800);
  check.describe = [](const Case& at) {
    const Departure d = departure_of(at);
    return "triangle " + text_of(d.a) + " " + text_of(d.b) + " " + text_of(d.c) + ", u = " + std::to_string(d.u) +
           ", v = " + std::to_string(d.v);
  };
  check.ask = [](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Departure d = departure_of(at);
    const auto got = subject.ask<Vec3f>("leave", d.a, d.b, d.c, d.u, d.v);
    const Expansion<192> height = height_of(d, got);
    const double area = glm::length(glm::cross(Vec3d(d.b) - Vec3d(d.a), Vec3d(d.c) - Vec3d(d.a)));
    const double away = height.estimate() / area;
    const auto size = [](const Vec3f& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
    // Error bounds of 8 roundings of three corners, along each of three axes, are 72 of the largest coordinate; three
    // times that is room for another proof, and a ten-thousandth of the triangle stays out of reach.
    const double most = 216 * 0x1p-24 * std::max({size(d.a), size(d.b), size(d.c)});
    if (height.sign() > 0 && away <= most) return std::nullopt;
    char expected[96], text[96];
    std::snprintf(expected, sizeof expected, "above the plane, by %.3g at most", most);
    std::snprintf(text, sizeof text, "%s, %.3g %s", text_of(got).c_str(), std::fabs(away),
                  height.sign() > 0   ? "above"
                  : height.sign() < 0 ? "below"
                                      : ": in the plane");
    return Trouble{expected, text};
  };
  return check;
}

}  // namespace

std::vector<Check> hard_triangle_checks() {
  return {edge_check("exact-edge-sign", "exact-edge"),
          edge_check("edge-sign", "edge"),
          work_check(),
          triangle_check(),
          watertight_check(),
          leave_check()};
}

}  // namespace sightline::labs
