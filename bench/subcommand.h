#pragma once
/// What the command lines of `solids`, `torus`, `noise` and `instances` share.

#include <string>
#include <string_view>
#include <vector>

#include "bench/machine.h"
#include "sightline/math/level.h"

namespace CLI {
class App;
}

namespace sightline::bench {

/// Parses. Returns the help text, with `reading` behind it, where that is asked for, and nothing otherwise.
/// \throws UsageError in one line
std::string parse_or_help(CLI::App& app, int argc, const char* const* argv, std::string_view reading);

/// Refuses now what could not be written at the end; no file is fine. \throws UsageError, FileError
void check_json(const std::string& path);

/// The head of a report: beside what (" beside POV-Ray 3.7"), on what machine, with what build, and what to be wary of
/// there.
std::string machine_text(const Machine& machine, const std::string& beside = {});

/// Each once, in the order given. \throws UsageError
std::vector<Level> parse_levels(const std::vector<std::string>& names);

/// \throws UsageError where `name` is not `known`; `what` says of what it is one.
void require_known(const std::string& what, const std::string& name, const std::vector<std::string>& known);

/// On standard output, at once. \throws std::runtime_error
void print(const std::string& text);

}  // namespace sightline::bench
