#include "viz/csg_ladder.h"

#include <array>
#include <span>

#include "sightline/csg/evaluator.h"

namespace sightline::viz {
namespace {

constexpr SolidOptions as_written{false, false, false, false, false, false};

/// What the evaluator told of each node.
struct Recorder : NoSolidProbe {
  static constexpr bool sees_transitions = true;

  struct Node {
    std::vector<LadderStep> steps;
    std::vector<Boundary> boundaries;
    bool begins_inside = false;
  };
  std::vector<Node> nodes;

  void transition(std::uint32_t node, const Transition& change, bool is_kept, double t) {
    nodes[node].steps.push_back({t, change, is_kept, {}});
  }
  void spans(std::uint32_t node, std::span<const Boundary> boundaries, bool begins_inside) {
    nodes[node].boundaries.assign(boundaries.begin(), boundaries.end());
    nodes[node].begins_inside = begins_inside;
  }
};

template <Level level>
Recorder record(const Solid& solid, const Ray<double>& ray) {
  Recorder recorder;
  recorder.nodes.resize(solid.nodes().size());
  SolidEvaluator<level, Recorder>(solid, ray, recorder).spans();
  return recorder;
}

Recorder record(const Solid& solid, const Ray<double>& ray, Level level) {
  switch (level) {
    case Level::fast:
      return record<Level::fast>(solid, ray);
    case Level::watertight:
      return record<Level::watertight>(solid, ray);
    case Level::precise:
      return record<Level::precise>(solid, ray);
    case Level::exact:
      break;
  }
  return record<Level::exact>(solid, ray);
}

/// Each step takes the next boundary of every operand that changes; where both do, the one that the result would keep.
void find_boundaries(LadderRow& row, const LadderRow& a, const LadderRow& b) {
  std::size_t i = 0, j = 0;
  for (LadderStep& step : row.steps) {
    const Transition& change = step.change;
    const bool has_a = change.was_in_a != change.is_in_a, has_b = change.was_in_b != change.is_in_b;
    const bool takes_a = has_a && (!has_b || a.boundaries[i].primitive <= b.boundaries[j].primitive);
    step.boundary = takes_a ? a.boundaries[i] : b.boundaries[j];
    i += has_a, j += has_b;
    const bool is_in = takes_a ? change.is_in_a : change.is_in_b;
    if (step.is_kept) step.boundary.is_flipped ^= is_in != is_inside(row.operation, change);
  }
}

}  // namespace

/// Writes operations on many as operations on two, in the order in which the evaluator folds them.
class LadderSolid::Folder {
 public:
  Folder(std::vector<LadderRow>& rows, std::vector<std::size_t>& nodes) : rows_(rows), nodes_(nodes) {}

  SolidTree fold(const SolidTree& tree, int parent = -1, char role = ' ') {
    if (tree.kind == SolidTree::Kind::primitive) {
      LadderRow& row = rows_[add(tree.kind, parent, role)];
      row.primitive = primitives_++;
      nodes_.back() = next_node_++;
      return tree;
    }
    if (tree.kind == SolidTree::Kind::operation) return fold(tree.operation, tree.args, parent, role, false);
    const std::size_t row = add(tree.kind, parent, role);
    SolidTree folded = tree;
    for (SolidTree& arg : folded.args) arg = fold(SolidTree(arg), static_cast<int>(row));
    nodes_[row] = next_node_ - 1;
    return folded;
  }

 private:
  std::size_t add(SolidTree::Kind kind, int parent, char role) {
    LadderRow row;
    row.kind = kind;
    row.parent = parent;
    row.role = role;
    row.depth = parent < 0 ? 0 : rows_[static_cast<std::size_t>(parent)].depth + 1;
    rows_.push_back(std::move(row));
    nodes_.push_back(0);
    return rows_.size() - 1;
  }

