#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/axes/root_choice.h"
#include "bench/accuracy/chance.h"
#include "sightline/csg/face_roots.h"
#include "sightline/shape/sphere.h"

namespace sightline::bench {
namespace {

struct Question {
  Ray<double> ray;  ///< Of floats.
  solid::Sphere sphere;
};

/// |o - c + t d|^2 = r^2, multiplied out.
template <class T>
FewRoots textbook(const Question& question) {
  const Vec3<T> from = Vec3<T>(question.ray.origin) - Vec3<T>(question.sphere.center), d(question.ray.direction);
  const T radius = static_cast<T>(question.sphere.radius);
  const T a = glm::dot(d, d), b = glm::dot(from, d), c = glm::dot(from, from) - radius * radius;
  const T discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return {};
  if (discriminant == 0) return {1, {-b / a}};
  const T root = std::sqrt(discriminant);
  return in_order((-b - root) / a, (-b + root) / a);
}

/// Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", in "Ray Tracing Gems",
/// 2019: the discriminant from the line's closest point, the roots by Kahan's formula.
template <class T>
FewRoots from_closest_point(const Question& question) {
  const Vec3<T> from = Vec3<T>(question.ray.origin) - Vec3<T>(question.sphere.center), d(question.ray.direction);
  const T radius = static_cast<T>(question.sphere.radius);
  const T a = glm::dot(d, d), b = -glm::dot(from, d), c = glm::dot(from, from) - radius * radius;
  const Vec3<T> closest = from + (b / a) * d;
  const T discriminant = radius * radius - glm::dot(closest, closest);
  if (!(discriminant >= 0)) return {};
  if (discriminant == 0) return {1, {b / a}};
  const T q = b + std::copysign(std::sqrt(a * discriminant), b);
  return in_order(c / q, q / a);
}

template <Level level>
FewRoots ours(const Question& question) {
  return few_of(face_roots<level>(question.sphere, LocalRay<level>(question.ray)));
}

FewRoots of_sphere_set(const Question& question) {
  const Sphere sphere{Vec3f(question.sphere.center), static_cast<float>(question.sphere.radius)};
  FewRoots roots;
  SphereSet::PreparedRay(question.ray).for_each_crossing(sphere, [&](const Crossing& crossing) {
    roots.at[static_cast<std::size_t>(roots.count++)] = crossing.t;
  });
  if (roots.count == 2 && roots.at[0] == roots.at[1]) roots.count = 1;
  return roots;
}

/// Spheres of radius 1 as seen from 10 to 10,000 away; grazing: past the silhouette by 2^-10 to 2^-40 of the radius.
Panel panel_of(const Effort& effort, bool is_grazing) {
  Chance chance(effort.seed);
  const auto count = effort.count(20'000, 4'000);
  auto questions = std::make_shared<std::vector<Question>>();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f center(chance.point(4)), from(Vec3d(center) + chance.scale(10, 10'000) * chance.direction());
    const Vec3d toward = glm::normalize(Vec3d(center) - Vec3d(from));
    const Vec3d side = glm::normalize(glm::cross(toward, chance.direction()));
    const double beside = is_grazing ? 1 + chance.sign() * chance.scale(0x1p-40, 0x1p-10) : std::sqrt(chance.unit());
    const Vec3d to = Vec3d(center) + beside * side;
    questions->push_back(
        {{Vec3d(from), Vec3d(Vec3f(chance.scale(0.25, 4) * glm::normalize(to - Vec3d(from))))}, {Vec3d(center), 1}});
  }
  std::vector<std::vector<True>> truths;
  for (const Question& q : *questions) truths.push_back(true_sphere_roots(q.sphere.center, q.sphere.radius, q.ray));
  Panel panel{is_grazing ? "grazing" : "hits",
              is_grazing
                  ? "rays past the silhouette of spheres 10 to 10,000 radii away, by 2^-40 to 2^-10 of the radius"
                  : "rays at spheres 10 to 10,000 radii away",
              "sphere",
              "of a point, in radii",
              is_grazing ? ErrorKind::wrong : ErrorKind::maximum,
              static_cast<double>(count)};
  const auto add = [&]<class Solve>(const std::string& name, Solve solve) {
    panel.choices.push_back(
        root_choice(name, std::shared_ptr<const std::vector<Question>>(questions), truths, solve,
                    [](const Question& question, const True&) { return 1 / glm::length(question.ray.direction); }));
  };
  add("textbook float", [](const Question& q) { return textbook<float>(q); });
  add("textbook double", [](const Question& q) { return textbook<double>(q); });
  add("Haines float", [](const Question& q) { return from_closest_point<float>(q); });
  add("Haines double", [](const Question& q) { return from_closest_point<double>(q); });
  add("ours, sphere set", [](const Question& q) { return of_sphere_set(q); });
  add("ours fast", [](const Question& q) { return ours<Level::fast>(q); });
  add("ours watertight", [](const Question& q) { return ours<Level::watertight>(q); });
  add("ours precise", [](const Question& q) { return ours<Level::precise>(q); });
  add("ours exact", [](const Question& q) { return ours<Level::exact>(q); });
  return panel;
}

}  // namespace

Axis sphere_axis() {
  return {"sphere", "how the crossings of a line and a sphere are found", [](const Effort& effort) {
            return std::vector{panel_of(effort, false), panel_of(effort, true)};
          }};
}

}  // namespace sightline::bench
