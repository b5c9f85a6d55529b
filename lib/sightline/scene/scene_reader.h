#pragma once
/// How scene_file.h reads: a part of it for each kind of thing that a file may define.

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/io/json_value.h"
#include "sightline/scene/graft.h"
#include "sightline/scene/scene.h"

namespace sightline {

/// What scenes within scenes have in common.
struct SceneLoading {
  std::filesystem::path data_dir;
  std::vector<std::filesystem::path> chain;  ///< Files being read, each named by the one before.
  std::map<std::string, std::shared_ptr<const Scene>> scenes;
  std::map<std::string, MeshGeometry> meshes;
};

/// Files within files.
inline constexpr std::size_t deepest_chain = 32;
/// Objects within each other, of children and groups together; a chain of parents may be as long as memory allows.
inline constexpr int deepest_objects = 500;

/// Reads one scene.
///   F1  Documents stay where they are, because values point into them.
///   F2  A name is looked up among what stands before it: a file's includes, then its own definitions, group by group.
class SceneReader {
 public:
  explicit SceneReader(SceneLoading& loading) : loading_(loading) {}

  Scene read(const std::filesystem::path& path);

 private:
  struct Document {
    std::filesystem::path path;
    nlohmann::json json;
  };
  struct Group {
    JsonValue json;
    bool is_open = false;  ///< Being read.
    std::optional<Scene> nodes;
  };
  /// Numbers by name, in a list of the scene.
  using Names = std::map<std::string, std::uint32_t>;

  // scene_reader.cpp
  void read_document(const std::filesystem::path& path);
  void read_includes(const JsonValue& document);
  /// A place in a list that `name` stands for. \throws FileError where it is taken.
  static void define(Names& names, const std::string& name, std::size_t number, const JsonValue& json);
  static std::uint32_t look_up(const Names& names, const JsonValue& name, const char* what);
  static std::filesystem::path file_of(const JsonValue& json);

  // scene_reader_surfaces.cpp
  TextureSource texture_of(const std::string& name, const JsonValue& json) const;
  Material material_of(const std::string& name, const JsonValue& json) const;
  static DentOptions dents_of(const JsonValue& json);
  Light light_of(const JsonValue& json) const;

  // scene_reader_settings.cpp
  /// What a document says of the scene as a whole, in place of what those said that it includes.
  void read_settings(const JsonValue& json);
  static Surroundings surroundings_of(const JsonValue& json);
  static RenderHints render_hints_of(const JsonValue& json);
  static SceneCamera camera_of(const JsonValue& json);

  // scene_reader_shapes.cpp
  Geometry geometry_of(const std::string& name, const JsonValue& json);
  MeshGeometry mesh_of(const JsonValue& spec);
  static MeshGeometry triangles_of_geometry(const JsonValue& json);

  // scene_reader_animations.cpp
  Animation animation_of(const JsonValue& json) const;
  Channel channel_of(const JsonValue& json) const;

  // scene_reader_objects.cpp
  void read_objects(const JsonValue& list, Scene& into, NodeId parent, bool is_named);
  void read_object(const JsonValue& json, Scene& into, NodeId parent, bool is_named);
  void fill_object(const JsonValue& json, Scene& into, NodeId node, bool is_named);
  void repeat_object(const JsonValue& json, Scene& into, NodeId parent, const Transform& local);
  const Scene& group_of(const JsonValue& name);
  void place_scene(const JsonValue& spec, Scene& into, NodeId node);
  NodeId node_of(const JsonValue& name) const;
  /// graft() that names the place where there would be too many nodes.
  static void place(Scene& into, NodeId parent, const Scene& from, const ListOffsets& offsets, const JsonValue& json);

  SceneLoading& loading_;
  Scene scene_;
  std::deque<Document> documents_;
  std::set<std::filesystem::path> read_;
  Names textures_, materials_, geometries_;
  std::map<std::string, Group> groups_;
  std::vector<std::string> open_groups_;
  int depth_ = 0;
  std::map<std::string, NodeId> nodes_;  ///< By name; no_node for names that several have.
  std::map<const Scene*, ListOffsets> placed_;
};

}  // namespace sightline
