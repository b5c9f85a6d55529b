#pragma once
/// Fires a ray at a solid: lists where it enters and leaves each operand, in order of t, keeps the transitions of the
/// boolean state machine, and passes the list up.

#include <algorithm>
#include <limits>
#include <optional>

#include "sightline/csg/first_walk.h"
#include "sightline/csg/primitive_spans.h"
#include "sightline/csg/solid.h"

namespace sightline {

/// Evaluates one solid for one ray. Refers to both.
///   V1  A list is right within the window that it was asked for, ends included; beyond it anything may be missing.
///   V2  What is left out cannot have a boundary, nor be inside, within the window: its box, which is rounded outward,
///       is missed by a padded ray.
///   V3  On the way, t need only be known well enough to put boundaries in order; those reported are as accurate as the
///       level asks for.
///   V4  The first boundary is that of the list in every field: limits are compared with what is reported, and what is
///       nearer to them than that may be off is not left out.
template <Level level, class Probe = NoSolidProbe>
class SolidEvaluator {
 public:
  using Window = Interval<double>;

  SolidEvaluator(const Solid& solid, const Ray<double>& ray, Probe& probe)
      : solid_(solid),
        own_ray_(SolidRay<level>(ray, solid.extent())),
        ray_(*own_ray_),
        order_(solid, ray),
        probe_(probe) {}
  /// The ray is ready for all that the solid extends to.
  SolidEvaluator(const Solid& solid, const SolidRay<level>& ray, Probe& probe)
      : solid_(solid), ray_(ray), order_(solid, ray.ray()), probe_(probe) {}

  /// The solid's spans within the window; all of them without one. A ray that is not valid has none.
  SpanList spans(Window window = {-infinity, infinity}) {
    stack_.truncate(0);
    if (!ray_.is_valid()) return nothing();
    const SpanList list = evaluate(last_node(), window);
    refine(list);
    return list;
  }
  std::span<const Boundary> operator[](const SpanList& list) const { return stack_[list]; }

  /// The first boundary with t_min < t <= t_max.
  std::optional<Boundary> first(double t_min, double t_max) {
    Boundary boundary;
    switch (walk_first(solid_, ray_, t_min, t_max, probe_, boundary)) {
      case WalkOutcome::found:
        return boundary;
      case WalkOutcome::none:
        return std::nullopt;
      case WalkOutcome::unclear:
        break;
    }
    return first_by_lists(t_min, t_max);
  }

  /// The same without a walk along convex parts.
  std::optional<Boundary> first_by_lists(double t_min, double t_max) {
    stack_.truncate(0);
    if (!ray_.is_valid()) return std::nullopt;
    limits_ = {t_min, t_max};
    const Window window{t_min - limit_slack<level>(t_min), t_max + limit_slack<level>(t_max)};
    return solid_.options().stop_early ? first_of(last_node(), window) : first_in(evaluate(last_node(), window));
  }

 private:
  using Real = typename SolidRay<level>::Real;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::uint32_t last_node() const { return static_cast<std::uint32_t>(solid_.nodes().size()) - 1; }
  SpanList nothing() const { return {stack_.size(), 0, false}; }

  /// V2
  bool is_met(const SolidNode& node, const Window& window) const {
    if (!node.is_tested || !solid_.options().use_bounds) return true;
    if (node.bounds.is_empty()) return false;
    const Interval<Real> range = ray_.padded().clip(node.bounds, std::numeric_limits<Real>::infinity());
    return !(range.lo > above(window.hi)) && !(range.hi < below(window.lo)) && !(range.lo > range.hi);
  }
  static Real above(double t) {
    if constexpr (level == Level::fast) return round_up(t);
    return t;
  }
  static Real below(double t) {
    if constexpr (level == Level::fast) return round_down(t);
    return t;
  }

  SpanList evaluate(std::uint32_t index, const Window& window) {
    const SolidNode& node = solid_.nodes()[index];
    SpanList list = nothing();
    if (is_met(node, window)) {
      probe_.node(index);
      list = node.is_primitive ? primitive(node) : operation(index, node, window);
    } else {
      probe_.pruned(index);
    }
    return finished(index, node, list);
  }

  SpanList finished(std::uint32_t index, const SolidNode& node, SpanList list) {
    if (node.is_complement) {
      list.begins_inside = !list.begins_inside;
      for (Boundary& boundary : stack_.part(list)) boundary.is_flipped = !boundary.is_flipped;
    }
    probe_.spans(index, stack_[list], list.begins_inside);
    return list;
  }

  SpanList primitive(const SolidNode& node) {
    probe_.primitive(node.primitive);
    const SpanList list = primitive_spans<level>(solid_, node.primitive, ray_.quick(), order_, stack_);
    if constexpr (Probe::sees_transitions) refine(list);
    return list;
  }

