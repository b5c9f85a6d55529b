#include "sightline/scene/scene_reader.h"

#include <algorithm>
#include <cctype>

#include "sightline/io/file_bytes.h"
#include "sightline/scene/scene_file.h"
#include "sightline/scene/scene_import.h"
#include "sightline/scene/scene_members.h"

namespace sightline {
namespace {

/// Files longer than this are none that somebody wrote, or a program sensibly.
constexpr std::size_t longest_file = std::size_t{1} << 30;

std::string chain_text(const std::vector<std::filesystem::path>& chain, const std::filesystem::path& last) {
  std::string text;
  for (const auto& each : chain) text += each.filename().string() + " -> ";
  return text + last.filename().string();
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

Scene SceneReader::read(const std::filesystem::path& path) {
  read_document(path);
  if (scene_.name.empty()) scene_.name = path.stem().string();
  return std::move(scene_);
}

void SceneReader::read_document(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path known = std::filesystem::weakly_canonical(path, ignored);
  auto& chain = loading_.chain;
  if (std::find(chain.begin(), chain.end(), known) != chain.end()) {
    throw FileError(path, 0, "a scene that does not contain itself", chain_text(chain, known));
  }
  if (chain.size() >= deepest_chain) {
    throw FileError(path, 0, "files at most " + std::to_string(deepest_chain) + " deep within each other", "more");
  }
  if (!read_.insert(known).second) return;  // its definitions are here already
  const std::string text = read_bytes(path);
  if (text.size() > longest_file)
    throw FileError(path, 0, "a scene of at most 1 GiB", std::to_string(text.size()) + " bytes");
  const Document& document = documents_.emplace_back(path, parse_json(path, text, JsonComments::allowed));
  const JsonValue json(document.path, document.json);
  check_members(json, "scene");

  chain.push_back(known);
  read_includes(json);
  if (const auto name = json.find("name"); name && chain.size() == 1) scene_.name = name->text();
  read_settings(json);
  if (const auto list = json.find("textures")) {
    list->for_each_member([&](const std::string& name, const JsonValue& each) {
      define(textures_, name, scene_.textures.size(), each);
      scene_.textures.push_back(texture_of(name, each));
    });
  }
  if (const auto list = json.find("materials")) {
    list->for_each_member([&](const std::string& name, const JsonValue& each) {
      define(materials_, name, scene_.materials.size(), each);
      scene_.materials.push_back(material_of(name, each));
    });
  }
  if (const auto list = json.find("geometries")) {
    list->for_each_member([&](const std::string& name, const JsonValue& each) {
      define(geometries_, name, scene_.geometries.size(), each);
      scene_.geometries.push_back(geometry_of(name, each));
    });
  }
  if (const auto list = json.find("groups")) {
    list->for_each_member([&](const std::string& name, const JsonValue& each) {
      each.size();
      if (!groups_.emplace(name, Group{each, false, {}}).second)
        each.fail("a name that is free", "another \"" + name + "\"");
    });
  }
  if (const auto list = json.find("objects")) read_objects(*list, scene_, root_node, true);
  if (const auto list = json.find("animations")) {
    for (std::size_t i = 0; i < list->size(); ++i) scene_.animations.push_back(animation_of((*list)[i]));
  }
  chain.pop_back();
}

void SceneReader::read_includes(const JsonValue& document) {
  const auto list = document.find("include");
  if (!list) return;
  if (!list->is_array()) return read_document(file_of(*list));
  for (std::size_t i = 0; i < list->size(); ++i) read_document(file_of((*list)[i]));
}

void SceneReader::define(Names& names, const std::string& name, std::size_t number, const JsonValue& json) {
  if (!names.emplace(name, static_cast<std::uint32_t>(number)).second) {
    json.fail("a name that is free", "another \"" + name + "\" in an included file");
  }
}

std::uint32_t SceneReader::look_up(const Names& names, const JsonValue& name, const char* what) {
  const auto found = names.find(name.text());
  if (found != names.end()) return found->second;
  std::string known;
  for (const auto& [each, number] : names) known += (known.empty() ? "" : ", ") + each;
  name.fail(std::string("one of the ") + what + " that are defined (" + (known.empty() ? "none" : known) + ")");
}

std::filesystem::path SceneReader::file_of(const JsonValue& json) {
  const std::string& text = json.text();
  const std::filesystem::path path(text);
  if (text.empty() || path.is_absolute() || text.find('\0') != std::string::npos) {
    json.fail("a path relative to this file");
  }
  return (json.path().parent_path() / path).lexically_normal();
}

bool is_scene_file(const std::filesystem::path& path) { return extension_of(path) == ".json" || is_model_file(path); }

Scene read_scene(const std::filesystem::path& path, const std::filesystem::path& data_dir) {
  if (extension_of(path) != ".json") return import_scene(path);
  SceneLoading loading;
  loading.data_dir = data_dir;
  return SceneReader(loading).read(path);
}

}  // namespace sightline
