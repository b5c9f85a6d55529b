/// Balls that touch, coincide, and are cut where rays meet them.

#include <array>
#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/csg_naive.h"
#include "tests/hard_cases/csg_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

struct OnSphere {
  Vec3d at;
  double radius;
};

/// A point in whole numbers on a sphere of whole radius, in any octant.
OnSphere whole_point(Random& random) {
  constexpr std::array quadruples{OnSphere{{3, 4, 0}, 5}, OnSphere{{1, 2, 2}, 3},  OnSphere{{2, 3, 6}, 7},
                                  OnSphere{{1, 4, 8}, 9}, OnSphere{{2, 6, 9}, 11}, OnSphere{{6, 6, 7}, 11}};
  OnSphere found = quadruples[random.below(quadruples.size())];
  const int turn = static_cast<int>(random.below(3));
  found.at = {found.at[turn], found.at[(turn + 1) % 3], found.at[(turn + 2) % 3]};
  for (int axis = 0; axis < 3; ++axis) found.at[axis] *= random.below(2) == 0 ? 1 : -1;
  return found;
}

/// Through a point, exactly, after whole steps.
Ray<double> ray_to(const Vec3d& at, const Vec3d& direction, Random& random) {
  return {at - (20.0 + random.below(20)) * direction, direction};
}

Vec3d whole_direction(Random& random) {
  for (;;) {
    const Vec3d direction = random_lattice_vector(random, 20);
    if (direction != Vec3d(0)) return direction;
  }
}

// ---- csg-tangent

void run_tangent(Trial& trial) {
  Random random(51);
  for (std::uint64_t i = 0, count = trial.count(250); i < count; ++i) {
    // Two balls that touch at a point, and rays through it: along both centers, and anyhow.
    const auto [point, radius] = whole_point(random);
    const Vec3d center = random_lattice_vector(random, 8), touch = center + point;
    const solid::Sphere ball{center, radius}, other{center + 3.0 * point, 2 * radius};
    const Ray<double> along = ray_to(touch, point, random), any = ray_to(touch, whole_direction(random), random);
    for (const Ray<double>& ray : {along, any}) {
      const TrueSpans alone = sturm_sphere_spans(ball, ray), neighbour = sturm_sphere_spans(other, ray);
      ask_all_ways(trial, SolidQuestion(SolidTree(ball) - other, ray, alone));
      ask_all_ways(trial, SolidQuestion(SolidTree(ball) & other, ray, TrueSpans{}));
      ask_all_ways(trial, SolidQuestion(SolidTree(ball) | other, ray));
      const SolidQuestion outside(SolidTree(other) - ball, ray, neighbour);
      ask_all_ways(trial, outside);
      outside.judge_spans(trial.naive("differences of spans in float"),
                          ends_of(naive_difference(naive_ball<float>(other.center, other.radius, ray),
                                                   naive_ball<float>(center, radius, ray))));
    }
    // A ball in a box that it touches from within, along axes and anyhow.
    Ray<double> ray = ray_to(center, whole_direction(random), random);
    if (i % 2 == 0) {
      ray.direction = Vec3d(0), ray.direction[static_cast<int>(i / 2 % 3)] = 1;
      ray.origin = center - 40.0 * ray.direction;
    }
    ask_all_ways(trial, SolidQuestion(box_of(center - radius, center + radius) - ball, ray));
  }
}

Sketch draw_tangent() {
  Sketch sketch{"Two balls that touch, one taken from the other, and a ball in its box.", {}};
  return sketch.circle({0, 0}, 1)
      .circle({3, 0}, 2)
      .line({-2, 0}, {6, 0}, Role::ray)
      .dot({1, 0}, Role::truth)
      .line({1, 0}, {1.1, 0}, Role::naive)
      .rectangle({-1, -1}, {1, 1}, Role::aid)
      .label({-1.9, 2.3}, "one point in common: nothing is taken", Role::truth)
      .label({-1.9, -2.4}, "rounding makes a spike of it", Role::naive);
}

// ---- csg-frames

SolidTree framed(SolidTree tree, const Frame& frame) {
  tree.frame = frame;
  return tree;
}

void run_frames(Trial& trial) {
  Random random(52);
  const auto lattice = [&] { return random_lattice_vector(random, 4); };
  for (std::uint64_t i = 0, count = trial.count(250); i < count; ++i) {
    const double scale = std::array{2.0, 0.5, 3.0, -1.0, -5.0}[random.below(5)], radius = 1 + random.below(8);
    const Vec3d move = lattice(), center = lattice(), there = scale * center + move;
    const Vec3d a = scale * (center - radius) + move, b = scale * (center + radius) + move;
    const Frame frame{{{{scale, 0, 0, move.x}, {0, scale, 0, move.y}, {0, 0, scale, move.z}}}};
    const SolidTree ball = ball_of(center, radius), cube = box_of(center - radius, center + radius);
    const SolidTree same_ball = framed(ball_of(there, radius * std::fabs(scale)), frame);
    const SolidTree same_cube = framed(box_of(min(a, b), max(a, b)), frame);
    const Ray<double> ray{center + 9.0 * random_in_cube(random), random_in_cube(random)};
    const SolidQuestion whole(ball | same_ball, ray, true_solid_spans(ball, ray));
    ask_all_ways(trial, whole);
    whole.ask_each_structure(trial);
    for (const SolidTree& nothing : {ball - same_ball, ball ^ same_ball, same_ball - ball, cube - same_cube}) {
      ask_all_ways(trial, SolidQuestion(nothing, ray, TrueSpans{}));
    }
    const Ray<double> local{scale * ray.origin + move, scale * ray.direction};
    SolidQuestion(ball - same_ball, ray, TrueSpans{})
        .judge_spans(trial.naive("the ray moved into the frame, in double"),
                     ends_of(naive_difference(naive_ball<double>(center, radius, ray),
                                              naive_ball<double>(there, radius * std::fabs(scale), local))));
  }
}

