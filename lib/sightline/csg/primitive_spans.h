#pragma once
/// Where a ray is inside a primitive.

#include <cmath>
#include <utility>
#include <variant>

#include "sightline/csg/boundary_order.h"
#include "sightline/csg/quick_spans.h"

namespace sightline {

namespace detail {

/// Collects the spans of one primitive on top of a stack, face by face: the solid is where all faces are negative (F1).
template <Level level>
class PrimitiveSpans {
 public:
  PrimitiveSpans(const Solid& solid, std::uint32_t id, const QuickRay<level>& ray, const BoundaryOrder<level>& order,
                 SpanStack& stack)
      : primitive_(solid.primitives()[id]),
        id_(id),
        ray_(ray),
        frame_(solid.frame_of(primitive_)),
        order_(order),
        stack_(stack) {}

  [[gnu::noinline]] SpanList run() {
    const std::uint32_t first = stack_.size();
    const bool begins = std::visit(*this, primitive_.shape);
    return {first, stack_.size() - first, begins};
  }

  // Each pushes the boundaries and returns whether the line begins inside.

  bool operator()(const solid::HalfSpace& half) {
    return std::visit([&](const auto& plane) { return push(0, roots(plane)); }, plane_of(half));
  }
  bool operator()(const solid::Sphere& sphere) { return push(0, roots(sphere)); }
  bool operator()(const solid::Quadric& quadric) { return push(0, roots(quadric)); }
  bool operator()(const solid::Torus& torus) { return push(0, roots(torus)); }

  bool operator()(const solid::Box& box) {
    Convex span;
    for (std::uint32_t face = 0; face < 6 && !span.is_empty; ++face) {
      narrow(span, face, roots(solid::face_of(box, face)));
    }
    return push(span);
  }

  bool operator()(const solid::Cylinder& cylinder) {
    Convex span;
    narrow(span, 0, roots(cylinder));
    if (!span.is_empty) narrow_by_caps(span, cylinder);
    return push(span);
  }

  /// The line may be in both nappes; between the planes through apex and base there is one, and one span.
  bool operator()(const solid::Cone& cone) {
    Convex slab;
    narrow_by_caps(slab, cone);
    if (slab.is_empty) return false;
    const RootList list = roots(cone);
    if (list.count < 2 || !list.begins_negative) {
      narrow(slab, 0, list);
      return push(slab);
    }
    // Inside before the first root and after the second one, in either nappe; the slab has but one of them.
    Convex after = slab;
    raise(after, boundary(0, list, 1));
    lower(slab, boundary(0, list, 0));
    return push(after.is_empty ? slab : after);
  }

  bool operator()(const std::shared_ptr<const ClosedMesh>& mesh) {
    const std::uint32_t first = stack_.size();
    mesh->passages(FramedRay(ray_.ray(), frame_),
                   [&](std::uint32_t face, bool) { push(face, roots(mesh->facet(face))); });
    sort(first);
    cancel(first);
    return false;
  }

 private:
  /// One span, either end of which may be infinite.
  struct Convex {
    Boundary enter, leave;
    bool has_enter = false, has_leave = false;
    bool is_empty = false;
  };

  template <class S>
  RootList roots(const S& surface) const {
    return quick_roots<level>(surface, ray_, frame_, primitive_.is_moderate);
  }

  Boundary boundary(std::uint32_t face, const RootList& list, int i) const {
    const Root& root = list.roots[static_cast<std::size_t>(i)];
    return {root.t, root.radius, id_, face, static_cast<std::uint32_t>(i)};
  }

  /// Roots of even multiplicity only touch. Rounded ones may be equal.
  bool push(std::uint32_t face, const RootList& list) {
    const std::uint32_t first = stack_.size();
    for (int i = 0; i < list.count; ++i) {
      if (list.roots[static_cast<std::size_t>(i)].multiplicity % 2 != 0) stack_.push(boundary(face, list, i));
    }
    if constexpr (level == Level::fast) cancel(first);
    return list.begins_negative;
  }

