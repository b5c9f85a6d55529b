#pragma once

#include "sightline/accel/bounding_volumes.h"
#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"
#include "sightline/math/simd.h"
#include "sightline/math/smallest_ball.h"

namespace sightline {

/// A ball as a bounding volume (Rubin and Whitted, "A 3-Dimensional Representation for Fast Rendering of Complex
/// Scenes", 1980, proposed hierarchies; Larsson, "Fast and Tight Fitting Bounding Spheres", 2008).
struct BoundingSphere {
  Sphere ball;

  static constexpr std::string_view tree_name = "sphere-tree";
  static constexpr std::string_view tree_description =
      "smallest enclosing balls by surface area, nearer child first (Welzl 1991; Larsson 2008)";
  static constexpr bool needs_points = true;
  static constexpr float test_cost = 1.5f;

  /// The center lies within the box, so that it is no farther from a ray's origin than the scene.
  static BoundingSphere around(const Aabb& box, std::span<const Vec3f> points) {
    const Vec3d exact = SmallestBall::center(
        points.size(), [&](std::size_t i) { return Vec3d(points[i]); }, 4);
    const Vec3f center = glm::clamp(Vec3f(exact), box.lo, box.hi);
    double radius2 = 0;
    for (const Vec3f& p : points) {
      const Vec3d offset = Vec3d(p) - Vec3d(center);
      radius2 = std::fmax(radius2, glm::dot(offset, offset));
    }
    constexpr double rounding = 1 + 0x1p-50;  // two units of each distance, plus that of the product here
    return {{center, round_up(std::sqrt(radius2) * rounding)}};
  }

  /// The ball through the corners, up to a constant factor.
  static float half_area_around(float x, float y, float z) { return x * x + y * y + z * z; }

  const Sphere& region() const { return ball; }

  /// The chord, from the vector between the center and the point of the line closest to it, which cancels nothing
  /// (Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", 2019).
  ///
  /// Both at once, in double. Why it is never too short: let R be the radius and the pad, and R1 the radius and half
  /// the pad, the ball that must not be missed. `offset` and `middle` are rounded ten times, each at most 2^-53 of 1.75
  /// reach, so e < 2^-48 reach; R^2 - R1^2 >= R1 pad, while the error of `rest` is at most 2 R e + 2^-52 R^2. So `rest`
  /// is negative only where the line misses R1, and half the chord exceeds that of R1 by at least R1 pad / (2 R) > pad
  /// / 4 > 2^-36 reach, more than the ends are rounded by.
  template <class T>
  class Test {
   public:
    using Time = double;

    explicit Test(const PaddedRay<T>& ray) : ray_(ray) {}

    [[gnu::always_inline]] PairTimes<double> operator()(const BoundingSphere& first, const BoundingSphere& second,
                                                        double far) const {
      const auto dx = hn::Set(d, ray_.direction.x), dy = hn::Set(d, ray_.direction.y),
                 dz = hn::Set(d, ray_.direction.z);
      const auto a = load(first), b = load(second);
      const auto xy = hn::InterleaveLower(f, a, b), zr = hn::InterleaveUpper(f, a, b);
      const auto x = hn::Sub(hn::PromoteTo(d, hn::LowerHalf(xy)), hn::Set(d, ray_.origin.x));
      const auto y = hn::Sub(hn::PromoteTo(d, hn::UpperHalf(half, xy)), hn::Set(d, ray_.origin.y));
      const auto z = hn::Sub(hn::PromoteTo(d, hn::LowerHalf(zr)), hn::Set(d, ray_.origin.z));
      const auto radius = hn::Add(hn::PromoteTo(d, hn::UpperHalf(half, zr)), hn::Set(d, ray_.pad));
      const auto middle = hn::MulAdd(x, dx, hn::MulAdd(y, dy, hn::Mul(z, dz)));
      const auto ox = hn::NegMulAdd(middle, dx, x), oy = hn::NegMulAdd(middle, dy, y),
                 oz = hn::NegMulAdd(middle, dz, z);
      const auto offset2 = hn::MulAdd(ox, ox, hn::MulAdd(oy, oy, hn::Mul(oz, oz)));
      const auto rest = hn::Sub(hn::Mul(radius, radius), offset2);
      // Empty where `rest` is negative; a NaN is not, and bounds nothing below.
      const auto is_missed = hn::Lt(rest, hn::Zero(d));
      if (hn::AllTrue(d, is_missed)) return {{1, 0}, {1, 0}};
      const auto half_chord = hn::Sqrt(rest), scale = hn::Set(d, ray_.time_per_length);
      const auto enter = larger(hn::Mul(hn::Sub(middle, half_chord), scale), hn::Set(d, ray_.t_min));
      const auto leave = smaller(hn::Mul(hn::Add(middle, half_chord), scale), hn::Set(d, far));
      const auto none = hn::Set(d, -std::numeric_limits<double>::infinity());
      double lo[2], hi[2];
      hn::StoreU(enter, d, lo);
      hn::StoreU(hn::IfThenElse(is_missed, none, leave), d, hi);
      return {{lo[0], hi[0]}, {lo[1], hi[1]}};
    }

   private:
    static constexpr hn::FixedTag<double, 2> d{};

    static constexpr hn::FixedTag<float, 2> half{};
    static constexpr hn::FixedTag<float, 4> f{};

    static auto load(const BoundingSphere& volume) {
      static_assert(sizeof(Sphere) == 4 * sizeof(float));  // center and radius
      return hn::LoadU(f, &volume.ball.center.x);
    }

    DistanceRay<T> ray_;
  };
};

static_assert(BoundingVolume<BoundingSphere>);

}  // namespace sightline
