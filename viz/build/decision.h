#pragma once
/// What a builder weighed at one node: the candidates, what each would have cost, and which was taken.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/math/volumes.h"

namespace sightline::viz {

/// One way to divide a node. Costs of a step are all in one unit: see Decision::cost_unit.
struct BuildCandidate {
  int axis = -1;             ///< 0 to 2; -1 for a plane of any orientation, and for what is no plane.
  double position = 0;       ///< Of the plane along the axis, in the scene's units.
  Plane plane{Vec3d(0), 0};  ///< In the scene's coordinates, where axis is -1; no normal where it is no plane.
  double cost = 0;
  std::uint32_t below = 0, above = 0;  ///< What the parts would hold; whoever is in both counts twice.
  std::uint32_t straddling = 0;        ///< Of the node's primitives, how many have points on both sides of the plane.
  std::string label{};                 ///< Where a position does not say enough.
};

/// How candidates are best compared.
enum class DecisionChart {
  by_position,  ///< A curve an axis.
  ranked,       ///< No common axis: the cheapest as bars.
  by_cells      ///< Numbers of cells along the first axis of the chart, in `position`.
};

struct Decision {
  std::vector<std::uint32_t> primitives;  ///< Ids; one may stand there twice where it was cut into references.
  std::vector<BuildCandidate> candidates;
  std::optional<std::size_t> chosen;  ///< Of the candidates; none where a leaf was made, or a rule divided.
  bool is_divided = false;
  double leaf_cost = 0;
  std::string cost_unit;                          ///< What a cost of 1 is: "triangle tests".
  std::vector<std::uint32_t> below, above;        ///< Ids of the parts, where the node is divided in two.
  std::vector<std::vector<std::uint32_t>> parts;  ///< The same for more than two.
  std::vector<Aabb> merged;  ///< Of nodes that a builder had made, and gave up in favor of their children.
  std::string reason;        ///< What was decided and why, one sentence.
  std::string how;           ///< What was weighed: "perfect splits: every plane at which ..."
  DecisionChart chart = DecisionChart::by_position;
  std::string position_title;                ///< Of the first axis, where that is no position in the scene.
  std::string leaf_title = "a leaf";         ///< Of leaf_cost.
  std::string other_title = "other planes";  ///< Candidates whose axis is -1.
};

}  // namespace sightline::viz