  SpanList operation(std::uint32_t index, const SolidNode& node, const Window& window) {
    const auto children = solid_.children(node);
    const bool has_first = node.operation != Operation::unite && node.operation != Operation::differ;
    if (!has_first) return folded(index, node, children, window);
    SpanList list = evaluate(children[0], window);
    if (node.operation == Operation::subtract) return subtracted(index, node, list, window);
    for (std::size_t i = 1; i < children.size() && !(list.is_empty() && solid_.options().skip_empty); ++i) {
      list = combined(index, node.operation, list, evaluate(children[i], narrowed(list, window)));
    }
    return list;
  }

  /// All children but the first from `list`, which is the first's and on top of the stack.
  SpanList subtracted(std::uint32_t index, const SolidNode& node, const SpanList& list, const Window& window) {
    if (list.is_empty() && solid_.options().skip_empty) return list;
    const SpanList rest = folded(index, node, solid_.children(node).subspan(1), narrowed(list, window));
    return combined(index, Operation::subtract, list, rest);
  }

  /// The part of a window in which a list has anything.
  Window narrowed(const SpanList& list, const Window& window) const {
    if (!solid_.options().skip_empty || list.begins_inside) return window;
    const auto boundaries = stack_[list];
    if (boundaries.empty()) return window;
    const Boundary &first = boundaries.front(), &last = boundaries.back();
    return {std::max(window.lo, first.t - first.radius),
            list.count % 2 == 0 ? std::min(window.hi, last.t + last.radius) : window.hi};
  }

  /// The union, or symmetric difference, of children; of a subtraction the union of what is subtracted.
  SpanList folded(std::uint32_t index, const SolidNode& node, std::span<const std::uint32_t> children,
                  const Window& window) {
    const Operation operation = node.operation == Operation::differ ? Operation::differ : Operation::unite;
    const OperandIndex* operands = solid_.index_of(node);
    if (!operands || !solid_.options().index_operands) {
      return folded(index, operation, 0, children.size(), window, [&](std::size_t i) { return children[i]; });
    }
    const std::uint32_t begin = found_.size();
    Ray<double> part = ray_.ray();
    part.t_min = window.lo, part.t_max = window.hi;
    operands->find(part, found_);
    std::sort(found_.begin() + begin, found_.end());
    found_.truncate(static_cast<std::uint32_t>(std::unique(found_.begin() + begin, found_.end()) - found_.begin()));
    const SpanList list = folded(index, operation, begin, found_.size(), window,
                                 [&](std::size_t i) { return children[found_[static_cast<std::uint32_t>(i)]]; });
    found_.truncate(begin);
    return list;
  }

  /// By halves, so that a boundary passes through as many merges as the logarithm of the number of operands.
  template <class Child>
  SpanList folded(std::uint32_t index, Operation operation, std::size_t begin, std::size_t end, const Window& window,
                  const Child& child) {
    if (begin == end) return nothing();
    if (end - begin == 1) return evaluate(child(begin), window);
    const std::size_t middle = begin + (end - begin) / 2;
    const SpanList a = folded(index, operation, begin, middle, window, child);
    const SpanList b = folded(index, operation, middle, end, window, child);
    return combined(index, operation, a, b);
  }

  /// Merges two lists, b behind a on top of the stack, into the list of the result in their place.
  SpanList combined(std::uint32_t index, Operation operation, const SpanList& a, const SpanList& b) {
    if (!Probe::sees_transitions && a.is_empty() && (operation == Operation::unite || operation == Operation::differ)) {
      return b;
    }
    SpanList list{a.first, 0, is_inside(operation, a.begins_inside, b.begins_inside)};
    if (!Probe::sees_transitions && b.is_empty() && operation != Operation::intersect) {
      list.count = a.count;
      return list;
    }
    merge(index, operation, a, b, [&](const Boundary& boundary) {
      stack_.push(boundary);
      return true;
    });
    stack_.erase(a.first, b.first + b.count);
    list.count = stack_.size() - a.first;
    return list;
  }

  /// Calls take(boundary) for the boundaries of the result of two lists, in order, until it returns false.
  template <class Take>
  [[gnu::always_inline]] void merge(std::uint32_t index, Operation operation, const SpanList& a, const SpanList& b,
                                    Take&& take) {
    const std::uint32_t end_a = a.first + a.count, end_b = b.first + b.count;
    bool is_in_a = a.begins_inside, is_in_b = b.begins_inside;
    for (std::uint32_t i = a.first, j = b.first; i < end_a || j < end_b;) {
      const int order = i == end_a ? 1 : j == end_b ? -1 : order_(stack_[i], stack_[j]);
      const Transition step{is_in_a, is_in_a != (order <= 0), is_in_b, is_in_b != (order >= 0)};
      is_in_a = step.is_in_a, is_in_b = step.is_in_b;
      const bool takes_a = order < 0 || (order == 0 && stack_[i].primitive <= stack_[j].primitive);
      const std::uint32_t from = takes_a ? i : j;
      const bool kept = is_kept(operation, step);
      probe_.transition(index, step, kept, stack_[from].t);
      i += order <= 0, j += order >= 0;
      if (!kept) continue;
      Boundary boundary = stack_[from];
      boundary.is_flipped ^= flips_normal(operation, step, takes_a);
      if (!take(boundary)) return;
    }
  }

  // ---- What is reported (V3)

