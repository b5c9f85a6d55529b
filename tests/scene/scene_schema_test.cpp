/// data/scene.schema.json against what the reader knows, and data/scenes against both.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "sightline/scene/scene_file.h"
#include "sightline/scene/scene_members.h"
#include "tests/scene/scene_mutants.h"

namespace sightline {
namespace {

using nlohmann::json;

const json& schema() {
  static const json document = json::parse(std::ifstream(SIGHTLINE_SOURCE_DIR "/data/scene.schema.json"));
  return document;
}

/// As much of JSON Schema as the schema uses. Words that it does not know fail.
bool is_valid(const json& value, const json& rule) {
  static const std::set<std::string> notes = {"$schema", "title", "description", "$defs"};
  for (const auto& [word, what] : rule.items()) {
    bool is_kept = true;
    if (word == "$ref") {
      is_kept = is_valid(value, schema().at(json::json_pointer(what.get<std::string>().substr(1))));
    } else if (word == "type") {
      is_kept = what == "object"    ? value.is_object()
                : what == "array"   ? value.is_array()
                : what == "string"  ? value.is_string()
                : what == "boolean" ? value.is_boolean()
                : what == "integer" ? value.is_number() && value.get<double>() == std::floor(value.get<double>())
                                    : value.is_number();
    } else if (word == "properties") {
      for (const auto& [name, each] : what.items()) {
        is_kept = is_kept && (!value.is_object() || !value.contains(name) || is_valid(value[name], each));
      }
    } else if (word == "additionalProperties") {
      const json members = value.is_object() ? value : json::object();
      for (const auto& [name, each] : members.items()) {
        const bool is_known = rule.contains("properties") && rule["properties"].contains(name);
        is_kept = is_kept && (is_known || (what.is_object() && is_valid(each, what)));
      }
    } else if (word == "required") {
      for (const json& name : what) is_kept = is_kept && value.contains(name.get<std::string>());
    } else if (word == "items") {
      const json elements = value.is_array() ? value : json::array();
      for (const json& each : elements) is_kept = is_kept && is_valid(each, what);
    } else if (word == "anyOf" || word == "oneOf") {
      int count = 0;
      for (const json& each : what) count += is_valid(value, each);
      is_kept = word == "anyOf" ? count > 0 : count == 1;
    } else if (word == "enum") {
      is_kept = std::find(what.begin(), what.end(), value) != what.end();
    } else if (word == "minItems" || word == "minProperties" || word == "minLength") {
      is_kept = (value.is_string() ? value.get<std::string>().size() : value.size()) >= what.get<std::size_t>();
    } else if (word == "maxItems" || word == "maxProperties") {
      is_kept = value.size() <= what.get<std::size_t>();
    } else if (word == "minimum") {
      is_kept = value.is_number() && value.get<double>() >= what.get<double>();
    } else if (word == "exclusiveMinimum") {
      is_kept = value.is_number() && value.get<double>() > what.get<double>();
    } else if (word == "maximum") {
      is_kept = value.is_number() && value.get<double>() <= what.get<double>();
    } else if (word == "pattern") {
      is_kept = value.is_string() && value.get<std::string>().size() == 7 && value.get<std::string>()[0] == '#';
    } else if (!notes.contains(word)) {
      ADD_FAILURE() << "a word that this test does not know: " << word;
    }
    if (!is_kept) return false;
  }
  return true;
}

TEST(SceneSchema, HasTheMembersThatTheReaderKnows) {
  std::set<std::string> kinds;
  for (const SceneMembers& each : scene_members()) {
    kinds.insert(std::string(each.kind));
    ASSERT_TRUE(schema()["$defs"].contains(each.kind)) << each.kind;
    const json& definition = schema()["$defs"][each.kind];
    EXPECT_EQ(definition["additionalProperties"], false) << each.kind;
    std::set<std::string> known(each.names.begin(), each.names.end()), listed;
    for (const auto& [name, rule] : definition["properties"].items()) listed.insert(name);
    EXPECT_EQ(known, listed) << each.kind;
  }
  // And the other way round: all that the schema closes is a kind of the reader's.
  for (const auto& [name, definition] : schema()["$defs"].items()) {
    if (definition.value("additionalProperties", true) == false) {
      EXPECT_TRUE(kinds.contains(name)) << name;
    }
  }
}

TEST(SceneSchema, HasTheNamesThatTheLibraryKnows) {
  const auto expect_names = [](const json& names, const auto& infos) {
    std::set<std::string> known;
    for (const auto& info : infos) known.insert(std::string(info.name));
    EXPECT_EQ(names.get<std::set<std::string>>(), known);
  };
  const json& dents = schema()["$defs"]["dents"]["properties"];
  expect_names(dents["noise"]["enum"], noise_infos);
  expect_names(dents["fractal"]["enum"], fractal_infos);
}

TEST(SceneSchema, TakesTheScenesOfData) {
  const std::vector<SceneSeed> scenes = scene_seeds(SIGHTLINE_SOURCE_DIR "/data/scenes");
  EXPECT_GE(scenes.size(), 20u);
  for (const SceneSeed& scene : scenes) {
    EXPECT_TRUE(is_valid(json::parse(scene.bytes, nullptr, true, true), schema())) << scene.name;
    const Scene read = read_scene(std::filesystem::path(SIGHTLINE_SOURCE_DIR "/data/scenes") / scene.name, {});
    EXPECT_TRUE(read.warnings.empty()) << scene.name;
  }
}

TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
  for (const char* text : {R"([])",
                           R"({"objekts": []})",
                           R"({"objects": [{"geometry": {"sphere": {"radius": -1}}}]})",
                           R"({"objects": [{"geometry": {"spheer": {}}}]})",
                           R"({"objects": [{"geometry": {"mesh": "a", "solid": "b"}}]})",
                           R"({"objects": [{"transform": [{"matrix": [1, 2]}]}]})",
                           R"({"materials": {"m": {"color": "red"}}})",
                           R"({"objects": [{"transform": [{"translate": [0,0,0], "scale": 1}]}]})",
                           R"({"objects": [{"light": {}}]})",
                           R"({"background": "blue"})",
                           R"({"background": {"zenith": [0, 0, 1]}})",
                           R"({"background": {"image": "a.png", "color": [0, 0, 0]}})",
                           R"({"ambient": {}})",
                           R"({"fog": {"density": 1}})",
                           R"({"render": {"samples": 0}})",
                           R"({"objects": [{"camera": {"shutter": [1]}}]})",
                           R"({"objects": [{"visible": 0}]})",
                           R"({"materials": {"m": {"dents": {"octaves": 0}}}})",
                           R"({"materials": {"m": {"roughness": 2}}})",
                           R"({"objects": [{"camera": {"field_of_view": 180}}]})"}) {
    EXPECT_FALSE(is_valid(json::parse(text), schema())) << text;
  }
  EXPECT_TRUE(is_valid(json::parse(R"({"objects": [{"geometry": {"sphere": {"radius": 1}}}]})"), schema()));
}

}  // namespace
}  // namespace sightline
