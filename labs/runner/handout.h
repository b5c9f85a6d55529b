#pragma once
/// The repository as students get it: everything but the solutions.

#include <filesystem>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// Copies the repository without solutions, mutants, builds and what is in labs/mine to `folder`, which must not exist;
/// starters take the place of the solutions. Looks for solutions in all that was copied, and leaves nothing where it
/// finds one. 0 where all went well.
int write_handout(const Workshop& workshop, const std::filesystem::path& folder);

}  // namespace sightline::labs
