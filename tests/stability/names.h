#pragma once
/// Names that a person types: of cases, groups, levels and structures.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/stability/report.h"

namespace sightline::stability {

/// "a,b" in a list is two names.
std::vector<std::string> split_at_commas(std::span<const std::string> lists);

/// Up to `count` of `known`, the nearest first: those that begin with `name`, then by letters to insert, delete or
/// replace (Levenshtein).
std::vector<std::string_view> nearest(std::string_view name, std::span<const std::string_view> known,
                                      std::size_t count = 3);

/// Headings of the table, each once, in its order.
std::vector<std::string_view> groups_of(std::span<const HardCase> cases);

/// Those whose id is in `ids`, which may hold patterns such as sph-*, and whose group is in `groups`; an empty list
/// does not limit. In the table's order. \throws std::invalid_argument for a name or pattern that is nothing's.
std::vector<const HardCase*> select(std::span<const HardCase> cases, std::span<const std::string> ids,
                                    std::span<const std::string> groups);

/// \throws std::invalid_argument
Level level_named(const std::string& name);
/// Leaves names as they are where all are structures'. \throws std::invalid_argument
void check_structures(std::span<const std::string> names);

}  // namespace sightline::stability
