/// Laws of sets and of evaluation, on solids of every kind of shape.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Dice checked_dice = [](int n) { return *rc::gen::inRange(0, n); };

SolidTree any_tree(int depth) { return random_tree(checked_dice, checked_dice(depth + 1), any_primitive); }

Level any_sure_level() { return sure_levels[static_cast<std::size_t>(checked_dice(3))]; }

/// The same set: at level exact to the last bit, elsewhere as close as both lists say they are.
bool are_alike(const Spans& a, const Spans& b, Level level) {
  if (a.begins_inside != b.begins_inside || a.boundaries.size() != b.boundaries.size()) return false;
  for (std::size_t i = 0; i < a.boundaries.size(); ++i) {
    const Boundary &x = a.boundaries[i], &y = b.boundaries[i];
    if (level == Level::exact ? x.t != y.t : std::fabs(x.t - y.t) > (x.radius + y.radius) * (1 + 0x1p-50)) return false;
  }
  return true;
}

bool are_same(const Boundary& a, const Boundary& b) {
  return a.t == b.t && a.radius == b.radius && a.primitive == b.primitive && a.face == b.face && a.root == b.root &&
         a.is_flipped == b.is_flipped;
}
bool are_same(const Spans& a, const Spans& b) {
  return a.begins_inside == b.begins_inside &&
         std::equal(a.boundaries.begin(), a.boundaries.end(), b.boundaries.begin(), b.boundaries.end(),
                    [](const Boundary& x, const Boundary& y) { return are_same(x, y); });
}

void check_equal(const char* law, const SolidTree& one, const SolidTree& other, const Ray<double>& ray) {
  for (const Level level : sure_levels) {
    const Spans a = spans_of(Solid(one), ray, level), b = spans_of(Solid(other), ray, level);
    if (!are_alike(a, b, level)) {
      RC_FAIL(std::string(law) + " at " + std::string(info_of(level).name) + ": " + text_of(one) + " and " +
              text_of(other) + " along " + text_of(ray));
    }
  }
}

RC_GTEST_PROP(SolidLaws, HoldForSets, ()) {
  const SolidTree a = any_tree(2), b = any_tree(2), c = any_tree(1);
  const Ray<double> ray = lattice_ray(checked_dice);
  check_equal("De Morgan", ~(a | b), ~a & ~b, ray);
  check_equal("De Morgan", ~(a & b), ~a | ~b, ray);
  check_equal("difference", a - b, a & ~b, ray);
  check_equal("double complement", ~~a, a, ray);
  check_equal("commutative union", a | b, b | a, ray);
  check_equal("commutative intersection", a & b, b & a, ray);
  check_equal("commutative symmetric difference", a ^ b, b ^ a, ray);
  check_equal("associative union", (a | b) | c, a | (b | c), ray);
  check_equal("associative intersection", (a & b) & c, a & (b & c), ray);
  check_equal("associative symmetric difference", (a ^ b) ^ c, a ^ (b ^ c), ray);
  check_equal("distributive", a & (b | c), (a & b) | (a & c), ray);
  check_equal("symmetric difference", a ^ b, (a | b) - (a & b), ray);
  check_equal("n-ary union", SolidTree(Operation::unite, {a, b, c}), a | b | c, ray);
  check_equal("n-ary difference", SolidTree(Operation::subtract, {a, b, c}), a - b - c, ray);
}

RC_GTEST_PROP(SolidLaws, HoldForASolidAndItself, ()) {
  const SolidTree a = any_tree(3);
  const Ray<double> ray = lattice_ray(checked_dice);
  const auto is = [&](const SolidTree& tree, bool begins_inside) {
    for (const Level level : all_levels) {
      const Spans spans = spans_of(Solid(tree), ray, level);
      if (!spans.boundaries.empty() || spans.begins_inside != begins_inside) {
        RC_FAIL(std::string(info_of(level).name) + ": " + text_of(tree) + " along " + text_of(ray));
      }
    }
  };
  is(a | ~a, true);
  is(a & ~a, false);
  is(a - a, false);
  is(a ^ a, false);
  check_equal("idempotent", a | a, a, ray);
}

