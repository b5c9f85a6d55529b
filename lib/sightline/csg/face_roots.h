#pragma once
/// Where a line crosses a face, as accurately as a level asks for.

#include "sightline/csg/settle.h"
#include "sightline/math/quadratic.h"
#include "sightline/math/quartic.h"

namespace sightline {

/// A ray in the frame of a primitive, made ready for a level.
template <Level level>
class LocalRay : public FramedRay {
 public:
  using Number = std::conditional_t<level == Level::fast, float, DoubleBall>;

  explicit LocalRay(const Ray<double>& ray, const Frame* frame = nullptr)
      : FramedRay(ray, frame), line_(in<Number>()) {}

  const Line<Number>& line() const { return line_; }

 private:
  Line<Number> line_;
};

namespace detail {

template <class N>
RootList roots_of(const solid::LinearForm<N>& form) {
  return linear_roots(form.slope, form.level);
}
template <class N>
RootList roots_of(const solid::QuadraticForm<N>& form) {
  return quadratic_roots(form.a, form.b, form.c);
}

}  // namespace detail

/// Levels above fast are certain of number, order and multiplicities, and t is off by less than 2^-46 of itself
/// (watertight), by less than its last place (precise), or correctly rounded (exact).
template <Level level, class S>
RootList face_roots(const S& surface, const LocalRay<level>& ray) {
  if constexpr (std::is_same_v<S, solid::Torus>) {
    if (level != Level::fast) return certain_roots(surface, ray, level);
    if (!ray.frame()) return torus_roots(surface, ray.ray(), level);
    const Line<double> line = ray.template in<double>();
    const auto vector = [](const std::array<double, 3>& v) { return Vec3d(v[0], v[1], v[2]); };
    return torus_roots(surface, {vector(line.origin), vector(line.direction)}, level);
  } else {
    const RootList list = detail::roots_of(solid::form_of(surface, ray.line()));
    if constexpr (level == Level::fast) return list;
    if (level != Level::exact && is_accurate(list, level)) [[likely]]
      return list;
    return settled_roots(surface, ray, level);
  }
}

}  // namespace sightline
