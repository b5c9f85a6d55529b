#pragma once
/// What a walk has made of each cell by the end of a step, and the step in words.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "viz/walk/walk.h"

namespace sightline::viz {

enum class CellState : std::uint8_t {
  unseen,   ///< What contains it has not been opened yet.
  beside,   ///< What contains it has been opened; the ray passes this by.
  opened,   ///< Earlier.
  pending,  ///< Put aside, to be taken up or dropped later.
  culled,   ///< Dropped unopened.
  current
};
inline constexpr std::array<std::string_view, 6> state_names = {"unseen",  "beside", "opened",
                                                                "pending", "culled", "current"};

/// One for each of walk.cells. \pre `step` is one of the walk's.
std::vector<CellState> states_at(const Walk& walk, std::size_t step);

/// Index into walk.cells.
std::size_t current_cell(const Walk& walk, std::size_t step);

/// The cells whose nearest opened ancestor is this one: what opening it has met, or passed by.
struct Children {
  std::vector<std::size_t> met, beside;
};
Children children_of(const Walk& walk, std::size_t cell);

/// Of the steps up to this one.
TraversalStats statistics_at(const Walk& walk, std::size_t step);

/// How far along the ray the walk is: nothing beyond the far limit.
double t_at(const Walk& walk, std::size_t step);

/// A node's number as it is shown: of a kd-tree's leaf without the bit that says that it is one.
std::string number_of_node(std::uint32_t node);

/// What the step does.
std::string sentence_of(const Walk& walk, std::size_t step);

/// Four digits, "infinity" where it is that.
std::string text_of_t(double t);

/// The next or, with `direction` -1, the last leaf beside this step; the step itself where there is none.
std::size_t leaf_beside(const Walk& walk, std::size_t step, int direction);

}  // namespace sightline::viz
