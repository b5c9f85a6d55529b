#pragma once
/// Where a line crosses a face, as accurately as a level asks for.

#include "sightline/csg/form_roots.h"
#include "sightline/csg/settle.h"

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

/// Levels above fast are certain of number, order and multiplicities, and t is off by less than 2^-46 of itself
/// (watertight), by less than its last place (precise), or correctly rounded (exact).
template <Level level, class S>
RootList face_roots(const S& surface, const LocalRay<level>& ray) {
  if constexpr (std::is_same_v<S, solid::Torus>) {
    if (level != Level::fast) return accurate_roots(surface, ray, level);
    if (!ray.frame()) return torus_roots(surface, ray.ray(), level);
    const Line<double> line = ray.template in<double>();
    const auto vector = [](const std::array<double, 3>& v) { return Vec3d(v[0], v[1], v[2]); };
    return torus_roots(surface, {vector(line.origin), vector(line.direction)}, level);
  } else {
    const RootList list = roots_of(solid::form_of(surface, ray.line()));
    if constexpr (level == Level::fast) return list;
    if (level != Level::exact && is_accurate(list, level)) [[likely]]
      return list;
    return settled_roots(surface, ray, level);
  }
}

/// A ray as all primitives of a solid see it, made ready for a level. Refers to it.
///   Q1  Where `is_moderate`, the ray suits SizedDouble, and directions are 0 or not too small to be divided by.
template <Level level>
class QuickRay {
 public:
  using Real = std::conditional_t<level == Level::fast, float, double>;
  using Number = std::conditional_t<level == Level::fast, float, SizedDouble>;

  explicit QuickRay(const Ray<double>& ray) : ray_(&ray), inverse_(Real(1) / Vec3<Real>(ray.direction)) {
    constexpr double largest = SizedDouble::largest;
    const Vec3d &o = ray.origin, &d = ray.direction;
    const Vec3d size = glm::abs(d);
    is_moderate_ = (std::fabs(o.x) <= largest) & (std::fabs(o.y) <= largest) & (std::fabs(o.z) <= largest) &
                   is_divisor(size.x) & is_divisor(size.y) & is_divisor(size.z);
    has_zero_ = (size.x == 0) | (size.y == 0) | (size.z == 0);
    is_valid_ = is_moderate_ ? (size.x + size.y + size.z > 0) & (ray.t_min <= ray.t_max) : sightline::is_valid(ray);
  }

  const Ray<double>& ray() const { return *ray_; }
  bool is_moderate() const { return is_moderate_; }
  bool has_zero() const { return has_zero_; }
  const Vec3<Real>& inverse() const { return inverse_; }  ///< Of the direction.
  bool is_valid() const { return is_valid_; }

  /// Where a plane across an axis is passed, if the direction is not 0 there. In double off by three roundings:
  /// passing_share of it, and less than passing_step where that underflows.
  Real passing(int axis, double position) const {
    return (static_cast<Real>(position) - static_cast<Real>(ray_->origin[axis])) * inverse_[axis];
  }
  static double radius_of(double t) { return level == Level::fast ? 0 : passing_share * std::fabs(t) + passing_step; }
  static constexpr double passing_share = 0x1p-51, passing_step = 0x1p-900;

 private:
  static bool is_divisor(double size) {
    constexpr double largest = SizedDouble::largest;
    return ((size == 0) | (size >= 1 / largest)) & (size <= largest);
  }

  const Ray<double>* ray_;
  Vec3<Real> inverse_;
  bool is_moderate_, has_zero_, is_valid_;
};

namespace detail {

/// In line to the last operation, so that the compiler knows how deep each expression is.
template <class N, class S>
[[gnu::flatten]] RootList roots_in_world(const S& surface, const Ray<double>& ray) {
  return roots_of(solid::form_of(surface, FramedRay(ray).in_world<N>()));
}
template <class N, class S>
[[gnu::flatten]] RootList roots_in_frame(const S& surface, const Ray<double>& ray, const Frame& frame) {
  return roots_of(solid::form_of(surface, FramedRay(ray, &frame).in<N>()));
}

}  // namespace detail

/// As certain as face_roots of number, order and multiplicities, but as for t only of its radius, which may be larger.
template <Level level, class S>
RootList quick_roots(const S& surface, const QuickRay<level>& quick, const Frame* frame, bool is_moderate) {
  if constexpr (std::is_same_v<S, solid::Torus>) {
    if constexpr (level != Level::fast) return certain_roots(surface, FramedRay(quick.ray(), frame));
    return face_roots<level>(surface, LocalRay<level>(quick.ray(), frame));
  } else {
    using Number = typename QuickRay<level>::Number;
    if (is_moderate && quick.is_moderate()) [[likely]] {
      if constexpr (std::is_same_v<S, solid::AxisPlane>) {
        if (!frame && quick.ray().direction[surface.axis] != 0) {
          RootList list;
          const double t = quick.passing(surface.axis, surface.position);
          list.add({t, quick.radius_of(t), 1});
          list.begins_negative = surface.is_upper == (quick.ray().direction[surface.axis] > 0);
          return list;
        }
      }
      const RootList list = frame ? detail::roots_in_frame<Number>(surface, quick.ray(), *frame)
                                  : detail::roots_in_world<Number>(surface, quick.ray());
      if (list.is_certain) [[likely]]
        return list;
    }
    return face_roots<level>(surface, LocalRay<level>(quick.ray(), frame));
  }
}

}  // namespace sightline
