/// The tests by which structures skip volumes, as traversals call them.

#include <array>
#include <cmath>
#include <limits>

#include "sightline/accel/bounding_box.h"
#include "sightline/accel/bounding_cylinder.h"
#include "sightline/accel/bounding_sphere.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/accel/slab_ray.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/box_question.h"

namespace sightline::hard {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Not after the true entry and not before the true exit; t_min is 0.
template <class T>
bool holds(const Interval<T>& range, const TrueClip& truth) {
  if (range.is_empty()) return false;
  const bool is_early = !(range.lo > 0) || (std::isfinite(range.lo) && Rational(range.lo) <= truth.enter);
  return is_early && (std::isinf(range.hi) || Rational(range.hi) >= truth.leave);
}

using Lanes = hn::CappedTag<float, 4>;

/// PaddedRay::clip with slabs. A template, for processors of one lane.
template <class D>
Interval<float> clip(const SlabRay<D>& slabs, const Aabb& box) {
  Interval<float> range{0, infinity};
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_negative = slabs.octant() >> axis & 1;
    const auto plane = [&](bool is_high) { return hn::Set(D(), (is_high ? box.hi : box.lo)[axis]); };
    range.lo = std::max(range.lo, hn::GetLane(slabs.enter(axis, plane(is_negative))));
    range.hi = std::min(range.hi, hn::GetLane(slabs.leave(axis, plane(!is_negative))));
  }
  return range;
}

template <class Volume>
auto range_in(const Aabb& box, const PaddedRay<float>& padded) {
  std::array<Vec3f, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] = {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                                            i & 4 ? box.hi.z : box.lo.z};
  }
  const Volume volume = Volume::around(box, corners);
  return typename Volume::template Test<float>(padded)(volume, volume, infinity).first;
}

}  // namespace

void ask_volume_tests(Trial& trial, const Aabb& scene, const Aabb& box, const Ray<float>& ray) {
  const std::optional<TrueClip> truth = true_clip(box, to_double(ray));
  if (!truth || truth->leave < 0) return;
  const auto judge = [&](std::string_view who, const auto& range) {
    trial.of(who).decide(holds(range, *truth), [&] {
      return Example{text_of(SolidTree(solid_of(box))) + ", " + text_of(to_double(ray)),
                     "[" + all_digits(static_cast<double>(truth->enter)) + ", " +
                         all_digits(static_cast<double>(truth->leave)) + "]",
                     "[" + all_digits(double(range.lo)) + ", " + all_digits(double(range.hi)) + "]"};
    });
  };
  const PaddedRay<float> padded(ray, scene);
  judge("padded ray of float", padded.clip(box, infinity));
  judge("padded ray of double", PaddedRay<double>(to_double(ray), scene).clip(box, infinity));
  judge("bounding box", range_in<BoundingBox>(box, padded));
  judge("bounding sphere", range_in<BoundingSphere>(box, padded));
  judge("bounding cylinder", range_in<BoundingCylinder>(box, padded));
  if constexpr (hn::MaxLanes(Lanes()) == 4) {
    const SlabRay<Lanes> slabs(ray, scene);
    if (slabs.is_ordinary()) judge("slab ray", clip(slabs, box));
  }
}

}  // namespace sightline::hard
