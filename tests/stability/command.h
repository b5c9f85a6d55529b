#pragma once

#include <ostream>
#include <span>

#include "tests/hard_cases/hard_case.h"

namespace sightline::stability {

/// sightline-stability over a table: data goes to `out`, messages to `messages`. Returns the exit status.
/// \throws std::invalid_argument for what is wrong with the command line
int run(std::span<const hard::HardCase> cases, int argc, const char* const* argv, std::ostream& out,
        std::ostream& messages);

}  // namespace sightline::stability