  bool push(const Convex& span) {
    if (span.is_empty) return false;
    if (span.has_enter) stack_.push(span.enter);
    if (span.has_leave) stack_.push(span.leave);
    return !span.has_enter;
  }

  void raise(Convex& span, const Boundary& enter) const {
    if (span.is_empty) return;
    if (!span.has_enter || order_(enter, span.enter) > 0) span.enter = enter;
    span.has_enter = true;
    span.is_empty = span.has_leave && order_(span.enter, span.leave) >= 0;
  }
  void lower(Convex& span, const Boundary& leave) const {
    if (span.is_empty) return;
    if (!span.has_leave || order_(leave, span.leave) < 0) span.leave = leave;
    span.has_leave = true;
    span.is_empty = span.has_enter && order_(span.enter, span.leave) >= 0;
  }

  /// By a face whose inside is one span, or empty, or all, along any line.
  void narrow(Convex& span, std::uint32_t face, const RootList& list) const {
    if (list.count == 0) {
      span.is_empty = !list.begins_negative;
    } else if (list.count == 1 && list.roots[0].multiplicity % 2 == 0) {
      span.is_empty = !list.begins_negative;
    } else if (list.count == 1) {
      list.begins_negative ? lower(span, boundary(face, list, 0)) : raise(span, boundary(face, list, 0));
    } else {
      raise(span, boundary(face, list, 0));
      lower(span, boundary(face, list, 1));
    }
  }

  template <class Shape>
  void narrow_by_caps(Convex& span, const Shape& shape) const {
    for (std::uint32_t face = 1; face <= 2 && !span.is_empty; ++face) {
      std::visit([&](const auto& plane) { narrow(span, face, roots(plane)); }, plane_of(cap_of(shape, face == 2)));
    }
  }

  void sort(std::uint32_t first) {
    for (std::uint32_t i = first + 1; i < stack_.size(); ++i) {
      for (std::uint32_t j = i; j > first && order_(stack_[j], stack_[j - 1]) < 0; --j) {
        std::swap(stack_[j], stack_[j - 1]);
      }
    }
  }

  /// Boundaries at one place cancel in pairs (L1).
  void cancel(std::uint32_t first) {
    std::uint32_t kept = first;
    for (std::uint32_t i = first; i < stack_.size(); ++i) {
      if (kept > first && order_(stack_[kept - 1], stack_[i]) == 0) {
        --kept;
      } else {
        stack_[kept++] = stack_[i];
      }
    }
    stack_.truncate(kept);
  }

  const Primitive& primitive_;
  std::uint32_t id_;
  const QuickRay<level>& ray_;
  const Frame* frame_;
  const BoundaryOrder<level>& order_;
  SpanStack& stack_;
};

}  // namespace detail

/// The spans of a solid's primitive along the whole line of a ray, on top of the stack.
template <Level level>
[[gnu::always_inline]] inline SpanList primitive_spans(const Solid& solid, std::uint32_t id, const QuickRay<level>& ray,
                                                       const BoundaryOrder<level>& order, SpanStack& stack) {
  const Primitive& primitive = solid.primitives()[id];
  const detail::QuickSpan quick = quick_span(primitive, solid.frame_of(primitive), ray);
  SpanList list{stack.size(), 0, false};
  if (quick.kind == detail::QuickSpan::Kind::empty) return list;
  if (quick.kind == detail::QuickSpan::Kind::span) [[likely]] {
    stack.push({quick.enter.t, quick.enter.radius, id, quick.enter.face, quick.enter.root});
    stack.push({quick.leave.t, quick.leave.radius, id, quick.leave.face, quick.leave.root});
    list.count = 2;
    return list;
  }
  return detail::PrimitiveSpans<level>(solid, id, ray, order, stack).run();
}

}  // namespace sightline
