#pragma once
/// The interval ladder of a ray through a solid: what each node of its tree makes of the lists it is passed.

#include <optional>
#include <string>
#include <vector>

#include "sightline/csg/boolean.h"
#include "sightline/csg/solid.h"
#include "sightline/math/level.h"

namespace sightline::viz {

/// A boundary of one operand, or of both where they coincide, as the operation's state machine sees it.
struct LadderStep {
  double t = 0;
  Transition change{};
  bool is_kept = false;
  Boundary boundary;  ///< The operand's; the result's where it is kept.
};

/// A node of the tree, and its part of the ray.
struct LadderRow {
  SolidTree::Kind kind = SolidTree::Kind::primitive;
  Operation operation = Operation::unite;
  bool is_fold = false;         ///< Written as part of an operation on more than two; these are folded in pairs.
  std::uint32_t primitive = 0;  ///< Of the solid.
  int depth = 0;
  int parent = -1;  ///< The row, or -1.
  char role = ' ';  ///< 'A' or 'B' of an operation.
  bool begins_inside = false;
  std::vector<Boundary> boundaries;
  std::vector<LadderStep> steps;  ///< Of an operation.

  bool is_empty() const { return boundaries.empty() && !begins_inside; }
};

struct LadderHit {
  Boundary boundary;
  Vec3d point, normal;
};

struct Ladder {
  Ray<double> ray;
  Level level = Level::watertight;
  std::vector<LadderRow> rows;   ///< Depth first, parents before their operands: the first is the solid.
  std::optional<LadderHit> hit;  ///< The first boundary of the solid with t >= 0.
};

/// A solid to draw, in two shapes: as it is written, with nothing reordered or left out but for the folding of
/// operations into pairs, and as it is traced.
class LadderSolid {
 public:
  /// \throws std::invalid_argument as Solid does.
  LadderSolid(const SolidTree& tree, std::string_view accelerator);

  /// The ray may be any that is valid; its range does not matter.
  Ladder climb(const Ray<double>& ray, Level level) const;

  /// Primitives are in the order of the ladder's rows.
  const Solid& plain() const { return plain_; }
  const Solid& quick() const { return quick_; }
  const std::string& material(std::uint32_t primitive) const {
    return plain_.materials()[plain_.primitives()[primitive].material];
  }
  /// Each primitive as a solid of its own.
  const std::vector<Solid>& parts() const { return parts_; }

 private:
  class Folder;

  std::vector<LadderRow> rows_;     ///< Without a ray.
  std::vector<std::size_t> nodes_;  ///< Of each row in plain_; a complement and its operand share one.
  Solid plain_, quick_;
  std::vector<Solid> parts_;
};

// ---- Words

/// "sphere", "cylinder".
std::string shape_name(const SolidShape& shape);
/// "side", "top", "+x".
std::string face_name(const SolidShape& shape, std::uint32_t face);
/// "difference", "complement" or the shape's name.
std::string name_of(const LadderRow& row, const Solid& solid);

}  // namespace sightline::viz
