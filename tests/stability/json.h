#pragma once

#include <string>

#include "tests/stability/provenance.h"
#include "tests/stability/report.h"

namespace sightline::stability {

/// All that was found, with what it was found with. tests/README.md tells of the fields.
std::string json_text(const Report& report, const Provenance& provenance);

}  // namespace sightline::stability
