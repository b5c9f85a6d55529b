#include "sightline/csg/solid.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "sightline/csg/primitive_bounds.h"
#include "sightline/csg/quick_spans.h"
#include "sightline/csg/span_list.h"

namespace sightline {

/// Brings a tree into nodes. Where complements are absorbed, what has bounds is kept apart from complements of such:
///   X | ~Y = ~(Y - X),  X & ~Y = X - Y,  ~X & ~Y = ~(X | Y),  X - ~Y = X & Y,  X ^ ~Y = ~(X ^ Y).
class Solid::Builder {
 public:
  Builder(Solid& solid, std::string_view accelerator) : solid_(solid), accelerator_(accelerator) {}

  void build(const SolidTree& tree) {
    const Part root = part_of(tree, 0);
    place(root.node, root.is_complement);
    for (const SolidNode& node : solid_.nodes_) {
      if (node.is_bounded) solid_.extent_.extend(node.bounds);
    }
    if (solid_.options_.stop_early && solid_.options_.walk_convex) find_convex_parts();
  }

 private:
  static constexpr int max_depth = 1000;

  /// A node in the making, whose children are in the making as well.
  struct Draft {
    SolidNode node;
    std::vector<std::uint32_t> children;
  };
  /// A draft, or what is outside of it.
  struct Part {
    std::uint32_t node;
    bool is_complement;
  };

  Part part_of(const SolidTree& tree, int depth) {
    if (depth > max_depth)
      throw std::invalid_argument("expected at most 1000 operations within each other, found more");
    switch (tree.kind) {
      case SolidTree::Kind::primitive:
        return {primitive(tree), false};
      case SolidTree::Kind::complement: {
        if (tree.args.size() != 1) {
          throw std::invalid_argument("expected one operand of a complement, found " +
                                      std::to_string(tree.args.size()));
        }
        const Part part = part_of(tree.args[0], depth + 1);
        return {part.node, !part.is_complement};
      }
      case SolidTree::Kind::operation:
        break;
    }
    if (tree.args.empty()) throw std::invalid_argument("expected operands of an operation, found none");
    std::vector<Part> parts;
    for (const SolidTree& arg : tree.args) parts.push_back(part_of(arg, depth + 1));
    if (solid_.options_.absorb_complements) return absorbed(tree.operation, parts);
    std::vector<std::uint32_t> nodes;
    for (const Part& part : parts) nodes.push_back(part.is_complement ? complement(part.node) : part.node);
    return {operation(tree.operation, nodes), false};
  }

  Part absorbed(Operation op, std::vector<Part>& parts) {
    if (op == Operation::subtract) {
      for (std::size_t i = 1; i < parts.size(); ++i) parts[i].is_complement = !parts[i].is_complement;
      op = Operation::intersect;
    }
    std::vector<std::uint32_t> plain, complements, all;
    for (const Part& part : parts) {
      (part.is_complement ? complements : plain).push_back(part.node);
      all.push_back(part.node);
    }
    if (op == Operation::differ) return {operation(op, all), complements.size() % 2 != 0};
    // A union of complements is the complement of an intersection.
    const bool is_union = op == Operation::unite;
    auto& kept = is_union ? complements : plain;
    auto& taken = is_union ? plain : complements;
    if (kept.empty()) return {operation(Operation::unite, taken), !is_union};
    const std::uint32_t common = operation(Operation::intersect, kept);
    if (taken.empty()) return {common, is_union};
    taken.insert(taken.begin(), common);
    return {operation(Operation::subtract, taken), is_union};
  }

  std::uint32_t primitive(const SolidTree& tree) {
    check(tree.shape);
    check(tree.frame);
    Draft draft;
    draft.node.primitive = static_cast<std::uint32_t>(solid_.primitives_.size());
    solid_.primitives_.push_back(
        {tree.shape, number_of(tree.frame), number_of(tree.material), is_moderate(tree.shape, tree.frame)});
    if (const auto bounds = bounds_of(tree.shape, tree.frame)) {
      draft.node.is_bounded = true;
      draft.node.bounds = *bounds;
    }
    return add(std::move(draft));
  }

  std::uint32_t number_of(const Frame& frame) {
    const auto found = std::find(solid_.frames_.begin(), solid_.frames_.end(), frame);
    if (found != solid_.frames_.end()) return static_cast<std::uint32_t>(found - solid_.frames_.begin());
    solid_.frames_.push_back(frame);
    return static_cast<std::uint32_t>(solid_.frames_.size() - 1);
  }
  std::uint32_t number_of(const std::string& material) {
    const auto [at, is_new] = materials_.try_emplace(material, static_cast<std::uint32_t>(solid_.materials_.size()));
    if (is_new) solid_.materials_.push_back(material);
    return at->second;
  }

  std::uint32_t add(Draft draft) {
    drafts_.push_back(std::move(draft));
    return static_cast<std::uint32_t>(drafts_.size() - 1);
  }

  std::uint32_t complement(std::uint32_t node) {
    Draft draft = drafts_[node];
    draft.node.is_complement = !draft.node.is_complement;
    return add(std::move(draft));
  }

  /// What a node's inside is bounded by; none where it is not.
  const Aabb* box_of(std::uint32_t node) const {
    const SolidNode& n = drafts_[node].node;
    return n.is_bounded && !n.is_complement ? &n.bounds : nullptr;
  }

  std::uint32_t operation(Operation op, std::vector<std::uint32_t> children) {
    if (children.size() == 1) return children[0];
    if (solid_.options_.prune_disjoint) drop_idle(op, children);
    if (children.size() == 1) return children[0];
    Draft draft;
    draft.node.is_primitive = false;
    draft.node.operation = op;
    bound(draft.node, children);
    draft.children = std::move(children);
    return add(std::move(draft));
  }

