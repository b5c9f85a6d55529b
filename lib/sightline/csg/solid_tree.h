#pragma once
/// A solid as one writes it down: shapes, and what is done with them.

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/csg/boolean.h"
#include "sightline/csg/primitive.h"

namespace sightline {

struct SolidTree {
  enum class Kind { primitive, operation, complement };

  Kind kind = Kind::primitive;
  Operation operation = Operation::unite;
  std::vector<SolidTree> args;  ///< At least one of an operation, exactly one of a complement.
  SolidShape shape = solid::Sphere();
  Frame frame;           ///< Of a primitive.
  std::string material;  ///< Of a primitive; empty for none.

  SolidTree() = default;
  /// A shape is a solid.
  template <class S>
  requires std::is_constructible_v<SolidShape, S> SolidTree(S s) : shape(std::move(s)) {}
  SolidTree(Operation op, std::vector<SolidTree> operands)
      : kind(Kind::operation), operation(op), args(std::move(operands)) {}

  friend SolidTree operator|(SolidTree a, SolidTree b) { return joined(Operation::unite, std::move(a), std::move(b)); }
  friend SolidTree operator&(SolidTree a, SolidTree b) {
    return joined(Operation::intersect, std::move(a), std::move(b));
  }
  friend SolidTree operator-(SolidTree a, SolidTree b) {
    return joined(Operation::subtract, std::move(a), std::move(b));
  }
  friend SolidTree operator^(SolidTree a, SolidTree b) { return joined(Operation::differ, std::move(a), std::move(b)); }
  friend SolidTree operator~(SolidTree a) {
    SolidTree tree;
    tree.kind = Kind::complement;
    tree.args.push_back(std::move(a));
    return tree;
  }

 private:
  static SolidTree joined(Operation operation, SolidTree a, SolidTree b) {
    SolidTree tree(operation, {});
    tree.args.reserve(2);
    tree.args.push_back(std::move(a));
    tree.args.push_back(std::move(b));
    return tree;
  }
};

}  // namespace sightline
