#pragma once
/// Where a ray is inside the commonest primitives, where that is clear at once.

#include <array>
#include <cmath>
#include <variant>

#include "sightline/csg/face_roots.h"
#include "sightline/csg/span_list.h"

namespace sightline::detail {

/// One span, both ends of which are faces passed at clearly different t, or none.
struct QuickSpan {
  struct End {
    double t, radius;
    std::uint32_t face, root;
  };

  enum class Kind { unclear, empty, span };

  Kind kind = Kind::unclear;
  End enter{}, leave{};
};

/// Each shape's is one function with all that it calls in line, so that the compiler knows how deep every expression is
/// and keeps what it finds in registers.
template <Level level>
class QuickSpans {
 public:
  using End = QuickSpan::End;
  using Kind = QuickSpan::Kind;

  QuickSpans(const QuickRay<level>& ray, const Frame* frame) : ray_(ray), frame_(frame) {}

  [[gnu::flatten, gnu::noinline]] QuickSpan operator()(const solid::Sphere& sphere) const {
    return between_roots(sphere);
  }

  [[gnu::flatten, gnu::noinline]] QuickSpan operator()(const solid::Box& box) const {
    if (frame_ || ray_.has_zero()) return {};
    const Vec3d& direction = ray_.ray().direction;
    std::array<double, 3> in, out;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = ray_.passing(axis, box.lo[axis]), b = ray_.passing(axis, box.hi[axis]);
      in[static_cast<std::size_t>(axis)] = a < b ? a : b;
      out[static_cast<std::size_t>(axis)] = a < b ? b : a;
    }
    std::size_t last_in = in[1] > in[0], first_out = out[1] < out[0];
    last_in = in[2] > in[last_in] ? 2 : last_in;
    first_out = out[2] < out[first_out] ? 2 : first_out;
    const double enter = in[last_in], leave = out[first_out];
    if (!are_apart(enter, leave)) return {};
    if (enter > leave) return {Kind::empty, {}, {}};
    // Each of the others, of which the one itself is not one.
    const std::size_t i = last_in == 0, j = 2 - (last_in == 2), k = first_out == 0, l = 2 - (first_out == 2);
    if (!are_apart(enter, in[i]) || !are_apart(enter, in[j]) || !are_apart(leave, out[k]) || !are_apart(leave, out[l]))
      return {};
    const auto face = [&](std::size_t axis, bool is_in) {
      return static_cast<std::uint32_t>(2 * axis + ((direction[static_cast<int>(axis)] > 0) != is_in));
    };
    return {Kind::span,
            {enter, ray_.radius_of(enter), face(last_in, true), 0},
            {leave, ray_.radius_of(leave), face(first_out, false), 0}};
  }

  [[gnu::flatten, gnu::noinline]] QuickSpan operator()(const solid::Cylinder& cylinder) const {
    QuickSpan span = between_roots(cylinder);
    if (span.kind != Kind::span) return span;
    const int axis = axis_across(cap_of(cylinder, true));
    if (frame_ || axis < 0 || ray_.ray().direction[axis] == 0) return {};
    const bool goes_up = (cylinder.top[axis] > cylinder.base[axis]) == (ray_.ray().direction[axis] > 0);
    const double base = ray_.passing(axis, cylinder.base[axis]), top = ray_.passing(axis, cylinder.top[axis]);
    const End at_base{base, ray_.radius_of(base), 1, 0}, at_top{top, ray_.radius_of(top), 2, 0};
    const End &enter = goes_up ? at_base : at_top, &leave = goes_up ? at_top : at_base;
    if (!keep_later(span.enter, enter) || !keep_earlier(span.leave, leave)) return {};
    return between(span.enter, span.leave);
  }

 private:
  template <class S>
  QuickSpan between_roots(const S& surface) const {
    using Number = typename QuickRay<level>::Number;
    const RootList list = frame_ ? roots_of(form_of(surface, FramedRay(ray_.ray(), frame_).template in<Number>()))
                                 : roots_of(form_of(surface, FramedRay(ray_.ray()).template in_world<Number>()));
    if (!list.is_certain || list.begins_negative) return {};
    if (list.count == 0) return {Kind::empty, {}, {}};
    if (list.count != 2) return {};
    return {Kind::span, {list.roots[0].t, list.roots[0].radius, 0, 0}, {list.roots[1].t, list.roots[1].radius, 0, 1}};
  }

  /// Of where planes across axes are passed.
  static bool are_apart(double a, double b) {
    if (level == Level::fast) return a != b;
    constexpr double share = QuickRay<level>::passing_share * (1 + 0x1p-40);
    return std::fabs(a - b) > (std::fabs(a) + std::fabs(b)) * share + 4 * QuickRay<level>::passing_step;
  }
  /// False where it is not clear which.
  static bool are_apart(const End& a, const End& b) {
    if (level == Level::fast) return a.t != b.t;
    return std::fabs(a.t - b.t) > (a.radius + b.radius) * (1 + 0x1p-40);
  }
  static bool keep_later(End& end, const End& other) {
    if (!are_apart(end, other)) return false;
    if (other.t > end.t) end = other;
    return true;
  }
  static bool keep_earlier(End& end, const End& other) {
    if (!are_apart(end, other)) return false;
    if (other.t < end.t) end = other;
    return true;
  }
  static QuickSpan between(const End& enter, const End& leave) {
    if (!are_apart(enter, leave)) return {};
    return {enter.t < leave.t ? Kind::span : Kind::empty, enter, leave};
  }

  const QuickRay<level>& ray_;
  const Frame* frame_;
};

}  // namespace sightline::detail

namespace sightline {

/// Unclear of all other shapes, and where the ray or the primitive is not moderate.
template <Level level>
[[gnu::always_inline]] inline detail::QuickSpan quick_span(const Primitive& primitive, const Frame* frame,
                                                           const QuickRay<level>& ray) {
  if (!primitive.is_moderate || !ray.is_moderate()) return {};
  const detail::QuickSpans<level> spans(ray, frame);
  if (const auto* sphere = std::get_if<solid::Sphere>(&primitive.shape)) return spans(*sphere);
  if (const auto* box = std::get_if<solid::Box>(&primitive.shape)) return spans(*box);
  if (const auto* cylinder = std::get_if<solid::Cylinder>(&primitive.shape)) return spans(*cylinder);
  return {};
}

/// Whether it can be clear.
inline bool has_quick_span(const Primitive& primitive) {
  const SolidShape& shape = primitive.shape;
  return primitive.is_moderate && primitive.frame == 0 &&
         (std::holds_alternative<solid::Sphere>(shape) || std::holds_alternative<solid::Box>(shape) ||
          std::holds_alternative<solid::Cylinder>(shape));
}

}  // namespace sightline
