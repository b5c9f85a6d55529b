#pragma once
/// A solid made ready for rays.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sightline/accel/options.h"
#include "sightline/csg/convex_lanes.h"
#include "sightline/csg/operand_index.h"
#include "sightline/csg/solid_tree.h"
#include "sightline/csg/span_list.h"
#include "sightline/math/aabb.h"

namespace sightline {

/// What is spared where it cannot matter. None changes a result; each is a row of the benchmark.
struct SolidOptions {
  bool use_bounds = true;
  bool skip_empty = true;
  bool prune_disjoint = true;
  bool absorb_complements = true;
  bool index_operands = true;
  bool stop_early = true;
  bool walk_convex = true;
  int index_from = 8;

  static constexpr std::array<OptionField<SolidOptions>, 8> fields() {
    return {{
        {"use_bounds", &SolidOptions::use_bounds, 0, 1, "leave out subtrees whose box the ray misses"},
        {"skip_empty", &SolidOptions::skip_empty, 0, 1,
         "leave out what can only narrow nothing: once an intersection or a difference is empty, it stays so"},
        {"prune_disjoint", &SolidOptions::prune_disjoint, 0, 1,
         "when built, drop what is subtracted from nothing, and parts that do not overlap"},
        {"absorb_complements", &SolidOptions::absorb_complements, 0, 1,
         "when built, push complements down and make differences of them, which have bounds"},
        {"index_operands", &SolidOptions::index_operands, 0, 1, "find the operands of large unions by an accelerator"},
        {"stop_early", &SolidOptions::stop_early, 0, 1,
         "go from front to back and stop at the first boundary asked for"},
        {"walk_convex", &SolidOptions::walk_convex, 0, 1,
         "find the first boundary of convex parts less convex parts without lists, where all is clear"},
        {"index_from", &SolidOptions::index_from, 2, 1 << 20, "a union of this many operands has an accelerator"},
    }};
  }
};

/// Part of a solid: a primitive, or an operation on the nodes listed as its children.
///   N1  Children come before their parents.
struct SolidNode {
  bool is_primitive = true;
  Operation operation = Operation::unite;  ///< A subtraction takes all children but the first from the first.
  bool is_complement = false;              ///< Of what the rest says.
  bool is_bounded = false;
  bool is_tested = false;  ///< Rays are tested with the bounds: it is bounded, and more narrowly than its parents.
  Aabb bounds;             ///< Holds the node, where that is bounded.
  std::uint32_t primitive = 0;
  std::uint32_t first_child = 0, child_count = 0;
  std::uint32_t index = no_index;  ///< Of the accelerator that finds the children, but for a subtraction's first.

  static constexpr std::uint32_t no_index = 0xffff'ffff;
};

/// What a solid is: what the first ones, of which there is at least one, have in common, less all others. All are
/// primitives with quick_span.
struct ConvexParts {
  struct Taken {
    std::uint32_t primitive;
    Aabb bounds;
  };

  std::vector<std::uint32_t> kept;
  std::vector<Taken> taken;
  std::shared_ptr<const OperandIndex> index;  ///< Of `taken`, by place there; or null.
  std::shared_ptr<const ConvexLanes> lanes;   ///< Of all; or null, as it is where there is an index.
};

/// What a walk along convex parts comes to. An unclear one leaves the ray to the evaluation by lists.
enum class WalkOutcome { unclear, none, found };

/// Immutable, and safe to ask from many threads.
class Solid {
 public:
  /// `accelerator` is the registry's name of the structure for operands, see SolidOptions::index_operands.
  /// \throws std::invalid_argument for a shape without sense (a negative radius, a box whose lo is above its hi, NaN),
  /// an operation without operands, a frame that cannot be inverted, an unknown accelerator or bad options.
  explicit Solid(const SolidTree& tree, const SolidOptions& options = {}, std::string_view accelerator = "box-tree");

  const SolidOptions& options() const { return options_; }
  std::span<const Primitive> primitives() const { return primitives_; }
  /// nullptr for a primitive that stands in the world.
  const Frame* frame_of(const Primitive& primitive) const {
    return primitive.frame == 0 ? nullptr : &frames_[primitive.frame];
  }
  std::span<const std::string> materials() const { return materials_; }

  std::span<const SolidNode> nodes() const { return nodes_; }
  const SolidNode& root() const { return nodes_.back(); }
  std::span<const std::uint32_t> children(const SolidNode& node) const {
    return std::span(children_).subspan(node.first_child, node.child_count);
  }
  const OperandIndex* index_of(const SolidNode& node) const {
    return node.index == SolidNode::no_index ? nullptr : indices_[node.index].get();
  }

  /// nullptr where the solid is not so simple, or is not to be asked so.
  const ConvexParts* convex_parts() const { return convex_parts_.kept.empty() ? nullptr : &convex_parts_; }

  bool is_bounded() const { return root().is_bounded; }
  /// Of the solid where it is bounded; see `extent` otherwise.
  const Aabb& bounds() const { return root().bounds; }
  /// Holds all bounded nodes.
  const Aabb& extent() const { return extent_; }

  /// The outward normal of the solid, of unit length, where a ray passes a boundary. Where the surface has none, as at
  /// a cone's apex or a crease, it is against the ray, or with it where the ray leaves.
  Vec3d normal(const Boundary& boundary, const Ray<double>& ray) const;

 private:
  class Builder;

  SolidOptions options_;
  std::vector<Primitive> primitives_;
  std::vector<Frame> frames_{Frame()};
  std::vector<std::string> materials_{""};
  std::vector<SolidNode> nodes_;
  std::vector<std::uint32_t> children_;
  std::vector<std::shared_ptr<const OperandIndex>> indices_;
  ConvexParts convex_parts_;
  Aabb extent_;
};

}  // namespace sightline
