#include "labs/runner/workshop.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "labs/labs.h"
#include "labs/runner/starter.h"
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

std::string Workshop::starter_text(const Lab& lab, const std::string& name) const {
  const auto text_in = [](const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  const auto starter = folder_of(lab) / "starter" / name, solution = folder_of(lab) / "solution" / name;
  if (std::filesystem::exists(starter)) return text_in(starter);
  if (!std::filesystem::exists(solution)) throw FileError(starter, 0, "the lab's file", "none");
  return starter_of(solution, text_in(solution));
}

std::vector<std::filesystem::path> Workshop::sources() const {
  std::vector<std::filesystem::path> paths{labs_ / "kit", labs_.parent_path() / "lib",
                                           toolchain_.prelude.parent_path()};
  for (const Lab& lab : all_labs()) paths.push_back(folder_of(lab) / "subject.cpp");
  for (const std::string& word : toolchain_.libraries) {
    if (word.starts_with("/")) paths.emplace_back(word);
  }
  return paths;
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
