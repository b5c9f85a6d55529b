#pragma once
/// Where a ray is inside the commonest primitives, where that is clear at once.

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
    End enter, leave;
    pass(box, 0, enter, leave);
    for (int axis = 1; axis < 3; ++axis) {
      End next_enter, next_leave;
      pass(box, axis, next_enter, next_leave);
      if (!keep_later(enter, next_enter) || !keep_earlier(leave, next_leave)) return {};
    }
    return between(enter, leave);
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

  void pass(const solid::Box& box, int axis, End& enter, End& leave) const {
    const bool goes_up = ray_.ray().direction[axis] > 0;
    const double in = ray_.passing(axis, goes_up ? box.lo[axis] : box.hi[axis]);
    const double out = ray_.passing(axis, goes_up ? box.hi[axis] : box.lo[axis]);
    const auto face = static_cast<std::uint32_t>(2 * axis);
    enter = {in, ray_.radius_of(in), face + !goes_up, 0};
    leave = {out, ray_.radius_of(out), face + goes_up, 0};
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
  return primitive.is_moderate && primitive.frame == 0 && primitive.shape.index() >= 1 && primitive.shape.index() <= 3;
}

}  // namespace sightline
