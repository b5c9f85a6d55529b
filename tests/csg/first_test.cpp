/// The first boundary is the first of the list, in every field, whatever is switched off: of solids whose faces often
/// coincide.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string text_of(const std::optional<Boundary>& boundary) {
  if (!boundary) return "none";
  char text[160];
  std::snprintf(text, sizeof text, "t %a radius %a primitive %u face %u root %u%s", boundary->t,
                double(boundary->radius), unsigned(boundary->primitive), unsigned(boundary->face),
                unsigned(boundary->root), boundary->is_flipped ? " flipped" : "");
  return text;
}

/// Shapes of few different faces, which often coincide; and the same faces as multiples of their polynomials, so that
/// each has a t that is rounded otherwise.
SolidTree crowded_primitive(const Dice& dice) {
  const double multiple = 1 + 2 * dice(3);
  const auto number = [&] { return dice(4) - 1; };
  const Vec3d a(number(), number(), number());
  const double radius = 1 + dice(2);
  switch (dice(6)) {
    case 0: {
      Vec3d normal(0);
      normal[dice(3)] = dice(2) == 0 ? 1 : -1;
      if (dice(3) == 0) normal += Vec3d(0, 2, 0);
      return solid::HalfSpace{multiple * normal, multiple * number()};
    }
    case 1:
      return solid::Sphere{a, radius};
    case 2: {
      solid::Quadric ball{{1, 1, 1, 0, 0, 0, -2 * a.x, -2 * a.y, -2 * a.z, glm::dot(a, a) - radius * radius}};
      for (double& c : ball.coefficients) c *= multiple;
      return ball;
    }
    case 3: {
      Vec3d top = a;
      top[dice(3)] += 1 + dice(2);
      return solid::Cylinder{a, top, radius};
    }
    case 4:
      return dice(4) == 0 ? any_primitive(dice) : solid::Box{a, a + radius};
    default: {
      SolidTree box = solid::Box{multiple * a, multiple * (a + Vec3d(1 + dice(2), radius, 1))};
      for (std::size_t i = 0; i < 3; ++i) box.frame.rows[i][i] = multiple;
      return box;
    }
  }
}

SolidOptions any_options(const Dice& dice) {
  SolidOptions options;
  for (const auto& field : SolidOptions::fields()) {
    if (const auto* member = std::get_if<bool SolidOptions::*>(&field.member)) options.*(*member) = dice(2) == 0;
  }
  options.index_from = 2 + 6 * dice(2);
  return options;
}

/// Through a lattice point, in any direction.
Ray<double> crowded_ray(const Dice& dice) {
  if (dice(3) == 0) return lattice_ray(dice);
  const auto number = [&] { return dice(13) / 3.0 - 2; };
  Ray<double> ray{Vec3d(dice(4) - 1, dice(4) - 1, dice(4) - 1), {number(), number(), number()}};
  if (ray.direction == Vec3d(0)) ray.direction.x = 1 / 3.0;
  ray.origin -= 0.1 * (dice(40)) * ray.direction;
  return ray;
}

std::string names_of(const SolidOptions& options) {
  std::string names;
  for (const auto& field : SolidOptions::fields()) {
    const auto* member = std::get_if<bool SolidOptions::*>(&field.member);
    if (member && options.*(*member)) names += ' ' + std::string(field.name);
  }
  return names;
}

/// Also of convex parts, which are walked along without lists.
SolidTree crowded_tree(const Dice& dice) {
  if (dice(2) == 0) return random_tree(dice, 1 + dice(3), crowded_primitive);
  SolidTree tree = crowded_primitive(dice);
  for (int i = dice(3); i > 0; --i) tree = tree & crowded_primitive(dice);
  for (int i = dice(4); i > 0; --i) tree = tree - crowded_primitive(dice);
  return tree;
}

/// The list's own, their neighbours, and where faces that coincide with one of them are by themselves.
std::vector<double> limits_of(const Solid& solid, const Spans& spans, const Ray<double>& ray, Level level) {
  std::vector<double> limits{-infinity, 0, infinity};
  for (const Boundary& b : spans.boundaries) {
    limits.insert(limits.end(), {b.t, std::nextafter(b.t, -infinity), std::nextafter(b.t, infinity)});
  }
  for (const Primitive& primitive : solid.primitives()) {
    SolidTree part;
    part.shape = primitive.shape;
    if (const Frame* frame = solid.frame_of(primitive)) part.frame = *frame;
    for (const Boundary& b : spans_of(Solid(part), ray, level).boundaries) {
      const bool is_shared = std::any_of(spans.boundaries.begin(), spans.boundaries.end(), [&](const Boundary& other) {
        return b.t != other.t && std::fabs(b.t - other.t) <= 0x1p-40 * std::fabs(other.t);
      });
      if (is_shared) limits.push_back(b.t);
    }
  }
  return limits;
}

TEST(FirstBoundary, IsTheFirstOfTheListWhateverIsSwitchedOff) {
  Random random(6);
  const Dice dice = dice_of(random);
  std::size_t count = 0;
  for (int round = 0; round < 20'000; ++round) {
    const SolidTree tree = crowded_tree(dice);
    const Ray<double> ray = crowded_ray(dice);
    const SolidOptions options = any_options(dice);
    const Solid solid(tree, options);
    for (const Level level : all_levels) {
      const Spans spans = spans_of(solid, ray, level);
      const std::vector<double> limits = limits_of(solid, spans, ray, level);
      for (const double lo : limits) {
        const auto next =
            std::find_if(spans.boundaries.begin(), spans.boundaries.end(), [&](const Boundary& b) { return b.t > lo; });
        for (const double hi : limits) {
          if (!(lo <= hi)) continue;
          const bool is_there = next != spans.boundaries.end() && next->t <= hi;
          const auto found = first_of(solid, ray, lo, hi, level);
          count += is_there;
          ASSERT_EQ(text_of(found), text_of(is_there ? std::optional(*next) : std::nullopt))
              << info_of(level).name << ": " << text_of(tree) << " along " << text_of(ray) << " from " << lo << " to "
              << hi << ", round " << round << ", with" << names_of(options);
        }
      }
    }
  }
  EXPECT_GT(count, 400'000u);
}

}  // namespace
}  // namespace sightline
