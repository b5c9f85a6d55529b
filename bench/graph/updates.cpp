#include <memory>

#include "bench/graph/run.h"
#include "bench/verify.h"
#include "sightline/math/random.h"
#include "sightline/scene/live_scene.h"

namespace sightline::bench {
namespace {

constexpr NodeId children = 8;

Transform random_place(Random& random, double size) {
  const auto number = [&] { return size * (2 * random.uniform_double() - 1); };
  return Transform::translation({number(), number(), number()}) *
         Transform::rotation(Vec3d(number(), number(), size), 360 * random.uniform_double());
}

/// Eight children a node, level by level, closer and closer; a box at each leaf.
std::shared_ptr<LiveScene> tree(std::size_t size) {
  Random random(1);
  Scene scene;
  scene.geometries.push_back({"box", SolidTree(solid::Box{{-0.1, -0.1, -0.5}, {0.1, 0.1, 0.5}})});
  double spread = 100;
  for (NodeId parent = 0; scene.graph.size() < size; ++parent) {
    if (parent > 0 && scene.graph.first_child(parent - 1) == parent) spread *= 0.5;
    for (NodeId i = 0; i < children && scene.graph.size() < size; ++i) {
      scene.graph.add(parent, "", random_place(random, spread));
    }
  }
  for (NodeId node = 0; node < scene.graph.size(); ++node) {
    if (scene.graph.first_child(node) == no_node) scene.graph.set_geometry(node, 0);
  }
  return std::make_shared<LiveScene>(std::move(scene));
}

void verify(LiveScene& live, BoundKind kind) {
  LiveScene fresh(live.scene());
  with_kind(kind, [&]<class V>(const V&) {
    for (NodeId node = 0; node < live.graph().size(); node += 7) {
      const V a = live.bounds<V>(node), b = fresh.bounds<V>(node);
      if (volume_of(a) == volume_of(b)) continue;
      throw WrongHits(std::string(name_of(kind)) + " is wrong, so no times are shown: node " + live.graph().path(node) +
                      ": expected the bounds of a new scene, found others");
    }
  });
}

}  // namespace

std::vector<GraphContender> update_contenders(const GraphPlan& plan) {
  std::vector<GraphContender> all;
  for (const std::size_t size : plan.sizes) {
    const auto live = tree(size);
    const auto random = std::make_shared<Random>(2);
    const auto change_leaf = [live, random] {
      const NodeId count = live->graph().size(), leaf = count - 1 - random->below(count / 2);
      live->set_local(leaf, random_place(*random, 0.5));
    };
    const auto add = [&](BoundKind kind, const std::string& name, const std::function<void()>& change) {
      const std::string table = count_text(size) + " nodes, " + std::string(name_of(kind));
      live->refresh(kind);
      const std::uint64_t before = live->counters().bounds;
      change();
      live->refresh(kind);
      const auto touched = static_cast<double>(live->counters().bounds - before);
      all.push_back({"updates",
                     table,
                     name,
                     [live, kind, change] {
                       change();
                       live->refresh(kind);
                     },
                     1,
                     {{"nodes", touched}}});
    };
    for (const BoundKind kind : bound_kinds) {
      add(kind, "all anew", [live] { live->set_local(root_node, {}); });
      add(kind, "one leaf", change_leaf);
      for (int i = 0; i < 20; ++i) change_leaf();
      verify(*live, kind);
    }
  }
  return all;
}

}  // namespace sightline::bench