/// What is spared matters to no bit of the result.
RC_GTEST_PROP(SolidOptions, ChangeNothing, ()) {
  const SolidTree tree = any_tree(4);
  const Ray<double> ray = lattice_ray(checked_dice);
  SolidOptions none;
  none.use_bounds = none.skip_empty = none.prune_disjoint = none.absorb_complements = none.index_operands =
      none.stop_early = false;
  const Solid plain(tree, none);
  const double t_min = 0.25 * (checked_dice(17) - 8), t_max = t_min + 0.5 * checked_dice(20);
  const auto check = [&](const std::string& what, const SolidOptions& options, std::string_view accelerator) {
    const Solid solid(tree, options, accelerator);
    for (const Level level : all_levels) {
      const auto expected = first_of(plain, ray, t_min, t_max, level),
                 found = first_of(solid, ray, t_min, t_max, level);
      if (!are_same(spans_of(solid, ray, level), spans_of(plain, ray, level)) ||
          found.has_value() != expected.has_value() || (found && !are_same(*found, *expected))) {
        RC_FAIL(what + " at " + std::string(info_of(level).name) + ": " + text_of(tree) + " along " + text_of(ray));
      }
    }
  };
  for (const auto& field : SolidOptions::fields()) {
    const auto* member = std::get_if<bool SolidOptions::*>(&field.member);
    if (!member) continue;
    SolidOptions all_but, only = none;
    all_but.*(*member) = false, only.*(*member) = true;
    all_but.index_from = only.index_from = 2;
    check("all but " + std::string(field.name), all_but, "box-tree");
    check("only " + std::string(field.name), only, "box-tree");
  }
  SolidOptions indexed;
  indexed.index_from = 2;
  for (const std::string_view name : accelerator_names()) check(std::string(name), indexed, name);
}

/// `first` is the first of `spans`, whatever the limits.
RC_GTEST_PROP(SolidEvaluator, FindsTheFirstOfItsSpans, ()) {
  SolidTree tree = any_tree(3);
  if (checked_dice(2) == 0) tree = (any_tree(1) ^ any_tree(1) ^ any_tree(1)) - std::move(tree);  // of several spans
  const Ray<double> ray = lattice_ray(checked_dice);
  const Solid solid(tree);
  for (const Level level : all_levels) {
    const Spans spans = spans_of(solid, ray, level);
    std::vector<double> limits{-infinity, infinity, 0, 0.1 * (checked_dice(200) - 100),
                               0.1 * (checked_dice(200) - 100)};
    for (const Boundary& boundary : spans.boundaries) {
      const double t = boundary.t, aside = 0x1p-43 * std::fabs(t);
      limits.insert(limits.end(), {t, std::nextafter(t, -infinity), std::nextafter(t, infinity), t - aside, t + aside});
    }
    for (const double t_min : limits) {
      for (const double t_max : limits) {
        const auto expected = std::find_if(spans.boundaries.begin(), spans.boundaries.end(),
                                           [&](const Boundary& boundary) { return boundary.t > t_min; });
        const auto found = first_of(solid, ray, t_min, t_max, level);
        const bool is_any = t_min <= t_max && expected != spans.boundaries.end() && expected->t <= t_max;
        if (t_min <= t_max && (found.has_value() != is_any || (found && !are_same(*found, *expected)))) {
          RC_FAIL(std::string(info_of(level).name) + ": " + text_of(tree) + " along " + text_of(ray) + " from " +
                  std::to_string(t_min) + " to " + std::to_string(t_max));
        }
      }
    }
  }
}

/// Between two boundaries the points are in, or out, by the definition of the shapes in exact numbers; not in the
/// middle, where surfaces may touch.
RC_GTEST_PROP(SolidEvaluator, IsInsideWherePointsAre, ()) {
  const SolidTree tree = any_tree(4);
  const Ray<double> ray = lattice_ray(checked_dice);
  const Solid solid(tree);
  const Level level = any_sure_level();
  const Spans spans = spans_of(solid, ray, level);
  bool is_inside = spans.begins_inside;
  for (std::size_t i = 0; i <= spans.boundaries.size(); ++i, is_inside = !is_inside) {
    const bool has_lo = i > 0, has_hi = i < spans.boundaries.size();
    const double hi = has_hi ? spans.boundaries[i].t : has_lo ? spans.boundaries[i - 1].t + 2.718 : 3.1416;
    const double lo = has_lo ? spans.boundaries[i - 1].t : hi - 2.718;
    const double t = lo + 0.6180339887 * (hi - lo);
    const bool is_between = (!has_lo || t > lo + 2 * spans.boundaries[i - 1].radius) &&
                            (!has_hi || t < hi - 2 * spans.boundaries[i].radius);
    if (is_between && oracle::contains(tree, oracle::point_at(ray, t)) != is_inside) {
      RC_FAIL(std::string(info_of(level).name) + " t = " + std::to_string(t) + ": " + text_of(tree) + " along " +
              text_of(ray));
    }
  }
}

