/// Lab 04: what is asked of a student's interval lists.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "labs/04-csg/picture.h"
#include "labs/04-csg/true_spans.h"
#include "labs/check/text.h"
#include "labs/labs.h"
#include "sightline/math/quadratic.h"

namespace sightline::labs::csg {
namespace {

using labs::text_of;

/// "outside, 1 in, 3 out".
std::string text_of(const Spans& spans) {
  bool is_in = spans.begins_inside != 0;
  std::string text = is_in ? "inside" : "outside";
  for (const Boundary& boundary : spans.boundaries) {
    is_in = !is_in;
    text += ", " + number(boundary.t) + (is_in ? " in" : " out");
  }
  return text;
}

// ---- Primitives

Ray<double> ray_of(const Case& at) {
  Ray<double> ray{{double(at.head[0]), double(at.head[1]), double(at.head[2])},
                  {double(at.head[3]), double(at.head[4]), double(at.head[5])}};
  if (ray.direction == Vec3d(0)) ray.direction = {0, 0, 1};
  return ray;
}

/// What is expected of t, where a root is rounded: 2^-40 of the way to it, and a little of nothing.
bool is_close(double got, double expected) { return std::fabs(got - expected) <= 0x1p-40 * (std::fabs(expected) + 16); }

std::optional<Trouble> trouble_between(const Spans& got, const Spans& expected) {
  bool is_right = got.begins_inside == expected.begins_inside && got.boundaries.size() == expected.boundaries.size();
  for (std::size_t i = 0; is_right && i < got.boundaries.size(); ++i) {
    const Boundary &one = got.boundaries[i], &other = expected.boundaries[i];
    is_right = is_close(one.t, other.t) && one.surface == other.surface && one.is_flipped == other.is_flipped;
  }
  if (is_right) return std::nullopt;
  return Trouble{text_of(expected), text_of(got)};
}

Check sphere_check() {
  Check check{
      "sphere",
      "1. A ball",
      "A line is inside between its two crossings, behind the eye as well: what is cut away may begin there.",
      {"Both roots, in order, whatever their signs.", "A line that touches is never inside: no boundary at all."},
      {10, 0, 0, 6},
      500,
      false,
      {},
      {},
      {}};
  const auto ball = [](const Case& at) {
    return std::pair{Vec3d(at.head[6], at.head[7], at.head[8]), double(1 + std::abs(at.head[9]))};
  };
  check.describe = [ball](const Case& at) {
    const auto [center, radius] = ball(at);
    return "line from " + text_of(ray_of(at).origin) + " along " + text_of(ray_of(at).direction) + "\nball around " +
           text_of(center) + " of radius " + number(radius);
  };
  check.ask = [ball](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto [center, radius] = ball(at);
    const Ray<double> ray = ray_of(at);
    const Vec3d from = ray.origin - center;
    // Of whole numbers: exact.
    const RootList roots =
        quadratic_roots(DoubleBall(glm::dot(ray.direction, ray.direction)), DoubleBall(glm::dot(from, ray.direction)),
                        DoubleBall(glm::dot(from, from) - radius * radius));
    Spans expected;
    if (roots.count == 2) expected.boundaries = {{roots.roots[0].t, 7, 0}, {roots.roots[1].t, 7, 0}};
    return trouble_between(subject.ask<Spans>("sphere", ray, center, radius, std::int32_t{7}), expected);
  };
  return check;
}

Check box_check() {
  Check check{"box",
              "2. A box",
              "Between three pairs of planes at once: a line is in the box while it is between all of them.",
              {"For each axis: where between? Then the latest entry, and the earliest exit.",
               "A direction of 0 along an axis divides by 0. Is the line between the planes, or never?",
               "A line within a face is not inside: <= and < are not the same here."},
              {12, 0, 0, 4},
              600,
              false,
              {},
              {},
              {}};
  const auto corners = [](const Case& at) {
    const Vec3d lo(at.head[6], at.head[7], at.head[8]);
    return std::pair{lo, lo + Vec3d(1 + std::abs(at.head[9]), 1 + std::abs(at.head[10]), 1 + std::abs(at.head[11]))};
  };
  check.describe = [corners](const Case& at) {
    const auto [lo, hi] = corners(at);
    return "line from " + text_of(ray_of(at).origin) + " along " + text_of(ray_of(at).direction) + "\nbox from " +
           text_of(lo) + " to " + text_of(hi);
  };
  check.ask = [corners](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto [lo, hi] = corners(at);
    const Ray<double> ray = ray_of(at);
    return trouble_between(subject.ask<Spans>("box", ray, lo, hi, std::int32_t{3}), true_box_spans(ray, lo, hi, 3));
  };
  return check;
}

// ---- Operations

constexpr const char* operation_names[] = {"unite", "intersect", "subtract"};

Check inside_check() {
  Check check{"inside",
              "3. In or out",
              "Three operations, four cases each: everything else follows from these.",
              {"Write down the truth table of a without b."},
              {},
              1,
              false,
              {},
              {},
              {}};
  check.describe = [](const Case&) { return "all twelve"; };
  check.ask = [](const Case&, Subject& subject) -> std::optional<Trouble> {
    for (const auto operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      for (const bool in_a : {false, true}) {
        for (const bool in_b : {false, true}) {
          const bool got = subject.ask<bool>("inside", operation, in_a, in_b), expected = is_in(operation, in_a, in_b);
          if (got == expected) continue;
          const std::string of = std::string(operation_names[int(operation)]) + (in_a ? ", in a" : ", not in a") +
                                 (in_b ? ", in b" : ", not in b");
          return Trouble{of + ": " + (expected ? "inside" : "outside"), got ? "inside" : "outside"};
        }
      }
    }
    return std::nullopt;
  };
  return check;
}

/// Two lists of whole t: each item is the list's number and a t. Twice the same is none.
struct Pair {
  Operation operation;
  Spans a, b;
};

Pair pair_of(const Case& at) {
  Pair pair{Operation(std::abs(at.head[0]) % 3), {}, {}};
  pair.a.begins_inside = std::abs(at.head[1]) % 2;
  pair.b.begins_inside = std::abs(at.head[2]) % 2;
  std::set<int> of[2];
  for (const auto& item : at.items) of[std::abs(item[0]) % 2].insert(item[1]);
  for (const int t : of[0]) pair.a.boundaries.push_back({double(t), 1, 0});
  for (const int t : of[1]) pair.b.boundaries.push_back({double(t), 2, 0});
  return pair;
}

Drawing draw_pair(const Pair& pair, const Spans& got) {
  const auto row = [](const char* name, Role role, const Spans& spans) {
    LadderPanel::Row made{name, role, {}};
    bool is_in = spans.begins_inside != 0;
    double from = -10;
    for (const Boundary& boundary : spans.boundaries) {
      if (is_in) made.intervals.push_back({from, boundary.t});
      from = boundary.t;
      is_in = !is_in;
    }
    if (is_in) made.intervals.push_back({from, 10});
    return made;
  };
  LadderPanel ladder;
  ladder.rows = {row("a", Role::scene, pair.a), row("b", Role::scene, pair.b),
                 row("expected", Role::right, true_combination(pair.operation, pair.a, pair.b)),
                 row("got", Role::wrong, got)};
  return {std::string("a and b: ") + operation_names[int(pair.operation)],
          "Bars are where the line is inside. Lists go on to the left and right of the picture.",
          {{"", ladder}}};
}

using Judge = std::optional<Trouble> (*)(const Pair&, const Spans& got);

Check combine_check(std::string name, std::string why, std::vector<std::string> hints, Judge judge) {
  Check check{std::move(name), "5. One sweep", std::move(why), std::move(hints), {3, 2, 10, 8}, 800, false, {}, {}, {}};
  check.describe = [](const Case& at) {
    const Pair pair = pair_of(at);
    return std::string(operation_names[int(pair.operation)]) + "\na: " + text_of(pair.a) + "\nb: " + text_of(pair.b);
  };
  check.ask = [judge](const Case& at, Subject& subject) {
    const Pair pair = pair_of(at);
    return judge(pair, subject.ask<Spans>("combine", pair.operation, pair.a, pair.b));
  };
  check.draw = [](const Case& at, Subject& subject) {
    const Pair pair = pair_of(at);
    return draw_pair(pair, subject.ask<Spans>("combine", pair.operation, pair.a, pair.b));
  };
  return check;
}

/// Between whole numbers it is known what is inside.
std::optional<Trouble> membership_trouble(const Pair& pair, const Spans& got) {
  for (double t = -8.5; t <= 8.5; t += 1) {
    const bool expected = is_in(pair.operation, is_in(pair.a, t), is_in(pair.b, t));
    if (is_in(got, t) != expected) {
      const Spans truth = true_combination(pair.operation, pair.a, pair.b);
      return Trouble{std::string(expected ? "inside" : "outside") + " at t = " + number(t) + ": " + text_of(truth),
                     text_of(got)};
    }
  }
  return std::nullopt;
}

std::optional<Trouble> order_trouble(const Pair& pair, const Spans& got) {
  for (std::size_t i = 0; i + 1 < got.boundaries.size(); ++i) {
    if (got.boundaries[i].t < got.boundaries[i + 1].t) continue;
    return Trouble{"every t once, in order: " + text_of(true_combination(pair.operation, pair.a, pair.b)),
                   text_of(got)};
  }
  return std::nullopt;
}

std::optional<Trouble> surface_trouble(const Pair& pair, const Spans& got) {
  const auto truth = true_combination(pair.operation, pair.a, pair.b);
  const auto told = [](const Spans& spans) {
    std::string text;
    for (const Boundary& b : spans.boundaries) {
      text += (text.empty() ? "" : ", ") + number(b.t) + " of " +
              (b.surface == 1   ? "a"
               : b.surface == 2 ? "b"
                                : "nothing") +
              (b.is_flipped != 0 ? ", flipped" : "");
    }
    return text.empty() ? "none" : text;
  };
  if (told(truth) == told(got)) return std::nullopt;
  return Trouble{told(truth), told(got)};
}

Check complement_check() {
  Check check{"complement",
              "4. Everything else",
              "A complement without its turned normals is lit from the inside.",
              {"The boundaries stay where they are. What else is said of them?"},
              {1, 1, 6, 8},
              100,
              false,
              {},
              {},
              {}};
  const auto list = [](const Case& at) {
    Spans spans{std::abs(at.head[0]) % 2, {}};
    std::set<int> places;
    for (const auto& item : at.items) places.insert(item[0]);
    for (const int t : places) spans.boundaries.push_back({double(t), std::abs(t) % 4, t % 2 != 0 ? 1 : 0});
    return spans;
  };
  check.describe = [list](const Case& at) { return text_of(list(at)); };
  check.ask = [list](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const Spans spans = list(at), got = subject.ask<Spans>("complement", spans);
    Spans expected = spans;
    expected.begins_inside = 1 - spans.begins_inside;
    for (Boundary& boundary : expected.boundaries) boundary.is_flipped = 1 - boundary.is_flipped;
    if (auto trouble = trouble_between(got, expected)) {
      return Trouble{trouble->expected + ", every surface turned around", trouble->got};
    }
    return std::nullopt;
  };
  return check;
}

Check first_hit_check() {
  Check check{"first-hit",
              "6. What is seen",
              "The eye may be within a solid: then it sees where that ends.",
              {"Larger than t_min, not equal to it; up to t_max, and equal to it."},
              {3, 1, 8, 8},
              300,
              false,
              {},
              {},
              {}};
  const auto asked = [](const Case& at) {
    Spans spans{std::abs(at.head[0]) % 2, {}};
    std::set<int> places;
    for (const auto& item : at.items) places.insert(item[0]);
    for (const int t : places) spans.boundaries.push_back({double(t), 1, 0});
    const auto [lo, hi] = std::minmax(at.head[1], at.head[2]);
    return std::tuple{spans, double(lo), double(hi)};
  };
  check.describe = [asked](const Case& at) {
    const auto [spans, lo, hi] = asked(at);
    return text_of(spans) + "\nt from " + number(lo) + " to " + number(hi);
  };
  check.ask = [asked](const Case& at, Subject& subject) -> std::optional<Trouble> {
    const auto [spans, lo, hi] = asked(at);
    const auto got = subject.ask<std::optional<Boundary>>("first-hit", spans, lo, hi);
    std::optional<double> expected;
    for (const Boundary& boundary : spans.boundaries) {
      if (!expected && boundary.t > lo && boundary.t <= hi) expected = boundary.t;
    }
    const auto text = [](const std::optional<double>& t) { return t ? "t = " + number(*t) : "nothing"; };
    const std::optional<double> found = got ? std::optional(got->t) : std::nullopt;
    if (found == expected) return std::nullopt;
    return Trouble{text(expected), text(found)};
  };
  return check;
}

Check picture_check() {
  Check check{"picture",
              "6. What is seen",
              "Everything together: a cube, cut by a ball, with holes through it, and a core.",
              {"If all other checks pass, so does this one. If not, compare the pictures."},
              {},
              1,
              false,
              {},
              {},
              {}};
  check.describe = [](const Case&) { return "the die, in a picture of 240 by 180"; };
  check.ask = [](const Case&, Subject& subject) -> std::optional<Trouble> {
    const std::size_t wrong = wrong_pixels(subject);
    if (wrong == 0) return std::nullopt;
    return Trouble{"the picture that our own solids make", std::to_string(wrong) + " pixels that differ"};
  };
  check.draw = [](const Case&, Subject& subject) {
    return Drawing{"The die", "", {{"expected", true_picture()}, {"got", picture_by(subject)}}};
  };
  return check;
}

}  // namespace
}  // namespace sightline::labs::csg