Sketch draw_frames() {
  Sketch sketch{"A ball, and the same one as three times as large a ball of a frame that makes things a third.", {}};
  return sketch.circle({0, 0}, 1)
      .circle({5, 0}, 3, Role::aid)
      .line({-2, -0.5}, {2, 0.5}, Role::ray)
      .line({-1, -1.5}, {11, 1.5}, Role::aid)
      .line({0, 1}, {5, 3}, Role::aid)
      .label({-2, 1.6}, "in the world")
      .label({4, 3.3}, "in its frame")
      .label({-2, -3.4}, "truth of the one less the other: nothing", Role::truth)
      .label({-2, -4}, "the ray is rounded on its way into the frame: slivers", Role::naive);
}

// ---- csg-pythagoras

void run_pythagoras(Trial& trial) {
  Random random(53);
  for (std::uint64_t i = 0, count = trial.count(1200); i < count; ++i) {
    auto [point, radius] = whole_point(random);
    // Large enough for squares to be rounded in double; t is whole all the same.
    const double size = 1 + random.below(1 << 22);
    point *= size, radius *= size;
    const Vec3d center = size * random_lattice_vector(random, 8), at = center + point;
    const Vec3d direction = whole_direction(random);
    Vec3d normal = whole_direction(random);
    const double side = glm::dot(direction, point), slope = glm::dot(direction, normal);
    if (side == 0 || slope == 0) continue;
    // The half-space has what is before the ball where the ray enters at the point, what is behind it where it leaves.
    if ((side < 0) != (slope > 0)) normal = -normal;
    const double offset = glm::dot(normal, at);
    const Ray<double> ray{at - size * (20.0 + random.below(20)) * direction, direction};
    const SolidTree ball = ball_of(center, radius), half = half_space(normal, offset);
    const SolidQuestion nothing(ball & half, ray, TrueSpans{});
    ask_all_ways(trial, nothing);
    ask_all_ways(trial, SolidQuestion(ball - half, ray, true_solid_spans(ball, ray)));
    nothing.judge_spans(
        trial.naive("spans in double"),
        ends_of(naive_intersection(naive_ball<double>(center, radius, ray), naive_half<double>(normal, offset, ray))));
  }
}

Sketch draw_pythagoras() {
  Sketch sketch{"The sphere x^2 + y^2 = 25, cut by y <= -4, and a ray that meets both at (3, -4).", {}};
  return sketch.circle({0, 0}, 5)
      .line({-7, -4}, {7, -4}, Role::shape)
      .line({3, -7.5}, {3, 7}, Role::ray)
      .dot({3, -4})
      .line({3, -4}, {3, -3.6}, Role::naive)
      .label({3.3, -4.8}, "both at t = 6: a point, dropped", Role::truth)
      .label({3.3, -3.4}, "a root and a quotient round apart: a sliver", Role::naive)
      .label({-6.8, -4.8}, "y <= -4");
}

}  // namespace

HardCase csg_tangent() {
  return {.id = "csg-tangent",
          .group = "csg",
          .inputs =
              "two balls in whole numbers that touch in a whole point, united, taken from each other and cut with "
              "each other; a ball less its box's inside; rays through the point and along the axes",
          .expected = "no span and no gap of length 0: the difference is the ball alone, the common part nothing",
          .why =
              "Along the line of centers one ball ends where the other begins: two roots of two polynomials that are "
              "one number. Rounded apart they give a spike as long as the rounding, or a pinhole.",
          .oracle = Oracle::sturm_chains,
          .reference = {},
          .is_policy = false,
          .run = run_tangent,
          .draw = draw_tangent};
}

HardCase csg_frames() {
  return {
      .id = "csg-frames",
      .group = "csg",
      .inputs = "a ball or a cube less the same one scaled by 2, 1/2, 3, -1 or -5, moved, and put back by its frame",
      .expected =
          "policy: what stands in a frame is what its numbers say, exactly, so that the two are one and "
          "nothing is left",
      .why =
          "A ray that is carried into a frame is rounded there; its roots are those of another ray. A solid and "
          "its copy differ in their last bits, and a difference of both is speckle. The library takes the frame "
          "into the polynomial instead of rounding the ray.",
      .oracle = Oracle::metamorphic,
      .reference = {},
      .is_policy = true,
      .run = run_frames,
      .draw = draw_frames};
}

HardCase csg_pythagoras() {
  return {.id = "csg-pythagoras",
          .group = "csg",
          .inputs =
              "balls through points in whole numbers, multiples to 2^22 of such as (3, 4, 0) of radius 5; half-spaces "
              "whose plane has "
              "the point; rays through it",
          .expected = "ball and half-space meet in the point alone: nothing; their difference is the whole ball",
          .why =
              "The ball's t is a root, the plane's a quotient. Both are the same number here, but are rounded along "
              "different ways; which is the larger is luck. A comparison has to know that a - sqrt(b) = c.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_pythagoras,
          .draw = draw_pythagoras};
}

}  // namespace sightline::hard