/// Outward normals are against the ray where it enters, and with it where it leaves, but for surfaces that it hardly
/// cuts. Of a bounded solid boundaries come in pairs, and are within its bounds.
RC_GTEST_PROP(SolidEvaluator, HasBoundariesThatFit, ()) {
  const SolidTree tree = any_tree(3);
  const Ray<double> ray = lattice_ray(checked_dice);
  const Solid solid(tree);
  const bool is_bounded = solid.is_bounded() && !solid.root().is_complement;
  for (const Level level : all_levels) {
    const Spans spans = spans_of(solid, ray, level);
    if (is_bounded) RC_ASSERT(!spans.begins_inside && spans.boundaries.size() % 2 == 0);
    bool is_inside = spans.begins_inside;
    for (std::size_t i = 0; i < spans.boundaries.size(); ++i) {
      const Boundary& boundary = spans.boundaries[i];
      // In order, as far as their own bounds let one tell; at exact without exception.
      if (i > 0 && !(spans.boundaries[i - 1].t - boundary.t <= spans.boundaries[i - 1].radius + boundary.radius)) {
        RC_FAIL(std::string(info_of(level).name) + " goes back: " + text_of(tree) + " along " + text_of(ray));
      }
      if (i > 0 && level == Level::exact) RC_ASSERT(spans.boundaries[i - 1].t <= boundary.t);
      is_inside = !is_inside;
      const Vec3d normal = solid.normal(boundary, ray), p = ray.at(boundary.t);
      RC_ASSERT(std::fabs(glm::length(normal) - 1) < 0x1p-50);
      const double with_ray = glm::dot(normal, ray.direction) / glm::length(ray.direction);
      const double graze = level == Level::fast ? 0x1p-6 : 0x1p-16;
      if (std::fabs(with_ray) > graze && (with_ray < 0) != is_inside) {
        RC_FAIL(std::string(info_of(level).name) + " normal at " + std::to_string(boundary.t) + ": " + text_of(tree) +
                " along " + text_of(ray));
      }
      if (!is_bounded) continue;
      const double size = max_norm(ray.origin) + std::fabs(boundary.t) * max_norm(ray.direction);
      const double rounding = size * (level == Level::fast ? 0x1p-16 : 0x1p-44);
      for (int axis = 0; axis < 3; ++axis) {
        RC_ASSERT(p[axis] >= solid.bounds().lo[axis] - rounding);
        RC_ASSERT(p[axis] <= solid.bounds().hi[axis] + rounding);
      }
    }
  }
}

SolidTree in_frame(SolidTree tree, const Frame& frame) {
  tree.frame = frame;
  for (SolidTree& arg : tree.args) arg = in_frame(std::move(arg), frame);
  return tree;
}

/// A solid moved by whole numbers, scaled by a power of two and turned by swapping axes, and a ray with it.
RC_GTEST_PROP(SolidEvaluator, AnswersAlikeInAnyFrame, ()) {
  const auto unframed = [](const Dice& dice) { return primitive_of_kind(dice(shape_kinds), dice); };
  const SolidTree tree = random_tree(checked_dice, checked_dice(4), unframed);
  const auto whole = [] { return Vec3d(checked_dice(17) - 8, checked_dice(17) - 8, checked_dice(17) - 8); };
  Ray<double> ray{whole(), whole()}, local;
  if (ray.direction == Vec3d(0)) ray.direction.z = 1;
  Frame frame;
  const int turn = checked_dice(3);
  for (int i = 0; i < 3; ++i) {
    const int from = (i + turn) % 3;
    const double scale = std::ldexp(checked_dice(2) == 0 ? 1 : -1, checked_dice(7) - 3), move = checked_dice(9) - 4;
    auto& row = frame.rows[static_cast<std::size_t>(i)];
    row = {0, 0, 0, move};
    row[static_cast<std::size_t>(from)] = scale;
    local.direction[i] = scale * ray.direction[from];
    local.origin[i] = scale * ray.origin[from] + move;
  }
  for (const Level level : sure_levels) {
    const Spans here = spans_of(Solid(tree), local, level), there = spans_of(Solid(in_frame(tree, frame)), ray, level);
    if (!are_alike(here, there, level)) {
      RC_FAIL(std::string(info_of(level).name) + ": " + text_of(tree) + " along " + text_of(local));
    }
  }
}

/// Where all that is asked for is one point of the ray, structures find the operands that are there: here the boxes
/// touch at the ray's origin, and nothing farther is asked for.
TEST(SolidOptions, OperandsAreFoundAtAPoint) {
  const auto cylinder = [](const Vec3d& base, const Vec3d& top) { return SolidTree(solid::Cylinder{base, top, 1}); };
  const SolidTree tree =
      SolidTree(Operation::unite, {cylinder(Vec3d(-2), Vec3d(-4)), solid::Box{Vec3d(-2), Vec3d(-1, -1, 0)}}) &
      SolidTree(Operation::unite,
                {solid::Box{Vec3d(-1, -2, -2), Vec3d(0, -1, 0)}, cylinder(Vec3d(-1), Vec3d(-3, -3, -1))});
  const Ray<double> ray{Vec3d(-1), Vec3d(-1)};
  SolidOptions indexed, plain;
  indexed.index_from = 2;
  plain.index_operands = false;
  const auto expected = first_of(Solid(tree, plain), ray, -2, 0, Level::fast);
  ASSERT_TRUE(expected);
  for (const std::string_view name : accelerator_names()) {
    const auto found = first_of(Solid(tree, indexed, name), ray, -2, 0, Level::fast);
    EXPECT_TRUE(found && are_same(*found, *expected)) << name;
  }
}

}  // namespace
}  // namespace sightline
