#include "labs/runner/workshop.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "labs/labs.h"
#include "sightline/io/file_error.h"
#include "viz/child_process.h"

namespace sightline::labs {
namespace {

Toolchain toolchain_from(const std::filesystem::path& file, std::filesystem::path& labs) {
  std::ifstream in(file);
  if (!in) throw FileError(file, 0, "what the build leaves for the labs", "no such file");
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    labs = json.at("labs").get<std::string>();
    return {json.at("compiler").get<std::string>(), json.at("flags").get<std::vector<std::string>>(),
            json.at("prelude").get<std::string>(), json.at("libraries").get<std::vector<std::string>>()};
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file, 0, "what the build leaves for the labs", error.what());
  }
}

}  // namespace

Workshop::Workshop(std::filesystem::path mine) : programs_(viz::program_folder()) {
  toolchain_ = toolchain_from(programs_.parent_path() / "labs" / "build.json", labs_);
  mine_ = mine.empty() ? labs_ / "mine" : std::filesystem::absolute(mine);
}

std::string Workshop::shown(const std::filesystem::path& path) {
  const auto here = std::filesystem::current_path();
  const auto relative = path.lexically_relative(here);
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

const std::vector<Lab>& all_labs() {
  static const std::vector<Lab> labs = make_labs();
  return labs;
}

const Lab& lab_called(const std::string& text) {
  std::string known;
  for (const Lab& lab : all_labs()) {
    const bool is_number = !text.empty() && text.size() < 3 && std::string(2 - text.size(), '0') + text == lab.number;
    if (is_number || text == lab.name || text == lab.folder()) return lab;
    known += (known.empty() ? "" : ", ") + lab.folder();
  }
  throw std::invalid_argument("unknown lab '" + text + "'; expected one of " + known);
}

}  // namespace sightline::labs