  SolidTree fold(Operation operation, std::span<const SolidTree> args, int parent, char role, bool is_fold) {
    if (args.empty()) return {operation, {}};
    if (args.size() == 1) return fold(args[0], parent, role);
    const std::size_t row = add(SolidTree::Kind::operation, parent, role);
    rows_[row].operation = operation;
    rows_[row].is_fold = is_fold;
    const bool is_difference = operation == Operation::subtract, is_common = operation == Operation::intersect;
    const std::size_t cut = is_difference ? 1 : is_common ? args.size() - 1 : args.size() / 2;
    const int above = static_cast<int>(row);
    SolidTree a = fold(operation, args.first(cut), above, 'A', true);
    SolidTree b = fold(is_difference ? Operation::unite : operation, args.subspan(cut), above, 'B', true);
    nodes_[row] = next_node_++;
    std::vector<SolidTree> both;
    both.push_back(std::move(a));
    both.push_back(std::move(b));
    return {operation, std::move(both)};
  }

  std::vector<LadderRow>& rows_;
  std::vector<std::size_t>& nodes_;
  std::uint32_t primitives_ = 0;
  std::size_t next_node_ = 0;  ///< Solids number their nodes operands first.
};

LadderSolid::LadderSolid(const SolidTree& tree, std::string_view accelerator)
    : plain_(Folder(rows_, nodes_).fold(tree), as_written, accelerator), quick_(tree, {}, accelerator) {
  for (const Primitive& primitive : plain_.primitives()) {
    SolidTree part;
    part.shape = primitive.shape;
    if (const Frame* frame = plain_.frame_of(primitive)) part.frame = *frame;
    parts_.emplace_back(part);
  }
}

Ladder LadderSolid::climb(const Ray<double>& ray, Level level) const {
  Ladder ladder{ray, level, rows_, std::nullopt};
  const Recorder recorder = record(plain_, ray, level);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    LadderRow& row = ladder.rows[i];
    const LadderRow* above = row.parent < 0 ? nullptr : &ladder.rows[static_cast<std::size_t>(row.parent)];
    if (above && above->kind == SolidTree::Kind::complement) {
      row.boundaries = above->boundaries;
      for (Boundary& boundary : row.boundaries) boundary.is_flipped = !boundary.is_flipped;
      row.begins_inside = !above->begins_inside;
    } else {
      row.boundaries = recorder.nodes[nodes_[i]].boundaries;
      row.begins_inside = recorder.nodes[nodes_[i]].begins_inside;
    }
    if (row.kind == SolidTree::Kind::operation) row.steps = recorder.nodes[nodes_[i]].steps;
  }
  std::vector<std::array<const LadderRow*, 2>> operands(rows_.size());
  for (const LadderRow& row : ladder.rows) {
    if (row.parent >= 0 && row.role != ' ') operands[static_cast<std::size_t>(row.parent)][row.role == 'B'] = &row;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (operands[i][1]) find_boundaries(ladder.rows[i], *operands[i][0], *operands[i][1]);
  }
  for (const Boundary& boundary : ladder.rows.front().boundaries) {
    if (!(boundary.t >= 0)) continue;
    ladder.hit = LadderHit{boundary, ray.at(boundary.t), plain_.normal(boundary, ray)};
    break;
  }
  return ladder;
}

// ---- Words

std::string shape_name(const SolidShape& shape) {
  constexpr std::array<const char*, std::variant_size_v<SolidShape>> names{"half-space", "sphere",  "box",   "cylinder",
                                                                           "cone",       "quadric", "torus", "mesh"};
  return names[shape.index()];
}

std::string face_name(const SolidShape& shape, std::uint32_t face) {
  if (std::holds_alternative<solid::Box>(shape)) return std::array{"-x", "+x", "-y", "+y", "-z", "+z"}[face % 6];
  if (std::holds_alternative<solid::Cylinder>(shape)) return std::array{"side", "base", "top"}[face % 3];
  if (std::holds_alternative<solid::Cone>(shape)) return std::array{"side", "apex", "base"}[face % 3];
  if (std::holds_alternative<std::shared_ptr<const ClosedMesh>>(shape)) return "triangle " + std::to_string(face);
  return std::holds_alternative<solid::HalfSpace>(shape) ? "plane" : "surface";
}

std::string name_of(const LadderRow& row, const Solid& solid) {
  if (row.kind == SolidTree::Kind::primitive) return shape_name(solid.primitives()[row.primitive].shape);
  if (row.kind == SolidTree::Kind::complement) return "complement";
  constexpr std::array names{"union", "intersection", "difference", "symmetric difference"};
  return names[static_cast<std::size_t>(row.operation)];
}

}  // namespace sightline::viz
