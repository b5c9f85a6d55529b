#pragma once
/// What this machine and compiler are: what a number was found with.

#include <string>

namespace sightline {

std::string processor_name();
/// Distribution, kernel and architecture.
std::string system_name();
/// Of this library, which is that of all that is built with it.
std::string compiler_name();
/// UTC, ISO 8601.
std::string utc_date();

}  // namespace sightline
