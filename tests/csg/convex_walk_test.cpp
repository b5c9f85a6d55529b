// The walk along convex parts against the evaluation by lists, which finds the same first boundary, bit for bit.
#include <gtest/gtest.h>

#include <sstream>

#include "sightline/csg/evaluator.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

/// On a coarse lattice, so that faces coincide and spans abut, and off it.
class Convex {
 public:
  explicit Convex(std::uint64_t seed) : random_(seed) {}

  SolidTree solid() {
    std::vector<SolidTree> kept, taken;
    for (std::uint32_t i = 0, n = 1 + random_.below(3); i < n; ++i) kept.push_back(shape());
    for (std::uint32_t i = 0, n = random_.below(12); i < n; ++i) taken.push_back(shape());
    SolidTree body = kept.size() == 1 ? kept[0] : SolidTree(Operation::intersect, kept);
    if (taken.empty()) return body;
    if (random_.below(2) == 0) return body - SolidTree(Operation::unite, taken);
    taken.insert(taken.begin(), body);
    return {Operation::subtract, taken};
  }

  Ray<double> ray() {
    Ray<double> ray;
    ray.origin = point(4);
    do {
      ray.direction = point(2) - (random_.below(2) == 0 ? ray.origin : Vec3d(0));
    } while (ray.direction == Vec3d(0));
    return ray;
  }

  double coordinate(int size) {
    const double x = (2 * random_.uniform_double() - 1) * size;
    return is_lattice_ ? std::round(x) : x;
  }
  Vec3d point(int size) {
    is_lattice_ = random_.below(3) != 0;
    const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
    return {x, y, z};
  }

 private:
  SolidTree shape() {
    switch (random_.below(3)) {
      case 0:
        return solid::Sphere{point(2), 1.0 + random_.below(2)};
      case 1: {
        const Vec3d a = point(2), b = point(2);
        return solid::Box{glm::min(a, b), glm::max(a, b)};
      }
      default: {
        solid::Cylinder cylinder{point(2), point(2), 1.0 + random_.below(2)};
        if (random_.below(2) == 0) cylinder.top = {cylinder.base.x, cylinder.base.y, cylinder.top.z};
        if (cylinder.top == cylinder.base) cylinder.top.z += 1;
        return cylinder;
      }
    }
  }

  Random random_;
  bool is_lattice_ = true;
};

std::string text(const std::optional<Boundary>& boundary) {
  std::ostringstream out;
  out.precision(17);
  if (!boundary) return "nothing";
  out << boundary->t << " of primitive " << boundary->primitive << " face " << boundary->face << " root "
      << boundary->root << (boundary->is_flipped ? " flipped" : "");
  return out.str();
}

template <Level level>
std::size_t compare(std::uint64_t seed) {
  Convex convex(seed);
  const SolidTree tree = convex.solid();
  SolidOptions by_lists;
  by_lists.walk_convex = false;
  const Solid walked(tree), listed(tree, by_lists);
  EXPECT_EQ(listed.convex_parts(), nullptr);
  std::size_t found = 0;
  for (int i = 0; i < 40; ++i) {
    const Ray<double> ray = convex.ray();
    NoSolidProbe probe;
    SolidStats stats;
    SolidEvaluator<level, SolidStats> walk(walked, ray, stats);
    SolidEvaluator<level> list(listed, ray, probe);
    // From the begin, and then from boundary to boundary, as far as they come.
    double t_min = i % 4 == 0 ? -std::numeric_limits<double>::infinity() : convex.coordinate(2);
    const double t_max = i % 3 == 0 ? t_min + 1 : std::numeric_limits<double>::infinity();
    for (int k = 0; k < 30; ++k) {
      const auto a = walk.first(t_min, t_max), b = list.first(t_min, t_max);
      EXPECT_EQ(text(a), text(b)) << "seed " << seed << " ray " << i << " behind " << t_min << " to " << t_max;
      if (!a || !b || text(a) != text(b)) break;
      found += stats.nodes == 0;  // without lists for this ray
      t_min = a->t;
    }
  }
  return found;
}

template <Level level>
void compare_many() {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 1500 && !testing::Test::HasFailure(); ++seed) found += compare<level>(seed);
  EXPECT_GT(found, 800u) << "boundaries that a walk has found";
}

TEST(ConvexWalk, FindsWhatListsFind) {
  compare_many<Level::fast>();
  compare_many<Level::watertight>();
  compare_many<Level::precise>();
  compare_many<Level::exact>();
}

TEST(ConvexWalk, IsOfConvexPartsOnly) {
  const SolidTree box = solid::Box{}, ball = solid::Sphere{}, half = solid::HalfSpace{};
  EXPECT_NE(Solid(box - ball).convex_parts(), nullptr);
  EXPECT_NE(Solid((box & ball) - (ball | box)).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box | ball).convex_parts(), nullptr);
  EXPECT_EQ(Solid(~box).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box - half).convex_parts(), nullptr);
  EXPECT_EQ(Solid(box - (ball - box)).convex_parts(), nullptr);
  SolidOptions options;
  options.stop_early = false;
  EXPECT_EQ(Solid(box - ball, options).convex_parts(), nullptr);
}

}  // namespace
}  // namespace sightline
