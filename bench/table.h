#pragma once

#include <string>

#include "bench/report.h"

namespace sightline::bench {

/// Machine, compiler, peers, and how to read what follows.
std::string head_text(const Machine& machine, const Plan& plan);

/// One scene: a line a contender, then what one has to know to read it right.
std::string table_text(const SceneReport& scene, const Plan& plan);

}  // namespace sightline::bench
