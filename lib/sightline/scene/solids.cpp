#include "sightline/scene/solids.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using solid::Box;
using solid::Cone;
using solid::Cylinder;
using solid::Sphere;
using solid::Torus;

using Vector = std::array<double, 3>;

SolidTree of(std::string_view material, SolidTree tree) {
  tree.material = material;
  return tree;
}

SolidTree joined(Operation operation, std::vector<SolidTree> args) { return {operation, std::move(args)}; }

/// Along an axis and through the origin, from -reach to reach.
Cylinder rod(int axis, double radius, double reach) {
  Vec3d end(0);
  end[axis] = reach;
  return {-end, end, radius};
}

SolidTree widget() {
  return (of("red", Box{}) & of("blue", Sphere{Vec3d(0), 1.3})) -
         joined(Operation::unite,
                {of("green", rod(0, 0.6, 1.5)), of("green", rod(1, 0.6, 1.5)), of("green", rod(2, 0.6, 1.5))});
}

/// Two unit spheres at distance 1.
SolidTree two_spheres(Operation operation) {
  return joined(operation, {of("red", Sphere{Vec3d(-0.5, 0, 0), 1}), of("blue", Sphere{Vec3d(0.5, 0, 0), 1})});
}

/// The unit cube, side 2, less square holes in its three directions: of each level the 8 in the middles of the 8 parts
/// that the level before left beside its own, and so on. 20/27 of the volume remain at each level.
SolidTree menger(int levels) {
  std::vector<SolidTree> args{of("sand", Box{})};
  int side = 1;  // holes of a level and what lies between them, along an edge
  for (int level = 0; level < levels; ++level, side *= 3) {
    const double cell = 2.0 / side;
    for (int i = 0; i < side * side; ++i) {
      const int column = i % side, row = i / side;
      bool is_open = false;  // already part of a larger hole
      for (int c = column, r = row; c > 0 || r > 0; c /= 3, r /= 3) is_open |= c % 3 == 1 && r % 3 == 1;
      if (is_open) continue;
      const double across = -1 + cell * column, along = -1 + cell * row;
      for (int axis = 0; axis < 3; ++axis) {
        Box hole{Vec3d(-1), Vec3d(1)};
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        hole.lo[next] = across + cell / 3, hole.hi[next] = across + 2 * cell / 3;
        hole.lo[last] = along + cell / 3, hole.hi[last] = along + 2 * cell / 3;
        args.push_back(of(level % 2 == 0 ? "rust" : "teal", hole));
      }
    }
  }
  return joined(Operation::subtract, std::move(args));
}

SolidTree swiss_cheese(int holes) {
  std::vector<SolidTree> args{of("cheese", Box{Vec3d(-1, -0.6, -0.8), Vec3d(1, 0.6, 0.8)})};
  Random random(2026);
  const double largest = 0.62 / std::cbrt(holes / 6.0 + 1);
  for (int i = 0; i < holes; ++i) {
    const double x = 2 * random.uniform_double() - 1, y = 1.2 * random.uniform_double() - 0.6;
    const double z = 1.6 * random.uniform_double() - 0.8;
    args.push_back(of("amber", Sphere{Vec3d(x, y, z), largest * (0.5 + 0.5 * random.uniform_double())}));
  }
  return joined(Operation::subtract, std::move(args));
}

SolidTree pawn() {
  const SolidTree foot = of("walnut", Cylinder{Vec3d(0, 0, 0), Vec3d(0, 0.18, 0), 0.85});
  const SolidTree base = of("walnut", Torus{Vec3d(0, 0.3, 0), Vec3d(0, 1, 0), 0.58, 0.16});
  const SolidTree body = of("oak", Cone{Vec3d(0, 2.4, 0), Vec3d(0, 0.18, 0), 0.66});
  const SolidTree groove = of("walnut", Torus{Vec3d(0, 0.95, 0), Vec3d(0, 1, 0), 0.52, 0.13});
  const SolidTree collar = of("walnut", Torus{Vec3d(0, 1.52, 0), Vec3d(0, 1, 0), 0.27, 0.11});
  const SolidTree head = of("oak", Sphere{Vec3d(0, 2, 0), 0.44});
  return joined(Operation::unite, {foot, base, body - groove, collar, head});
}

