#pragma once
/// How command lines name structures and set their options; the same in every program.

#include <span>
#include <string>
#include <vector>

#include "sightline/query/tracer.h"

namespace sightline {

/// A structure of the registry with options of its own.
struct AcceleratorSpec {
  std::string label;  ///< As it was asked for.
  std::string accelerator;
  TracerSettings settings;
};

/// "kd-tree", "kd-tree:max_leaf_size=8,max_depth=20", or several of these, joined by commas: what stands before a "="
/// and names no structure is one more option of the structure before it. A name that ends in ".so" is a file: the
/// structure in it is loaded, and goes by its own name from then on (structure_plugin.h).
/// \throws std::invalid_argument where it is not of this form; what load_structure() throws. Names and values are not
/// looked at.
std::vector<AcceleratorSpec> parse_accelerators(const std::string& text);

/// "kd-tree.max_leaf_size=8": sets it in every entry of that structure. The last one of an option wins, but what an
/// entry itself says stays.
/// \throws std::invalid_argument where one is not of this form, or no entry is of that structure.
void apply_settings(std::span<AcceleratorSpec> specs, std::span<const std::string> texts);

/// Refuses what the registry does not know or allow, before any scene is read. \throws std::invalid_argument
void check_accelerator(const AcceleratorSpec& spec);

}  // namespace sightline
