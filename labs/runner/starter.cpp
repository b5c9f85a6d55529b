#include "labs/runner/starter.h"

#include <sstream>

#include "sightline/io/file_error.h"

namespace sightline::labs {
namespace {

constexpr std::string_view hole_mark = "// lab:hole ", cut_mark = "// lab:cut", end_mark = "// lab:end";

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' '), last = line.find_last_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first, last - first + 1);
}

/// Calls keep(line) for lines that stay, hole(indent, function, section) for holes, and drop(line) for the rest.
template <class Keep, class Hole, class Drop>
void read_marks(const std::filesystem::path& path, const std::string& solution, Keep keep, Hole hole, Drop drop) {
  std::istringstream in(solution);
  bool is_inside = false;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string text = trimmed(line);
    const bool is_hole = text.starts_with(hole_mark), is_cut = text == cut_mark;
    if (is_hole || is_cut) {
      if (is_inside) throw FileError(path, number, "lab:end before another mark", text);
      is_inside = true;
      if (is_cut) continue;
      const std::size_t bar = text.find(" | ");
      if (bar == std::string::npos) throw FileError(path, number, "lab:hole FUNCTION | SECTION", text);
      hole(line.substr(0, line.find('/')), text.substr(hole_mark.size(), bar - hole_mark.size()), text.substr(bar + 3));
    } else if (text == end_mark) {
      if (!is_inside) throw FileError(path, number, "a lab:hole or lab:cut before lab:end", text);
      is_inside = false;
    } else if (is_inside) {
      drop(text);
    } else {
      keep(line);
    }
  }
  if (is_inside) throw FileError(path, number, "lab:end", "the end of the file");
}

}  // namespace

std::string starter_of(const std::filesystem::path& path, const std::string& solution) {
  std::string starter;
  read_marks(
      path, solution, [&](const std::string& line) { starter += line + "\n"; },
      [&](const std::string& indent, const std::string& function, const std::string& section) {
        starter += indent + "sightline::labs::not_yet_implemented(\"" + function + "\", \"" + section + "\");\n";
      },
      [](const std::string&) {});
  return starter;
}

std::vector<std::string> secret_lines(const std::filesystem::path& path, const std::string& solution) {
  std::vector<std::string> lines;
  read_marks(
      path, solution, [](const std::string&) {}, [](const std::string&, const std::string&, const std::string&) {},
      [&](const std::string& line) {
        if (line.size() > 12) lines.push_back(line);  // shorter ones, such as "return {};", are found anywhere
      });
  return lines;
}

}  // namespace sightline::labs
