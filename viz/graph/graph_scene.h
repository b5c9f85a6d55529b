#pragma once
/// Scenes with what moves them, and their nodes by name.

#include <filesystem>
#include <memory>
#include <string>

#include "sightline/scene/controller.h"
#include "sightline/scene/scene.h"

namespace sightline::viz {

struct PlayedScene {
  Scene scene;
  std::unique_ptr<const Controller> controller;  ///< None where nothing moves.
  double duration = 0;                           ///< Seconds that show its motion.
};

/// What make_scene() knows, and "rocket", which flies. "levels" turns by 30 degrees a second; the animations of files
/// are all played. \throws as make_scene() does.
PlayedScene load_played_scene(const std::string& spec, const std::filesystem::path& data_dir);

/// By its path ("/top/left"), the end of its path ("left/sphere"), its name or its number ("#12"); the least deep
/// one, of these the first in the order of the tree. \throws std::invalid_argument that lists those with names like it.
NodeId node_by_name(const SceneGraph& graph, const std::string& text);

}  // namespace sightline::viz
