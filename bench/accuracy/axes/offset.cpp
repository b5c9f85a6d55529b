#include <bit>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/chance.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "bench/estimate.h"

namespace sightline::bench {
namespace {

/// A point of a triangle, known by its weights, and where it goes on to: through a second triangle that lies a small
/// gap above, and is large enough that it must be met.
struct Question {
  Triangle triangle, above;
  float u, v;
  Vec3f normal;  ///< Of unit length as float has it, toward the triangle above.
  Vec3f direction;
  double size;
};
using Questions = std::vector<Question>;

constexpr double lowest_scale = 1e-4, highest_scale = 1e7, gap = 0x1p-10;  ///< The gap in sizes.

Questions questions_of(const Effort& effort, double reach) {
  Chance chance(effort.seed);
  Questions questions(effort.count(20'000, 4'000));
  for (Question& q : questions) {
    q.size = chance.scale(lowest_scale, highest_scale);
    const Vec3d corner = q.size * chance.point(reach), normal = chance.direction();
    const Vec3d side = glm::normalize(glm::cross(normal, chance.direction())), up = glm::cross(normal, side);
    const auto point = [&](double x, double y, double z) {
      return Vec3f(corner + q.size * (x * side + y * up + z * normal));
    };
    q.triangle = {point(0, 0, 0), point(1, 0, 0), point(chance.unit(), 1, 0)};
    q.above = {point(-64, -64, gap), point(128, -64, gap), point(-64, 128, gap)};
    const double root = std::sqrt(chance.unit()), share = chance.unit();
    q.u = static_cast<float>(root * share), q.v = static_cast<float>(root * (1 - share));
    const Vec3d a(q.triangle.a);
    q.normal = Vec3f(glm::normalize(glm::cross(Vec3d(q.triangle.b) - a, Vec3d(q.triangle.c) - a)));
    // A sixteenth of the length at least leads up, so that the second surface is met within its size.
    const double rise = chance.scale(0x1p-4, 1);
    const Vec3d along = glm::normalize(glm::cross(normal, chance.direction()));
    q.direction = Vec3f(rise * normal + std::sqrt(1 - rise * rise) * along);
  }
  return questions;
}

Vec3f point_of(const Question& q) {
  return q.triangle.a + q.u * (q.triangle.b - q.triangle.a) + q.v * (q.triangle.c - q.triangle.a);
}

struct AsItIs {
  Vec3f operator()(const Question& q) const { return point_of(q); }
};
struct Fixed {
  Vec3f operator()(const Question& q) const { return point_of(q) + 1e-4f * q.normal; }
};
struct AlongRay {
  Vec3f operator()(const Question& q) const { return point_of(q) + 1e-4f * q.direction; }
};
struct Relative {
  Vec3f operator()(const Question& q) const {
    const Vec3f p = point_of(q);
    return p + 1e-4f * max_norm(p) * q.normal;
  }
};

/// Waechter and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", in "Ray Tracing Gems", 2019: so many
/// units in the last place along the normal, and a fixed length near the origin.
struct WaechterBinder {
  Vec3f operator()(const Question& q) const {
    constexpr float near_origin = 1.0f / 32, fixed_length = 1.0f / 65536, units = 256;
    const Vec3f p = point_of(q);
    Vec3f moved;
    for (int axis = 0; axis < 3; ++axis) {
      const auto steps = static_cast<std::int32_t>(units * q.normal[axis]);
      const auto bits = std::bit_cast<std::int32_t>(p[axis]) + (p[axis] < 0 ? -steps : steps);
      moved[axis] =
          std::fabs(p[axis]) < near_origin ? p[axis] + fixed_length * q.normal[axis] : std::bit_cast<float>(bits);
    }
    return moved;
  }
};

/// Ours, as query/workloads.cpp has it: the point in double, lifted by twice what rounding it to float can lower it.
struct ErrorBound {
  Vec3f operator()(const Question& q) const {
    const Vec3d a(q.triangle.a), ab = Vec3d(q.triangle.b) - a, ac = Vec3d(q.triangle.c) - a;
    const Vec3d p = a + double(q.u) * ab + double(q.v) * ac, normal = glm::cross(ab, ac);
    const Vec3d unit = normal / glm::length(normal);
    return Vec3f(p + (2 * 0x1p-24 * glm::dot(glm::abs(unit), glm::abs(p))) * unit);
  }
};

template <class Move>
Choice choice_of(const std::string& name, const std::shared_ptr<const Questions>& questions) {
  const Move move;
  ErrorSum sum;
  std::size_t self_hits = 0, leaks = 0;
  for (const Question& q : *questions) {
    const Vec3d origin(move(q));
    const Ray<double> ray{origin, Vec3d(q.direction)};
    const auto again = true_crossing(q.triangle, ray), next = true_crossing(q.above, ray);
    const bool is_self_hit = again && again->t.high > 0, is_leak = !next || !(next->t.high > 0);
    self_hits += is_self_hit, leaks += is_leak;
    sum.decide(!is_self_hit && !is_leak);
    const Vec3d a(q.triangle.a);
    const Vec3d at = a + double(q.u) * (Vec3d(q.triangle.b) - a) + double(q.v) * (Vec3d(q.triangle.c) - a);
    sum.add(glm::length(origin - at) / q.size);
  }
  const auto pass = [questions, move] {
    Vec3f all(0);
    for (const Question& question : *questions) all += move(question);
    return static_cast<double>(all.x + all.y + all.z);
  };
  const double share = 100 / static_cast<double>(questions->size());
  return {name,
          sum.errors(),
          pass,
          {{"self-hits %", share * static_cast<double>(self_hits)}, {"leaks %", share * static_cast<double>(leaks)}}};
}

Panel panel_of(const Effort& effort, double reach) {
  const auto questions = std::make_shared<const Questions>(questions_of(effort, reach));
  const std::string sizes = number_text(reach, 1) + " sizes";
  Panel panel{"within " + sizes,
              "rays that leave triangles of size 1e-4 to 1e7, up to " + sizes +
                  " along each axis from the origin, below a second surface 2^-10 sizes away; wrong: the first is met "
                  "again, or the second missed",
              "ray",
              "of the ray's origin, in sizes",
              ErrorKind::wrong,
              static_cast<double>(questions->size())};
  panel.choices = {choice_of<AsItIs>("none", questions),
                   choice_of<Fixed>("fixed 1e-4, along the normal", questions),
                   choice_of<AlongRay>("fixed 1e-4, along the ray", questions),
                   choice_of<Relative>("relative 1e-4", questions),
                   choice_of<WaechterBinder>("Waechter-Binder", questions),
                   choice_of<ErrorBound>("ours, error bound", questions)};
  return panel;
}

}  // namespace

Axis offset_axis() {
  return {"offset", "where a ray begins that leaves a surface", [](const Effort& effort) {
            return std::vector{panel_of(effort, 4), panel_of(effort, 64)};
          }};
}

}  // namespace sightline::bench
