// All lanes of a solid at once against quick_span of one part after the other, bit for bit.
#include "sightline/csg/lane_spans.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sightline/csg/evaluator.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

using Kind = detail::QuickSpan::Kind;

struct Counts {
  std::size_t spans = 0, empty = 0, unclear = 0,
              shy = 0;  ///< Shy lanes are unclear where quick_span is not; but for floats that it scales.
};

/// Of a lattice, where rays touch and faces coincide, or of any numbers, from tiny to huge.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : random_(seed) {
    constexpr std::array scales{1.0, 1.0, 0x1p-24, 0x1p+24, 0x1p-31};
    scale_ = scales[random_.below(scales.size())];
    is_lattice_ = random_.below(2) == 0;
  }

  SolidTree solid() {
    std::vector<SolidTree> operands{solid::Box{Vec3d(-64 * scale_), Vec3d(64 * scale_)}};
    for (std::uint32_t i = 0, n = 1 + random_.below(7); i < n; ++i) operands.push_back(shape());
    return {Operation::subtract, std::move(operands)};
  }

  bool is_scaled() const { return scale_ != 1; }

  /// Each component is no zero, as lanes ask for.
  Ray<double> ray() {
    Ray<double> ray;
    ray.origin = point(4);
    const Vec3d target = point(2);
    for (int axis = 0; axis < 3; ++axis) {
      const double way = random_.below(2) == 0 ? target[axis] - ray.origin[axis] : coordinate(3);
      ray.direction[axis] = way != 0 ? way : random_.below(2) == 0 ? scale_ : -scale_ * 0x1p-20;
    }
    if (random_.below(3) == 0) ray.direction /= scale_;
    return ray;
  }

 private:
  double coordinate(int size) {
    const double x = (2 * random_.uniform_double() - 1) * size;
    return (is_lattice_ ? std::round(x) : x) * scale_;
  }
  Vec3d point(int size) {
    const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
    return {x, y, z};
  }
  SolidTree shape() {
    const double radius = random_.below(9) == 0 ? 0 : is_lattice_ ? scale_ : scale_ * (0.01 + random_.uniform_double());
    const Vec3d a = point(2), b = point(2);
    if (random_.below(3) == 0) return solid::Sphere{a, radius};
    if (random_.below(2) == 0) return solid::Box{glm::min(a, b), glm::max(a, b)};
    solid::Cylinder cylinder{a, a, radius};
    const int axis = static_cast<int>(random_.below(3));
    cylinder.top[axis] = a[axis] == b[axis] ? a[axis] + scale_ : b[axis];
    return cylinder;
  }

  Random random_;
  double scale_;
  bool is_lattice_;
};

template <Level level>
void compare(const Solid& solid, const Ray<double>& ray, bool is_scaled, Counts& counts) {
  const ConvexLanes& lanes = *solid.convex_parts()->lanes;
  const QuickRay<level> quick(ray);
  if (!quick.is_moderate() || quick.has_zero()) return;
  const LaneSpans<level> spans(lanes, quick);
  for (std::uint32_t lane = 0; lane < lanes.count(); ++lane) {
    const detail::QuickSpan span = quick_span(solid.primitives()[lanes[lane].primitive], nullptr, quick);
    if (spans.unclear() >> lane & 1) {
      ++counts.unclear;
      counts.shy += span.kind != Kind::unclear && !(level == Level::fast && is_scaled);
      continue;
    }
    if (spans.empty() >> lane & 1) {
      ++counts.empty;
      EXPECT_NE(span.kind, Kind::span);
      continue;
    }
    ++counts.spans;
    EXPECT_NE(span.kind, Kind::empty);
    const auto same = [&](const detail::QuickSpan::End& end, const Interval<double>& known, std::uint32_t index) {
      if (span.kind != Kind::span) return;
      const Interval<double> expected = LaneSpans<level>::around(end.t, end.radius);
      EXPECT_EQ(expected.lo, known.lo);
      EXPECT_EQ(expected.hi, known.hi);
      if (!lanes[lane].is_round || end.face != 0) return;
      EXPECT_EQ(spans.root(lane, index).t, end.t);
      EXPECT_EQ(spans.root(lane, index).radius, end.radius);
    };
    same(span.enter, spans.enter(lane), 0);
    same(span.leave, spans.leave(lane), 1);
  }
}

template <Level level>
void compare_many() {
  if (!has_lane_roots<level>) return;
  Counts counts;
  for (std::uint64_t seed = 0; seed < 2000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    const Solid solid(scene.solid());
    ASSERT_NE(solid.convex_parts(), nullptr);
    if (!solid.convex_parts()->lanes) continue;
    for (int i = 0; i < 50; ++i) compare<level>(solid, scene.ray(), scene.is_scaled(), counts);
  }
  EXPECT_GT(counts.spans, 15'000u);
  EXPECT_GT(counts.empty, 50'000u);
  EXPECT_GT(counts.unclear, 300u) << "hard ones";
  EXPECT_LT(counts.shy, counts.spans / 100);
}

TEST(LaneSpans, AreWhatScalarsFind) {
  compare_many<Level::fast>();
  compare_many<Level::watertight>();
  compare_many<Level::exact>();
}

TEST(LaneSpans, KnowWhichPlacesTheyHold) {
  const SolidTree body = solid::Box{Vec3d(-9), Vec3d(9)}, ball = solid::Sphere{Vec3d(0), 1};
  const SolidTree box = solid::Box{Vec3d(2, -1, -1), Vec3d(3, 1, 1)};
  const Solid solid(SolidTree(Operation::subtract, {body, ball, box}));
  ASSERT_NE(solid.convex_parts(), nullptr);
  const Ray<double> line{{-4, 0.25, 0.125}, {1, 0x1p-20, 0x1p-20}};
  const QuickRay<Level::watertight> ray(line);
  ASSERT_NE(solid.convex_parts()->lanes, nullptr);
  const LaneSpans<Level::watertight> spans(*solid.convex_parts()->lanes, ray);
  const auto at = [&](double lo, double hi) { return spans.places({lo, hi}); };
  EXPECT_EQ(at(4, 4).inside & 3, 1u);
  EXPECT_EQ(at(4, 4).outside & 3, 2u);
  EXPECT_EQ(at(6.5, 6.75).inside & 3, 2u);
  EXPECT_EQ(at(0, 0).outside & 3, 3u);
  EXPECT_EQ(at(4, 5.5).inside & 3, 0u) << "some of it";
  EXPECT_EQ(at(4, 5.5).outside & 3, 2u);
  EXPECT_EQ(at(6, 6).inside & 3, 0u) << "the very place where it begins";
  EXPECT_EQ(at(6, 6).outside & 3, 1u);
}

TEST(LaneSpans, LeaveWhatIsNotModerate) {
  const Solid solid(SolidTree(solid::Box{}) - solid::Sphere{Vec3d(0), 1.25});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  NoSolidProbe probe;
  for (const double x : {nan, infinity, 0x1p+40, 1e300}) {
    for (const bool is_origin : {true, false}) {
      Ray<double> ray{{-4, 0.5, 0.5}, {1, 0.125, 0.125}};
      (is_origin ? ray.origin : ray.direction).y = x;
      const QuickRay<Level::watertight> quick(ray);
      Boundary first;
      EXPECT_EQ((LaneWalk<Level::watertight, NoSolidProbe>(*solid.convex_parts()->lanes, quick, probe)
                     .run(0, infinity, first)),
                WalkOutcome::unclear)
          << x;
    }
  }
}

}  // namespace
}  // namespace sightline