SolidTree rocket() {
  const SolidTree hull = of("ivory", Cylinder{Vec3d(0, 0.4, 0), Vec3d(0, 2, 0), 0.42});
  const SolidTree nose = of("red", Cone{Vec3d(0, 3, 0), Vec3d(0, 2, 0), 0.42});
  const SolidTree frame = of("brass", Torus{Vec3d(0, 1.5, 0.4), Vec3d(0, 0, 1), 0.2, 0.06});
  const SolidTree window = of("sky", Sphere{Vec3d(0, 1.5, 0.3), 0.23});
  const SolidTree fins = of("blue", Cone{Vec3d(0, 2, 0), Vec3d(0, -0.1, 0), 1.25}) &
                         (of("blue", Box{Vec3d(-1.3, -0.2, -0.05), Vec3d(1.3, 2, 0.05)}) |
                          of("blue", Box{Vec3d(-0.05, -0.2, -1.3), Vec3d(0.05, 2, 1.3)}));
  const SolidTree nozzle = of("steel", Cone{Vec3d(0, 0.9, 0), Vec3d(0, 0, 0), 0.45}) -
                           of("steel", Cone{Vec3d(0, 0.7, 0), Vec3d(0, -0.1, 0), 0.42});
  return joined(Operation::unite, {hull - window, nose, frame, fins, nozzle});
}

constexpr Vector from_left{-2.4, 0.35, 0.45}, to_right{1, 0, 0};

/// What is looked at first comes first.
constexpr auto infos = std::to_array<SolidInfo>({
    {"widget", "(box & sphere) - three cylinders", 0, 0, 0, {-2.375, 0.5, 0.5}, {1, 0.03125, -0.0625}},
    {"lens", "sphere & sphere: volume 5/12 pi", 0, 0, 0, {-2.25, 0.25, 0}, {1, 0, 0}},
    {"lune", "sphere - sphere: 11/12 pi", 0, 0, 0, {-2.25, 0.25, 0}, {1, 0, 0}},
    {"peanut", "sphere | sphere: 9/4 pi", 0, 0, 0, {-2.25, 0.25, 0}, {1, 0, 0}},
    {"moons", "sphere ^ sphere: in one, not in both", 0, 0, 0, {-2.25, 0.25, 0}, {1, 0, 0}},
    {"napkin-ring", "sphere - cylinder, which sticks out of it", 0, 0, 0, {-2, 0.25, 0.2}, {1, 0, 0}},
    {"shell", "sphere - smaller sphere", 0, 0, 0, {-2, 0.25, 0.2}, {1, 0, 0}},
    {"bicylinder", "two crossing cylinders' intersection: 16/3", 0, 0, 0, {-2.4, 0.35, 0.45}, {1, 0, 0}},
    {"tricylinder", "three cylinders' intersection: 8 (2 - sqrt 2)", 0, 0, 0, {-2.4, 0.35, 0.45}, {1, 0, 0}},
    {"cube-sphere", "cube & sphere", 0, 0, 0, from_left, to_right},
    {"bowl-cube", "cube - sphere that cuts its faces", 0, 0, 0, {-2, 0.5, 0.75}, {1, 0.125, 0}},
    {"menger", "Menger's sponge, a cube less holes; size: levels", 2, 1, 4, {-2, 0.55, 0.3}, {1, 0.0625, 0.125}},
    {"swiss-cheese", "box - N spheres; size: N", 12, 1, 4096, {-2, 0.1, 0.15}, {1, 0, 0}},
    {"holes", "box - cylinder whose caps lie in its faces", 0, 0, 0, {-1, 1.25, 0.125}, {1.125, -1, 0}},
    {"not-a-sphere", "all but a sphere, without end", 0, 0, 0, {-2, 0.5, 0.25}, {1, 0, 0}},
    {"nothing", "a sphere less itself", 0, 0, 0, {-2, 0.5, 0.25}, {1, 0, 0}},
    {"pawn", "a chessman turned of cones and tori", 0, 0, 0, {-0.8, 2.9, 0.25}, {0.5, -1, -0.0625}},
    {"rocket", "cylinder, cones, a torus; fins cut of a cone", 0, 0, 0, {-1.75, 0.2, 0.75}, {1, 0.375, -0.25}},
});

