#include "bench/solids/scene.h"

#include <array>
#include <charconv>
#include <cmath>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"

namespace sightline::bench {
namespace {

constexpr std::string_view family = "cheese:";
constexpr std::array hole_counts{1, 4, 16, 64, 256};

SolidTree hole_along(int axis, const Vec3d& center, double half_length, double radius) {
  solid::Cylinder cylinder{center, center, radius};
  cylinder.base[axis] -= half_length;
  cylinder.top[axis] += half_length;
  return cylinder;
}

/// box - (sphere | ...), all holes together about as large whatever their number.
SolidTree cheese(int count) {
  const double radius = std::round(64 * 0.75 / std::cbrt(count)) / 64;
  Random random(1);
  const auto coordinate = [&] { return std::round(1024 * (2 * random.uniform_double() - 1)) / 1024; };
  std::vector<SolidTree> operands{solid::Box{Vec3d(-1), Vec3d(1)}};
  for (int i = 0; i < count; ++i) {
    Vec3d center;
    for (int axis = 0; axis < 3; ++axis) center[axis] = coordinate();
    // Those that no face shows would only be there to be left out.
    if (count == 1) center = Vec3d(1);
    operands.push_back(solid::Sphere{center, radius});
  }
  return {Operation::subtract, std::move(operands)};
}

SolidScene scene_of(std::string name, std::string description, std::vector<SolidTree> solids, int width, int height) {
  Aabb bounds;
  for (const SolidTree& tree : solids) bounds.extend(Solid(tree).bounds());
  SolidScene scene{
      std::move(name), std::move(description), std::move(solids), Camera::facing(bounds, width, height), {}};
  scene.light = scene.camera.eye + Vec3d(-2, 4, 1);
  return scene;
}

}  // namespace

SolidTree widget(const Vec3d& center, double half_side) {
  const double around = 1.375 * half_side, half_length = 1.5 * half_side, radius = 0.625 * half_side;
  const SolidTree body = SolidTree(solid::Box{center - half_side, center + half_side}) & solid::Sphere{center, around};
  std::vector<SolidTree> holes;
  for (int axis = 0; axis < 3; ++axis) holes.push_back(hole_along(axis, center, half_length, radius));
  return body - SolidTree(Operation::unite, std::move(holes));
}

std::vector<SolidScene> solid_scenes(int width, int height) {
  std::vector<SolidScene> scenes;
  scenes.push_back(scene_of("widget", "box & sphere - three cylinders", {widget(Vec3d(0), 1)}, width, height));
  std::vector<SolidTree> widgets;
  for (int i = 0; i < 64; ++i) widgets.push_back(widget(Vec3d(i % 4, i / 4 % 4, i / 16) * 0.625 - 0.9375, 0.25));
  scenes.push_back(scene_of("widgets", "64 of them, each a solid", std::move(widgets), width, height));
  for (const int count : hole_counts) {
    const std::string number = std::to_string(count);
    scenes.push_back(scene_of(std::string(family) + number, "box - " + number + (count == 1 ? " sphere" : " spheres"),
                              {cheese(count)}, width, height));
  }
  return scenes;
}

int holes_of(std::string_view scene) {
  int count = 0;
  if (scene.starts_with(family)) std::from_chars(scene.data() + family.size(), scene.data() + scene.size(), count);
  return count;
}

}  // namespace sightline::bench