  /// Operands that change nothing: of a subtraction what does not reach the first one, elsewhere what is empty.
  void drop_idle(Operation op, std::vector<std::uint32_t>& children) const {
    const Aabb* first = box_of(children[0]);
    if (op == Operation::intersect || (op == Operation::subtract && !first)) return;
    const auto is_idle = [&](std::uint32_t child) {
      const Aabb* box = box_of(child);
      return box && (op == Operation::subtract ? intersection(*first, *box) : *box).is_empty();
    };
    children.erase(std::remove_if(children.begin() + 1, children.end(), is_idle), children.end());
  }

  void bound(SolidNode& node, std::span<const std::uint32_t> children) const {
    if (node.operation == Operation::subtract) children = children.first(1);
    const bool is_narrowing = node.operation == Operation::intersect;
    bool is_first = true;
    node.is_bounded = !is_narrowing;
    for (const std::uint32_t child : children) {
      const Aabb* box = box_of(child);
      if (!box) {
        node.is_bounded &= is_narrowing;
        continue;
      }
      if (is_narrowing) {
        node.bounds = is_first ? *box : intersection(node.bounds, *box);
        if (node.bounds.is_empty()) node.bounds = {};
        node.is_bounded = true;
        is_first = false;
      } else {
        node.bounds.extend(*box);
      }
    }
  }

  /// Moves a draft and what it is made of into the solid, children first (N1). `tested` holds all that is asked about
  /// when it comes to this node.
  std::uint32_t place(std::uint32_t index, bool is_complement = false, const Aabb* tested = nullptr) {
    Draft& draft = drafts_[index];
    draft.node.is_complement ^= is_complement;
    draft.node.is_tested = draft.node.is_bounded && !(tested && draft.node.bounds.contains(*tested));
    if (draft.node.is_tested) tested = &draft.node.bounds;
    std::vector<std::uint32_t> children;
    for (const std::uint32_t child : draft.children) children.push_back(place(child, false, tested));
    draft.node.first_child = static_cast<std::uint32_t>(solid_.children_.size());
    draft.node.child_count = static_cast<std::uint32_t>(children.size());
    solid_.children_.insert(solid_.children_.end(), children.begin(), children.end());
    if (!draft.node.is_primitive && draft.node.operation != Operation::intersect) find_by_index(draft.node, children);
    solid_.nodes_.push_back(draft.node);
    return static_cast<std::uint32_t>(solid_.nodes_.size() - 1);
  }

  void find_by_index(SolidNode& node, std::span<const std::uint32_t> children) {
    if (node.operation == Operation::subtract) children = children.subspan(1);
    if (!solid_.options_.index_operands || children.size() < static_cast<std::size_t>(solid_.options_.index_from))
      return;
    std::vector<Aabb> boxes;
    for (const std::uint32_t child : children) {
      const SolidNode& n = solid_.nodes_[child];
      if (!n.is_bounded || n.is_complement || n.bounds.is_empty()) return;
      boxes.push_back(n.bounds);
    }
    node.index = static_cast<std::uint32_t>(solid_.indices_.size());
    solid_.indices_.push_back(make_operand_index(accelerator_, boxes));
  }

  /// Appends the primitives of a node that is one, or such an operation on primitives.
  bool list_primitives(std::uint32_t index, Operation op, std::vector<std::uint32_t>& list) const {
    const SolidNode& node = solid_.nodes_[index];
    if (node.is_complement) return false;
    if (node.is_primitive) {
      list.push_back(node.primitive);
      return has_quick_span(solid_.primitives_[node.primitive]);
    }
    if (node.operation != op) return false;
    const auto children = solid_.children(node);
    return std::all_of(children.begin(), children.end(), [&](std::uint32_t child) {
      return solid_.nodes_[child].is_primitive && list_primitives(child, op, list);
    });
  }

  void find_convex_parts() {
    const SolidNode& root = solid_.root();
    ConvexParts parts;
    std::vector<std::uint32_t> taken;
    const auto last = static_cast<std::uint32_t>(solid_.nodes_.size()) - 1;
    const SolidNode* indexed = &root;
    bool is_simple = true;
    if (!root.is_primitive && !root.is_complement && root.operation == Operation::subtract) {
      const auto children = solid_.children(root);
      is_simple = list_primitives(children[0], Operation::intersect, parts.kept);
      for (const std::uint32_t child : children.subspan(1)) {
        is_simple = is_simple && list_primitives(child, Operation::unite, taken);
        // One that is no primitive must be the only one, for the index to count as the list does.
        if (!solid_.nodes_[child].is_primitive) indexed = children.size() == 2 ? &solid_.nodes_[child] : nullptr;
      }
    } else {
      is_simple = list_primitives(last, Operation::intersect, parts.kept);
    }
    if (!is_simple) return;
    for (const std::uint32_t primitive : taken) {
      const auto node = std::find_if(solid_.nodes_.begin(), solid_.nodes_.end(),
                                     [&](const SolidNode& n) { return n.is_primitive && n.primitive == primitive; });
      parts.taken.push_back({primitive, node->bounds});
    }
    if (indexed && indexed->index != SolidNode::no_index) parts.index = solid_.indices_[indexed->index];
    if (!parts.index) parts.lanes = ConvexLanes::build(solid_.primitives_, parts.kept, taken);
    solid_.convex_parts_ = std::move(parts);
  }

  Solid& solid_;
  std::string_view accelerator_;
  std::vector<Draft> drafts_;
  std::map<std::string, std::uint32_t> materials_{{"", 0}};
};

Solid::Solid(const SolidTree& tree, const SolidOptions& options, std::string_view accelerator) : options_(options) {
  validate("solid", options);
  Builder(*this, accelerator).build(tree);
}

}  // namespace sightline