SolidTree make(std::string_view name, int size) {
  const SolidTree sphere = of("red", Sphere{});
  if (name == "lens") return two_spheres(Operation::intersect);
  if (name == "lune") return two_spheres(Operation::subtract);
  if (name == "peanut") return two_spheres(Operation::unite);
  if (name == "moons") return two_spheres(Operation::differ);
  if (name == "napkin-ring") return of("ivory", Sphere{}) - of("teal", rod(1, 0.6, 1.5));
  if (name == "shell") return of("ivory", Sphere{}) - of("rust", Sphere{Vec3d(0), 0.8});
  if (name == "bicylinder") return of("steel", rod(0, 1, 1.5)) & of("brass", rod(1, 1, 1.5));
  if (name == "tricylinder") {
    return joined(Operation::intersect,
                  {of("steel", rod(0, 1, 1.5)), of("brass", rod(1, 1, 1.5)), of("rust", rod(2, 1, 1.5))});
  }
  if (name == "cube-sphere") return of("oak", Box{}) & of("blue", Sphere{Vec3d(0), 1.3});
  if (name == "bowl-cube") return of("oak", Box{}) - of("blue", Sphere{Vec3d(0), 1.3});
  if (name == "menger") return menger(size);
  if (name == "swiss-cheese") return swiss_cheese(size);
  if (name == "holes")
    return of("oak", Box{Vec3d(-1.2, -0.5, -0.8), Vec3d(1.2, 0.5, 0.8)}) -
           of("steel", Cylinder{Vec3d(0, -0.5, 0), Vec3d(0, 0.5, 0), 0.5});
  if (name == "not-a-sphere") return ~sphere;
  if (name == "nothing") return sphere - sphere;
  if (name == "pawn") return pawn();
  if (name == "rocket") return rocket();
  return widget();
}

int parse_size(const SolidInfo& info, std::string_view text) {
  int size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error == std::errc() && end == text.data() + text.size() && size >= info.lowest && size <= info.highest &&
      info.default_size != 0) {
    return size;
  }
  throw std::invalid_argument(
      "solid " + std::string(info.name) + ": expected " +
      (info.default_size == 0 ? "no size"
                              : "a size from " + std::to_string(info.lowest) + " to " + std::to_string(info.highest)) +
      ", found \"" + std::string(text) + "\"");
}

}  // namespace

std::span<const SolidInfo> solid_infos() { return infos; }

const SolidInfo& solid_info(const std::string& spec) {
  const std::string_view name = std::string_view(spec).substr(0, spec.find(':'));
  for (const SolidInfo& info : infos) {
    if (info.name == name) return info;
  }
  std::string names;
  for (const SolidInfo& info : infos) names += " " + std::string(info.name);
  throw std::invalid_argument("solid: expected a .json file or one of" + names + ", found \"" + spec + "\"");
}

SolidTree load_solid(const std::string& spec) {
  const SolidInfo& info = solid_info(spec);
  const std::size_t colon = spec.find(':');
  const int size =
      colon == std::string::npos ? info.default_size : parse_size(info, std::string_view(spec).substr(colon + 1));
  return make(info.name, size);
}

}  // namespace sightline
