#include <memory>

#include "bench/graph/run.h"
#include "bench/verify.h"
#include "sightline/scene/live_scene.h"

namespace sightline::bench {
namespace {

constexpr NodeId leaves = 256;

Transform small_step(NodeId i) {
  return Transform::translation({0.5, 0.25, 0.125}) * Transform::rotation(Vec3d(1, 2, 3), 0.1 * (i % 100));
}

/// A chain, with leaves at its end: each has `depth` ancestors.
std::shared_ptr<LiveScene> chain(std::size_t depth) {
  Scene scene;
  NodeId node = root_node;
  for (std::size_t i = 1; i < depth; ++i) node = scene.graph.add(node, "", small_step(node));
  for (NodeId i = 0; i < leaves; ++i) scene.graph.add(node, "", small_step(i));
  return std::make_shared<LiveScene>(std::move(scene));
}

template <class Ask>
void ask_leaves(const LiveScene& live, const Ask& ask) {
  double sum = 0;
  for (NodeId node = live.graph().size() - leaves; node < live.graph().size(); ++node)
    sum += ask(node).matrix().rows[0][3];
  use(sum > 0);
}

}  // namespace

std::vector<GraphContender> world_contenders(const GraphPlan& plan) {
  std::vector<GraphContender> all;
  for (const std::size_t depth : plan.depths) {
    const auto live = chain(depth);
    for (NodeId node = 0; node < live->graph().size(); ++node) {
      if (live->world(node) == live->graph().world(node)) continue;
      throw WrongHits("cached is wrong, so no times are shown: node " + live->graph().path(node) +
                      ": expected the product of its ancestors' transforms, found another");
    }
    const std::string table = "depth " + std::to_string(depth);
    const auto add = [&](std::string name, std::function<void()> pass) {
      all.push_back({"worlds", table, std::move(name), std::move(pass), leaves, {}});
    };
    add("recomputed", [live] { ask_leaves(*live, [&](NodeId node) { return live->graph().world(node); }); });
    add("one traversal", [live] {
      double sum = 0;
      live->graph().for_each([&](NodeId, const Transform& world) { sum += world.matrix().rows[0][3]; });
      use(sum > 0);
    });
    add("cached, root moves", [live] {
      live->set_local(root_node, {});
      ask_leaves(*live, [&](NodeId node) { return live->world(node); });
    });
    add("cached, leaf moves", [live] {
      live->set_local(live->graph().size() - 1, small_step(0));
      ask_leaves(*live, [&](NodeId node) { return live->world(node); });
    });
    add("cached", [live] { ask_leaves(*live, [&](NodeId node) { return live->world(node); }); });
  }
  return all;
}

}  // namespace sightline::bench
