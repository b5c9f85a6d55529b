#include "viz/graph/graph_scene.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/scene/levels.h"
#include "sightline/scene/rocket.h"
#include "sightline/scene/rocket_motion.h"
#include "sightline/scene/scenes.h"
#include "viz/graph/tree_rows.h"

namespace sightline::viz {
namespace {

constexpr double turning = 30;  // of levels, in degrees a second

/// renderLevel's t: all levels turn alike.
class TurningLevels final : public Controller {
 public:
  explicit TurningLevels(Scene scene) : scene_(std::move(scene)) {}

  void pose(double time, std::vector<NodePose>& poses) const override {
    Scene turned = scene_;
    turn_levels(turned, turning * time);
    for (NodeId node = 0; node < turned.graph.size(); ++node) {
      const std::string& name = turned.graph.name(node);
      if (name == "right" || name == "left") poses.push_back({node, turned.graph.local(node)});
    }
  }

 private:
  Scene scene_;
};

class AllAnimations final : public Controller {
 public:
  explicit AllAnimations(const std::vector<Animation>& animations) {
    for (const Animation& animation : animations) controllers_.emplace_back(animation);
  }

  void pose(double time, std::vector<NodePose>& poses) const override {
    for (const AnimationController& controller : controllers_) controller.pose(time, poses);
  }

 private:
  std::vector<AnimationController> controllers_;
};

/// Letters to insert, delete or replace, small and capital ones alike (Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[k]) ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

/// The names nearest to `text`, each once.
std::string names_like(const SceneGraph& graph, const std::vector<NodeId>& order, const std::string& text) {
  constexpr std::size_t most_letters = 64, most_names = 6;
  const std::string last = text.substr(text.rfind('/') + 1).substr(0, most_letters);
  std::vector<std::pair<std::size_t, std::string>> names;
  for (const NodeId node : order) {
    const std::string& name = graph.name(node);
    if (name.empty() || name.size() > most_letters) continue;
    const auto is_same = [&](const auto& entry) { return entry.second == name; };
    if (std::any_of(names.begin(), names.end(), is_same)) continue;
    names.emplace_back(distance(last, name), name);
    std::stable_sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    if (names.size() > most_names) names.pop_back();
  }
  std::string list;
  for (const auto& [letters, name] : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "#0 to #" + std::to_string(graph.size() - 1) : list;
}

/// Of names that nobody knows also "rocket" is told, which is known here only.
Scene make_known_scene(const std::string& spec, const std::filesystem::path& data_dir) try {
  return make_scene(spec, data_dir);
} catch (const std::invalid_argument& error) {
  const std::string what = error.what();
  const std::size_t found = what.rfind(", found");
  const bool is_list = what.find("one of") != std::string::npos && found != std::string::npos;
  throw std::invalid_argument(is_list ? what.substr(0, found) + " rocket" + what.substr(found) : what);
}

bool ends_with_steps(const std::string& path, const std::string& text) {
  return path == text || (text.front() != '/' && path.ends_with("/" + text));
}

}  // namespace

PlayedScene load_played_scene(const std::string& spec, const std::filesystem::path& data_dir) {
  if (spec == "rocket") {
    PlayedScene played{rocket(), nullptr};
    const RocketFlight flight;
    played.controller = std::make_unique<RocketMotion>(flight, played.scene.graph.find("/rocket"),
                                                       played.scene.graph.find("/rocket/flame"));
    played.duration = flight.landing();
    return played;
  }
  PlayedScene played{make_known_scene(spec, data_dir), nullptr};
  if (spec.substr(0, spec.find(':')) == "levels") {
    played.controller = std::make_unique<TurningLevels>(played.scene);
    played.duration = 360 / turning;
  } else if (!played.scene.animations.empty()) {
    played.controller = std::make_unique<AllAnimations>(played.scene.animations);
    for (const Animation& animation : played.scene.animations) {
      played.duration = std::max(played.duration, animation.duration());
    }
  }
  return played;
}

NodeId node_by_name(const SceneGraph& graph, const std::string& text) {
  if (const NodeId node = graph.find(text); !text.empty() && node != no_node) return node;
  if (text.starts_with('#')) {
    NodeId node = no_node;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), node);
    if (error == std::errc() && end == text.data() + text.size() && node < graph.size()) return node;
  }
  const TreeShape shape(graph);
  if (!text.empty()) {
    const std::string last = text.substr(text.rfind('/') + 1);
    NodeId found = no_node;
    for (const NodeId node : shape.order) {
      if (graph.name(node) != last || node == root_node || !ends_with_steps(graph.path(node), text)) continue;
      if (found == no_node || shape.depths[node] < shape.depths[found]) found = node;
    }
    if (found != no_node) return found;
  }
  throw std::invalid_argument("scene graph: expected the name or path of one of " + std::to_string(graph.size()) +
                              " nodes, such as " + names_like(graph, shape.order, text) + ", found \"" + text + "\"");
}

}  // namespace sightline::viz
