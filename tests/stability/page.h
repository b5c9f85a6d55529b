#pragma once
/// The report as one page of HTML, whole in itself.

#include <string>
#include <string_view>

#include "tests/stability/provenance.h"
#include "tests/stability/report.h"

namespace sightline::stability {

std::string page_of(const Report& report, const Provenance& provenance);

extern const std::string_view page_style;
extern const std::string_view page_script;

}  // namespace sightline::stability
