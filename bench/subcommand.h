#pragma once
/// What the commands beside the main one share.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/machine.h"
#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "sightline/math/level.h"

namespace CLI {
class App;
}

namespace sightline::bench {

/// Parses. Returns the help text, with `reading` behind it, where that is asked for, and nothing otherwise.
/// \throws UsageError in one line
std::string parse_or_help(CLI::App& app, int argc, const char* const* argv, std::string_view reading);

/// For options that are whole numbers from 0 on: "-1", which CLI11 wraps around, and "1e3" are refused. For CLI::App.
std::function<std::string(const std::string&)> whole_number();

/// Names that commas join, one by one: an empty one is a name too, so that it is refused as unknown.
std::vector<std::string> split_names(const std::vector<std::string>& texts);

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

/// As it may stand in an element of a page: nothing in the data ends that.
std::string json_within_page(const std::string& json);

/// Prints the head of a report before its first table, and the tables as they come.
class TablePrinter {
 public:
  template <class Report>
  void show(const Report& so_far, const std::string& table) {
    if (is_first_) print(head_text(so_far));
    is_first_ = false;
    print('\n' + table);
  }

 private:
  bool is_first_ = true;
};

/// A command whose line was read into a plan: prints the help, where there is any, and does nothing else. Otherwise
/// run(progress) measures and prints, and the report that it returns is written, where the plan names a file for it.
/// Returns the exit status. \throws what run() does, and what writing does.
template <class Plan, class Run>
int run_command(const std::string& help, const Plan& plan, const Run& run) {
  if (!help.empty()) {
    print(help);
    return 0;
  }
  check_json(plan.json);
  Progress progress;
  const auto report = run(progress);
  if (!plan.json.empty()) write_text(plan.json, json_text(report));
  return 0;
}

/// The same for a report that is printed as one text: measure(plan, progress) returns it.
template <class Plan, class Measure>
int run_and_print(const std::string& help, const Plan& plan, const Measure& measure) {
  return run_command(help, plan, [&](Progress& progress) {
    auto report = measure(plan, progress);
    print(text_of(report));
    return report;
  });
}

}  // namespace sightline::bench