  void refine(const SpanList& list) {
    for (Boundary& boundary : stack_.part(list)) boundary = refined(boundary);
  }
  Boundary refined(const Boundary& boundary) const { return refined_boundary(solid_, boundary, ray_.quick()); }
  bool is_behind(const Boundary& boundary, double t) const {
    return sightline::is_behind(solid_, boundary, t, ray_.quick());
  }

  // ---- The first boundary

  std::optional<Boundary> within_limits(const Boundary& boundary) const {
    return is_behind(boundary, limits_.hi) ? std::nullopt : std::optional(refined(boundary));
  }

  /// The first one behind the lower limit.
  const Boundary* next_in(const SpanList& list) const {
    for (const Boundary& boundary : stack_[list]) {
      if (is_behind(boundary, limits_.lo)) return &boundary;
    }
    return nullptr;
  }
  std::optional<Boundary> first_in(const SpanList& list) const {
    const Boundary* const next = next_in(list);
    return next ? within_limits(*next) : std::nullopt;
  }

  /// Whether the ray is inside just behind the lower limit, or may be.
  bool may_begin_within(const SpanList& list) const {
    const double near = limit_slack<level>(limits_.lo);
    bool is_inside = list.begins_inside;
    for (const Boundary& boundary : stack_[list]) {
      if (boundary.t - boundary.radius > limits_.lo + near) break;
      if (boundary.t + boundary.radius >= limits_.lo - near) return true;
      is_inside = !is_inside;
    }
    return is_inside;
  }

  std::optional<Boundary> first_of(std::uint32_t index, const Window& window) {
    const SolidNode& node = solid_.nodes()[index];
    if (!is_met(node, window)) {
      probe_.pruned(index);
      return std::nullopt;  // nor has a complement a boundary here
    }
    const bool is_plain = !node.is_primitive && !node.is_complement;
    if (is_plain && node.operation == Operation::unite && !solid_.index_of(node)) return first_of_union(index, window);
    if (is_plain && node.operation == Operation::subtract) return first_of_difference(index, window);
    return first_in(evaluate(index, window));
  }

  /// From outside of all operands, the nearest of their first boundaries; from inside of one, by the whole list.
  std::optional<Boundary> first_of_union(std::uint32_t index, Window window) {
    const Window whole = window;
    std::optional<Boundary> nearest;
    probe_.node(index);
    for (const std::uint32_t child : solid_.children(solid_.nodes()[index])) {
      const std::uint32_t size = stack_.size();
      const SpanList list = evaluate(child, window);
      if (may_begin_within(list)) {
        stack_.truncate(size);
        return first_in(evaluate(index, whole));
      }
      // What lies beyond the window may be no boundary, but is behind any that is.
      if (const Boundary* const next = next_in(list)) {
        const int order = nearest ? order_(*next, *nearest) : -1;
        if (order < 0 || (order == 0 && next->primitive < nearest->primitive)) nearest = *next;
        window.hi = std::min(window.hi, nearest->t + nearest->radius);
      }
      stack_.truncate(size);
    }
    return nearest ? within_limits(*nearest) : std::nullopt;
  }

  /// The spans of the minuend one after the other, each alone less what is subtracted.
  std::optional<Boundary> first_of_difference(std::uint32_t index, const Window& window) {
    const SolidNode& node = solid_.nodes()[index];
    probe_.node(index);
    const SpanList minuend = evaluate(solid_.children(node)[0], window);
    const std::uint32_t size = stack_.size();
    bool is_inside = minuend.begins_inside;
    for (std::uint32_t i = 0; i <= minuend.count; ++i, is_inside = !is_inside) {
      if (!is_inside) continue;
      // From the boundary before i to the one at i, either of which may be missing.
      const std::uint32_t begin = i == 0 ? 0 : i - 1, end = std::min<std::uint32_t>(i + 1, minuend.count);
      const SpanList span{minuend.first + begin, end - begin, i == 0};
      const Window own{i == 0 ? -infinity : stack_[span.first].t - stack_[span.first].radius,
                       i == minuend.count ? infinity : stack_[minuend.first + i].t + stack_[minuend.first + i].radius};
      if (own.lo > window.hi) break;
      if (own.hi < window.lo) continue;
      const Window both =
          solid_.options().skip_empty ? Window{std::max(own.lo, window.lo), std::min(own.hi, window.hi)} : window;
      const SpanList rest = folded(index, node, solid_.children(node).subspan(1), both);
      std::optional<Boundary> next;
      merge(index, Operation::subtract, span, rest, [&](const Boundary& boundary) {
        if (is_behind(boundary, limits_.lo)) next = boundary;
        return !next;
      });
      if (next) return within_limits(*next);
      stack_.truncate(size);
    }
    return std::nullopt;
  }

  const Solid& solid_;
  const std::optional<SolidRay<level>> own_ray_;
  const SolidRay<level>& ray_;
  BoundaryOrder<level> order_;
  Probe& probe_;
  Window limits_{};  ///< As given to first().
  SpanStack stack_;
  OperandList found_;
};

}  // namespace sightline
