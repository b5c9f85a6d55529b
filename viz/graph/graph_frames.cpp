#include "viz/graph/graph_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "viz/partition_picture.h"

namespace sightline::viz {
namespace {

/// Collects the nodes that events pass, as long as it lives.
class Listener {
 public:
  explicit Listener(LiveScene& scene) : scene_(scene) {
    subscription_ = scene.subscribe(
        [this](const LiveScene::Bubble& bubble) { way_.insert(way_.end(), bubble.way.begin(), bubble.way.end()); });
  }
  ~Listener() { scene_.unsubscribe(subscription_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  const std::vector<NodeId>& way() const { return way_; }

 private:
  LiveScene& scene_;
  std::uint32_t subscription_ = 0;
  std::vector<NodeId> way_;
};

LiveScene::Counters operator-(const LiveScene::Counters& a, const LiveScene::Counters& b) {
  return {a.marked - b.marked, a.worlds - b.worlds, a.bounds - b.bounds, a.children_read - b.children_read};
}

std::string name_of_node(const SceneGraph& graph, NodeId node) {
  if (node == root_node) return "the root";
  return graph.name(node).empty() ? "node " + std::to_string(node) : graph.name(node);
}

}  // namespace

bool is_nothing(const Bound& bound) {
  return std::visit([](const auto& volume) { return sightline::is_nothing(volume); }, bound);
}

bool is_unbounded(const Bound& bound) {
  return std::visit([](const auto& volume) { return sightline::is_unbounded(volume); }, bound);
}

double volume_of(const Bound& bound) {
  if (is_unbounded(bound)) return std::numeric_limits<double>::infinity();
  return std::visit([](const auto& volume) { return sightline::volume_of(volume); }, bound);
}

SharedSnapshot snapshot_of(LiveScene& scene, BoundKind kind) {
  auto snapshot = std::make_shared<Snapshot>();
  with_kind(kind, [&]<class V>(const V&) {
    scene.refresh(kind);
    for (NodeId node = 0; node < scene.graph().size(); ++node) {
      snapshot->worlds.push_back(scene.world(node).matrix());
      snapshot->bounds.emplace_back(scene.bounds<V>(node));
    }
  });
  return snapshot;
}

Change drag(LiveScene& scene, NodeId node, const Vec3d& by, BoundKind kind) {
  Change change;
  change.node = node;
  change.by = by;
  change.before = snapshot_of(scene, kind);
  const LiveScene::Counters counters = scene.counters();
  {
    const NodeId parent = scene.graph().parent(node);
    const Transform outer = parent == no_node ? Transform() : scene.world(parent);
    const Listener listener(scene);
    scene.set_local(node, dragged(scene.graph().local(node), outer, by));
    change.way = listener.way();
  }
  change.after = snapshot_of(scene, kind);
  change.work = scene.counters() - counters;
  return change;
}

std::vector<GraphFrame> frames_of(const Change& change, const SceneGraph& graph, int count) {
  std::vector<GraphFrame> frames;
  frames.push_back({.title = "before",
                    .text = "all bounds are known",
                    .places = change.before,
                    .bounds = change.before,
                    .former = nullptr});
  const std::size_t all = change.way.size();
  const std::size_t steps = std::min<std::size_t>(all, static_cast<std::size_t>(std::max(count - 2, 0)));
  for (std::size_t step = 1; step <= steps; ++step) {
    const std::size_t told = steps == 1 ? all : 1 + (all - 1) * (step - 1) / (steps - 1);
    const bool is_first = step == 1;
    frames.push_back(
        {.title =
             std::to_string(told) + " of " + std::to_string(all) + ": " + name_of_node(graph, change.way[told - 1]),
         .text = is_first ? "moved; its event marks bounds as stale" : "the event bubbles up: stale as well",
         .places = change.after,
         .bounds = change.before,
         .former = nullptr,
         .told = {change.way.begin(), change.way.begin() + static_cast<std::ptrdiff_t>(told)},
         .is_stale = true,
         .moved = change.node});
  }
  frames.push_back({.title = "after",
                    .text = "asked for: " + counted(change.work.worlds, "place") + ", " +
                            counted(change.work.bounds, "bound") + " computed",
                    .places = change.after,
                    .bounds = change.after,
                    .former = change.before,
                    .told = change.way,
                    .moved = change.node});
  return frames;
}

std::vector<NodeId> pose(LiveScene& scene, const Controller& controller, double time) {
  std::vector<NodePose> poses;
  controller.pose(time, poses);
  const Listener listener(scene);
  scene.apply(poses);
  return listener.way();
}

std::vector<GraphFrame> frames_of(LiveScene& scene, const Controller& controller, double first, double last, int count,
                                  BoundKind kind) {
  std::vector<GraphFrame> frames;
  SharedSnapshot former;
  scene.refresh(kind);  // events end where bounds are stale already
  for (int i = 0; i < count; ++i) {
    const double time = count == 1 ? first : first + (last - first) * i / (count - 1);
    const LiveScene::Counters counters = scene.counters();
    std::vector<NodeId> told = pose(scene, controller, time);
    const SharedSnapshot places = snapshot_of(scene, kind);
    const LiveScene::Counters work = scene.counters() - counters;
    char title[48];
    std::snprintf(title, sizeof title, "t = %.4g s", time);
    frames.push_back({.title = title,
                      .text = counted(work.bounds, "bound") + " computed",
                      .places = places,
                      .bounds = places,
                      .former = former,
                      .told = std::move(told)});
    former = places;
  }
  return frames;
}

GraphFrame still_frame(LiveScene& scene, BoundKind kind) {
  const SharedSnapshot places = snapshot_of(scene, kind);
  return {.title = "", .text = "", .places = places, .bounds = places, .former = nullptr};
}

std::string short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string counted(std::uint64_t count, const std::string& noun) {
  return with_commas(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace sightline::viz
