#pragma once
/// How a BSP tree stores its planes and leaves.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "sightline/accel/large_pages.h"
#include "sightline/accel/probe.h"
#include "sightline/math/vec.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// A plane as a tree stores it; below is normal . x <= offset. An axis plane's x is a point of the world, so that the
/// primitives' bounds are exact; a general plane's x is relative to the tree's center, and its normal is scaled so that
/// its largest component, that of `axis`, is 1.
struct SplitPlane {
  Vec3f normal{0};
  float offset = 0;
  int axis = 0;
  bool is_general = false;

  static SplitPlane across(int axis, float offset) {
    SplitPlane split{Vec3f(0), offset, axis, false};
    split.normal[axis] = 1;
    return split;
  }

  /// None for axis planes, which bounds offer, and for what float cannot hold.
  static std::optional<SplitPlane> general(const Plane& plane, const Vec3d& center) {
    const Vec3d size = glm::abs(plane.normal);
    const int axis = largest_axis(size);
    const double scale = 1 / plane.normal[axis];
    Vec3f normal(plane.normal * scale);
    normal[axis] = 1;
    const auto offset = static_cast<float>((plane.offset - glm::dot(plane.normal, center)) * scale);
    if (!is_finite(normal) || !std::isfinite(offset)) return std::nullopt;
    if ((normal.x == 0) + (normal.y == 0) + (normal.z == 0) == 2) return std::nullopt;
    return SplitPlane{normal, offset, axis, true};
  }

  /// Relative to the center.
  Plane plane(const Vec3d& center) const {
    return {Vec3d(normal), is_general ? double(offset) : double(offset) - center[axis]};
  }
};

/// Nodes in words of eight bytes: an axis plane or a leaf takes one, a general plane two.
///   N1  The child below follows its parent; the child above is linked, by its distance in words.
class BspNodes {
 public:
  enum Kind : std::uint32_t { axis_plane = 0, general_plane = 3, leaf = 6 };  ///< Of planes: plus the axis.

  struct Word {
    std::uint32_t value;  ///< A plane's offset, a leaf's first position; of a second word one of the normal's rest.
    std::uint32_t link;   ///< Kind, and eight times the distance to the child above, or the leaf's count.

    std::uint32_t kind() const { return link & 7; }
    float offset() const { return std::bit_cast<float>(value); }
    std::uint32_t distance() const { return link >> 3; }
    LeafRange range() const { return {value, link >> 3}; }
    float first() const { return std::bit_cast<float>(value); }  ///< The normal's component after its axis, ...
    float second() const { return std::bit_cast<float>(link); }  ///< ... and the one after that.
  };
  static_assert(sizeof(Word) == 8);
  static constexpr std::size_t limit = (1u << 29) - 1;  ///< Links have 29 bits for distances and counts.

  const Word& operator[](std::size_t i) const { return words_[i]; }
  std::size_t size() const { return words_.size(); }
  std::size_t memory_bytes() const { return words_.size() * sizeof(Word) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> order() const { return order_; }

  static std::uint32_t words_of(std::uint32_t kind) { return kind >= general_plane && kind < leaf ? 2 : 1; }

  SplitPlane split(std::size_t i) const {
    const Word word = words_[i];
    if (word.kind() < general_plane) return SplitPlane::across(static_cast<int>(word.kind()), word.offset());
    const auto axis = static_cast<int>(word.kind() - general_plane);
    SplitPlane split{Vec3f(0), word.offset(), axis, true};
    split.normal[axis] = 1;
    split.normal[(axis + 1) % 3] = words_[i + 1].first();
    split.normal[(axis + 2) % 3] = words_[i + 1].second();
    return split;
  }

  template <class See>
  void for_each_leaf(See&& see) const {
    for (std::size_t i = 0; i < words_.size(); i += words_of(words_[i].kind())) {
      if (words_[i].kind() == leaf) see(words_[i].range());
    }
  }

  /// Returns the node's number, which `link_above` takes once the child below is complete.
  std::size_t add_plane(const SplitPlane& split) {
    const std::size_t node = words_.size();
    const auto axis = static_cast<std::uint32_t>(split.axis);
    add({std::bit_cast<std::uint32_t>(split.offset), (split.is_general ? general_plane : axis_plane) + axis});
    if (split.is_general) {
      add({std::bit_cast<std::uint32_t>(split.normal[(split.axis + 1) % 3]),
           std::bit_cast<std::uint32_t>(split.normal[(split.axis + 2) % 3])});
    }
    return node;
  }
  void link_above(std::size_t node) { words_[node].link |= static_cast<std::uint32_t>(words_.size() - node) << 3; }

  /// A leaf of count candidates, id_of(0) and so on.
  template <class IdOf>
  void add_leaf(std::uint32_t count, IdOf&& id_of) {
    add({static_cast<std::uint32_t>(order_.size()), count << 3 | leaf});
    for (std::uint32_t i = 0; i < count; ++i) order_.push_back(id_of(i));
  }

  /// Another tree after this one's end.
  void append(const BspNodes& subtree) {
    const auto shift = static_cast<std::uint32_t>(order_.size());
    const std::size_t start = words_.size();
    for (const Word& word : subtree.words_) add(word);
    for (std::size_t i = start; i < words_.size(); i += words_of(words_[i].kind())) {
      if (words_[i].kind() == leaf) words_[i].value += shift;
    }
    order_.insert(order_.end(), subtree.order_.begin(), subtree.order_.end());
  }

  void shrink_to_fit() {
    words_.shrink_to_fit();
    order_.shrink_to_fit();
  }

 private:
  void add(const Word& word) {
    if (words_.size() == limit) throw std::length_error("bsp-tree: more nodes than a link can span");
    words_.push_back(word);
  }

  LargeVector<Word> words_;
  std::vector<std::uint32_t> order_;
};

}  // namespace sightline
