#pragma once
/// Where a line crosses a face, as accurately as a level asks for.

#include "sightline/csg/settle.h"
#include "sightline/math/level.h"
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

/// A double's proven bound that is not worth improving at a level.
template <Level level>
bool is_accurate(const RootList& list) {
  if (!list.is_certain) return false;
  constexpr double share = level == Level::watertight ? 0x1p-46 : 0x1p-52;
  for (int i = 0; i < list.count; ++i) {
    const Root& root = list.roots[static_cast<std::size_t>(i)];
    if (!(root.radius <= share * std::fabs(root.t))) return false;
  }
  return true;
}

}  // namespace detail

/// Levels above fast are certain of number, order and multiplicities, and t is off by less than 2^-46 of itself
/// (watertight), by less than its last place (precise), or correctly rounded (exact).
template <Level level, class S>
RootList face_roots(const S& surface, const LocalRay<level>& ray) {
  if constexpr (std::is_same_v<S, solid::Torus>) {
    if (level != Level::fast) return certain_roots(surface, ray, level);
    if (!ray.frame()) return torus_roots(surface, ray.ray(), level);
    return quartic_roots(polynomial(surface, ray.line()));
  } else {
    const RootList list = detail::roots_of(solid::form_of(surface, ray.line()));
    if constexpr (level == Level::fast) return list;
    if (level != Level::exact && detail::is_accurate<level>(list)) [[likely]]
      return list;
    return settled_roots(surface, ray, level);
  }
}

}  // namespace sightline
