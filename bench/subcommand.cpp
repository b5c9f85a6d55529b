#include "bench/subcommand.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "bench/command_line.h"
#include "bench/text_table.h"
#include "sightline/io/output_file.h"

namespace sightline::bench {

std::string parse_or_help(CLI::App& app, int argc, const char* const* argv, std::string_view reading) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return app.help() + std::string(reading);
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw UsageError(text);
  }
  return {};
}

std::function<std::string(const std::string&)> whole_number() {
  return [](const std::string& text) -> std::string {
    const bool is_whole =
        !text.empty() && text.size() < 20 && text.find_first_not_of("0123456789") == std::string::npos;
    return is_whole ? "" : "expected a whole number from 0 on, found '" + text + "'";
  };
}

std::vector<std::string> split_names(const std::vector<std::string>& texts) {
  std::vector<std::string> names;
  for (const std::string& text : texts) {
    for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
      end = text.find(',', at);
      names.push_back(text.substr(at, end - at));
    }
  }
  return names;
}

void check_json(const std::string& path) {
  if (path == "-") throw UsageError("--json takes a file; standard output has the table");
  if (!path.empty()) OutputFile{path};
}

std::string machine_text(const Machine& machine, const std::string& beside) {
  std::string text = "Sightline " + machine.sightline_version + beside + ", on " + machine.processor + " (" +
                     plural(machine.hardware_threads, "hardware thread") + ")\n" + machine.compiler + ' ' +
                     machine.flags + '\n';
  if (machine.has_assertions) text += "Assertions are on in this build: its times say little.\n";
  if (machine.load >= 0.5 * machine.hardware_threads) {
    text += "Other programs are running (load " + number_text(machine.load, 2) + "): expect wide intervals.\n";
  }
  return text;
}

std::string json_within_page(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::vector<Level> parse_levels(const std::vector<std::string>& names) {
  std::vector<Level> levels;
  for (const std::string& name : names) {
    const auto info =
        std::find_if(level_infos.begin(), level_infos.end(), [&](const auto& i) { return i.name == name; });
    if (info == level_infos.end())
      throw UsageError("unknown level '" + name + "'; expected some of fast, watertight, precise, exact");
    if (std::find(levels.begin(), levels.end(), info->level) != levels.end())
      throw UsageError("--precision names " + name + " twice");
    levels.push_back(info->level);
  }
  return levels;
}

void require_known(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw UsageError("unknown " + what + " '" + name + "'; expected one of " + joined(known));
}

void print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
}

}  // namespace sightline::bench
