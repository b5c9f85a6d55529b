#include <algorithm>
#include <stdexcept>

#include "sightline/scene/scene_import.h"
#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/scene_transform.h"
#include "sightline/scene/scenes.h"

namespace sightline {

void SceneReader::read_objects(const JsonValue& list, Scene& into, NodeId parent, bool is_named) {
  if (++depth_ > deepest_objects) {
    list.fail("objects and groups at most " + std::to_string(deepest_objects) + " deep within each other", "more");
  }
  for (std::size_t i = 0; i < list.size(); ++i) read_object(list[i], into, parent, is_named);
  --depth_;
}

void SceneReader::read_object(const JsonValue& json, Scene& into, NodeId parent, bool is_named) {
  check_members(json, "object");
  if (const auto name = json.find("parent")) {
    if (!is_named) name->fail("no \"parent\" within groups and repeated objects", "one");
    parent = node_of(*name);
  }
  const auto name = json.find("name");
  const std::string text = name ? name->text() : "";
  Transform local;
  if (const auto steps = json.find("transform")) {
    local = transform_of(
        *steps, [&] { return into.graph.path(parent) + (parent == root_node ? "" : "/") + (name ? text : "?"); });
  }
  if (json.find("repeat")) return repeat_object(json, into, parent, local);
  if (into.graph.size() >= most_nodes) json.fail("at most " + std::to_string(most_nodes) + " nodes", "more");
  const NodeId node = into.graph.add(parent, text, local);
  if (is_named && name) {
    const auto [place, is_new] = nodes_.emplace(text, node);
    if (!is_new) place->second = no_node;
  }
  fill_object(json, into, node, is_named);
}

void SceneReader::fill_object(const JsonValue& json, Scene& into, NodeId node, bool is_named) {
  if (const auto material = json.find("material")) {
    into.graph.set_material(node, look_up(materials_, *material, "materials"));
  }
  if (const auto visible = json.find("visible")) into.graph.set_visible(node, visible->truth());
  if (const auto geometry = json.find("geometry")) {
    if (geometry->is_text()) {
      into.graph.set_geometry(node, look_up(geometries_, *geometry, "geometries"));
    } else {
      into.graph.set_geometry(node, static_cast<std::uint32_t>(scene_.geometries.size()));
      scene_.geometries.push_back(geometry_of(into.graph.name(node), *geometry));
    }
  }
  if (const auto json_light = json.find("light")) {
    Light light = light_of(*json_light);
    light.name = into.graph.name(node);
    light.node = node;
    into.lights.push_back(std::move(light));
  }
  if (const auto json_camera = json.find("camera")) {
    SceneCamera camera = camera_of(*json_camera);
    camera.name = into.graph.name(node);
    camera.node = node;
    into.cameras.push_back(std::move(camera));
  }
  if (const auto use = json.find("use")) place(into, node, group_of(*use), {}, *use);
  if (const auto spec = json.find("scene")) place_scene(*spec, into, node);
  if (const auto children = json.find("children")) read_objects(*children, into, node, is_named);
}

void SceneReader::repeat_object(const JsonValue& json, Scene& into, NodeId parent, const Transform& local) {
  const JsonValue repeat = json["repeat"];
  check_members(repeat, "repeat");
  const JsonValue count = repeat["count"];
  if (count.whole() < 1 || count.whole() > most_nodes) count.fail("a number from 1 to " + std::to_string(most_nodes));
  const auto name = json.find("name");
  const std::string text = name ? name->text() : "";
  const auto steps = repeat.find("transform");
  const Transform step = steps ? transform_of(*steps, [&] { return "the repeated " + text; }) : Transform();

  Scene once;
  fill_object(json, once, once.graph.add(root_node, text, local), false);
  if (into.graph.size() + count.whole() * (once.graph.size() - 1) > most_nodes) {
    count.fail("at most " + std::to_string(most_nodes) + " nodes in all");
  }
  Transform moved = local;
  for (std::uint64_t i = 0; i < count.whole(); ++i) {
    if (!is_finite(moved.matrix()) || !is_finite(moved.inverse()) || determinant_sign(moved.matrix()) == 0) {
      repeat.fail("transforms that can be undone", "another after " + std::to_string(i) + " times");
    }
    const NodeId copy = into.graph.size();
    place(into, parent, once, {}, repeat);
    into.graph.set_local(copy, moved);
    moved = step * moved;
  }
}

const Scene& SceneReader::group_of(const JsonValue& name) {
  const auto found = groups_.find(name.text());
  if (found == groups_.end()) {
    std::string known;
    for (const auto& [each, group] : groups_) known += (known.empty() ? "" : ", ") + each;
    name.fail("one of the groups that are defined (" + (known.empty() ? "none" : known) + ")");
  }
  Group& group = found->second;
  if (group.is_open) {
    std::string chain;
    for (const std::string& each : open_groups_) chain += each + " -> ";
    name.fail("a group that does not contain itself", chain + name.text());
  }
  if (group.nodes) return *group.nodes;
  group.is_open = true;
  open_groups_.push_back(name.text());
  Scene nodes;
  read_objects(group.json, nodes, root_node, false);
  group.nodes = std::move(nodes);
  open_groups_.pop_back();
  group.is_open = false;
  return *group.nodes;
}

void SceneReader::place_scene(const JsonValue& spec, Scene& into, NodeId node) {
  const std::string& name = spec.text();
  const bool is_file = name.find_first_of("./") != std::string::npos;
  const std::filesystem::path path = is_file ? file_of(spec) : std::filesystem::path();
  std::shared_ptr<const Scene>& scene = loading_.scenes[is_file ? path.string() : name];
  if (!scene) {
    try {
      scene = std::make_shared<const Scene>(!is_file                      ? make_scene(name, loading_.data_dir)
                                            : path.extension() == ".json" ? SceneReader(loading_).read(path)
                                                                          : import_scene(path));
    } catch (const std::invalid_argument& error) {
      spec.fail("a scene, or a scene or model in a file", error.what());
    }
    scene_.warnings.insert(scene_.warnings.end(), scene->warnings.begin(), scene->warnings.end());
  }
  auto placed = placed_.find(scene.get());
  if (placed == placed_.end()) {
    try {
      placed = placed_.emplace(scene.get(), append_lists(scene_, *scene)).first;
    } catch (const std::length_error& error) {
      spec.fail(error.what(), "more");
    }
  }
  place(into, node, *scene, placed->second, spec);
}

NodeId SceneReader::node_of(const JsonValue& name) const {
  const auto found = nodes_.find(name.text());
  if (found == nodes_.end()) name.fail("the name of an object that stands before, outside groups");
  if (found->second == no_node) name.fail("a name that one object has", "several named \"" + name.text() + "\"");
  return found->second;
}

void SceneReader::place(Scene& into, NodeId parent, const Scene& from, const ListOffsets& offsets,
                        const JsonValue& json) {
  try {
    graft(into, parent, from, offsets);
  } catch (const std::length_error& error) {
    json.fail(error.what(), "more");
  }
}

}  // namespace sightline
