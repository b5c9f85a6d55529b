#pragma once
/// The contract that every structure keeps.
///
/// An accelerator only enumerates candidates, front to back as far as its regions allow. It never intersects a
/// primitive: closest and any hit, counting and drawing are written once, in query/, over the one `traverse`.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "sightline/accel/options.h"
#include "sightline/accel/primitives.h"
#include "sightline/accel/probe.h"
#include "sightline/math/ray.h"

namespace sightline {

/// Told of a leaf's candidates, a visitor returns the ray's new far limit; -infinity stops the traversal.
template <class V, class T>
concept LeafVisitor = requires(V visit, LeafRange leaf) {
  { visit(leaf) } -> std::same_as<T>;
};

/// Whether a visitor says that the order of leaves does not matter to it, as when any hit will do: then a structure may
/// take the order that costs it least.
template <class V>
inline constexpr bool takes_any_order = requires {
  requires std::remove_cvref_t<V>::takes_any_order;
};

/// Has what a visitor reads of a leaf brought near, where it knows how.
template <class V>
void fetch_leaf(const V& visit, LeafRange leaf) {
  if constexpr (requires { visit.fetch(leaf); }) visit.fetch(leaf);
}

/// One region of a structure, for drawing and for the laws that test coverage.
struct Cell {
  std::variant<Aabb, Sphere, Cylinder, Polyhedron> region;
  int depth = 0;
  bool is_leaf = false;
  LeafRange range;         ///< Candidates of a leaf; empty for inner nodes.
  std::uint32_t node = 0;  ///< The number by which probes name it.
};

namespace detail {
template <class T>
struct AnyLeafVisitor {
  T operator()(LeafRange) const;
};
struct AnyCellVisitor {
  void operator()(const Cell&) const;
};
}  // namespace detail

template <class A>
concept Accelerator = std::movable<A> &&
    requires(const A& a, const Primitives& primitives, const typename A::Options& options, const Ray<float>& ray,
             const Ray<double>& wide_ray, NoProbe& probe) {
  { A::name } -> std::convertible_to<std::string_view>;
  { A::description } -> std::convertible_to<std::string_view>;  // one line: how it divides, and its paper
  {A::Options::fields()};                                       // see options.h
  { A::build(primitives, options) } -> std::same_as<A>;         // std::invalid_argument for bad options
  { a.memory_bytes() } -> std::same_as<std::size_t>;            // nodes and leaf order
  { a.node_bytes } -> std::convertible_to<std::size_t>;         // of one node
  // The primitive at each leaf position; a primitive held by several leaves stands at several positions.
  { a.leaf_order() } -> std::same_as<std::span<const std::uint32_t>>;
  // False while queries may still rearrange leaf_order (lazy building).
  { a.is_order_final() } -> std::same_as<bool>;
  // A ray that is not valid (ray.h) meets nothing.
  a.traverse(ray, detail::AnyLeafVisitor<float>{}, probe);
  a.traverse(wide_ray, detail::AnyLeafVisitor<double>{}, probe);
  a.for_each_cell(detail::AnyCellVisitor{});
};

/// Calls see(range) for every leaf; a structure whose cells take long to make has a member for that.
template <Accelerator A, class See>
void for_each_leaf(const A& accel, See&& see) {
  if constexpr (requires { accel.for_each_leaf(see); }) {
    accel.for_each_leaf(see);
  } else {
    accel.for_each_cell([&](const Cell& cell) {
      if (cell.is_leaf) see(cell.range);
    });
  }
}

/// Structures that can follow primitives which move: refit(tree, primitives) bounds them anew where `build` has put
/// them. Hits are those of any other structure; rays take the longer the more has moved. As many primitives as the tree
/// was built of. can_refit() is false of a tree that is not all there yet.
template <class A>
concept Refittable = Accelerator<A> && requires(A& tree, const A& built, const Primitives& primitives) {
  { A::refit(std::move(tree), primitives) } -> std::same_as<A>;
  { built.can_refit() } -> std::same_as<bool>;
};

/// Around the primitives at these places of the leaf order.
inline Aabb bounds_of(const Primitives& primitives, std::span<const std::uint32_t> order, LeafRange leaf) {
  Aabb box;
  for (const std::uint32_t id : order.subspan(leaf.first, leaf.count)) box.extend(primitives.bounds(id));
  return box;
}

}  // namespace sightline