namespace sightline::labs {

Lab csg_lab() {
  using namespace csg;
  Lab lab{"04", "csg", "CSG interval lists", {"spans.h"}, {}, {}, ""};
  lab.checks = {
      sphere_check(),
      box_check(),
      inside_check(),
      complement_check(),
      combine_check("membership", "What is in neither, or in both, decides what a solid is.",
                    {"Walk along the line, and keep two answers: in a? in b? At each boundary one of them changes.",
                     "The result may begin inside: what do begins_inside of a and b say of it?"},
                    membership_trouble),
      combine_check("coincident",
                    "Where two faces lie in one plane, a slice without thickness is left, or a hole without "
                    "width: it flickers in every picture.",
                    {"Take all boundaries at one t before you look whether anything has changed.",
                     "A ball cut out of an equal ball leaves nothing at all, not a skin."},
                    order_trouble),
      combine_check("surfaces", "Each boundary is lit by the normal of the surface that it lies on.",
                    {"A hole's wall is the surface of what was cut out, seen from its other side.",
                     "Where both have a boundary at one t, it is a's."},
                    surface_trouble),
      first_hit_check(),
      picture_check()};
  lab.picture = [](Subject& subject) {
    return Drawing{"A die, carved",
                   "A cube and a ball, three bars cut out, a core put in: interval lists of yours.",
                   {{"", picture_by(subject)}}};
  };
  return lab;
}

}  // namespace sightline::labs
