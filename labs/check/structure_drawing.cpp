#include <algorithm>
#include <map>
#include <set>

#include "labs/check/structure_checks.h"
#include "labs/check/structure_scene.h"
#include "labs/kit/structure_questions.h"
#include "sightline/math/random.h"

namespace sightline::labs {
namespace {

Point3 point_of(const Vec3f& p) { return {p.x, p.y, p.z}; }

/// Cells with the order in which a walk came to them; those that it never touched only where `is_every`.
void add_cells(SpacePanel& panel, const std::vector<Cell>& cells, const RecordedWalk& walk, bool is_every) {
  std::set<std::uint32_t> leaves;
  for (const Cell& cell : cells) {
    if (cell.is_leaf) leaves.insert(cell.node);
  }
  std::map<std::uint32_t, int> orders;
  int next = 0;
  for (const auto& step : walk.steps) {
    const bool is_leaf = step.event != WalkRecorder::Event::cull && leaves.contains(step.node);
    if (is_leaf && orders.emplace(step.node, next).second) ++next;
  }
  for (const Cell& cell : cells) {
    if (!cell.is_leaf) continue;
    const auto found = orders.find(cell.node);
    const int order = found == orders.end() ? -1 : found->second;
    if (order < 0 && !is_every) continue;
    const std::string label = order < 0 ? "" : std::to_string(order);
    if (const auto* box = std::get_if<Aabb>(&cell.region)) {
      panel.boxes.push_back({point_of(box->lo), point_of(box->hi), Role::cell, order, label});
    } else if (const auto* ball = std::get_if<Sphere>(&cell.region)) {
      panel.balls.push_back({point_of(ball->center), ball->radius, Role::cell, order, label});
    } else if (const auto* solid = std::get_if<Polyhedron>(&cell.region)) {
      for (const auto& face : solid->faces) {
        SpacePanel::Line outline{{}, Role::cell, false, ""};
        for (std::size_t i = 0; i <= face.size(); ++i) {
          const Vec3d& p = solid->vertices.at(face[i % face.size()]);
          outline.points.push_back({p.x, p.y, p.z});
        }
        panel.lines.push_back(std::move(outline));
      }
    }
  }
}

void add_triangles(SpacePanel& panel, const std::vector<Triangle>& triangles, std::uint32_t missed, bool has_labels) {
  for (std::uint32_t id = 0; id < triangles.size(); ++id) {
    const Triangle& t = triangles[id];
    panel.triangles.push_back({{point_of(t.a), point_of(t.b), point_of(t.c)},
                               id == missed ? Role::missed : Role::scene,
                               has_labels ? std::to_string(id) : ""});
  }
}

Aabb bounds_of_all(const SmallScene& scene) {
  Aabb box;
  for (const Triangle& triangle : scene.triangles) box.extend(bounds_of(triangle));
  if (box.is_empty()) box.extend(scene.ray.origin);
  return box;
}

/// From the origin to where the ray leaves the scene's neighborhood.
void add_ray(SpacePanel& panel, const SmallScene& scene) {
  const Aabb box = bounds_of_all(scene);
  const float size = std::max(max_norm(box.extent()), 1e-3f);
  const float far = glm::distance(scene.ray.origin, box.center()) + size;
  const Vec3f end = scene.ray.origin + far / glm::length(scene.ray.direction) * scene.ray.direction;
  panel.lines.push_back({{point_of(scene.ray.origin), point_of(end)}, Role::ray, true, "ray"});
}

}  // namespace

Drawing draw_walk(const SmallScene& scene, Subject& subject) {
  build(subject, scene.triangles, true);
  const auto cells = subject.ask<std::vector<Cell>>("cells");
  const auto walk = subject.ask<RecordedWalk>("record", scene.ray);
  const std::vector rays{scene.ray};
  const Hit<float> truth = true_hits<float>(scene.triangles, rays).front();
  SpacePanel panel;
  const bool is_missed = truth.is_hit() && walk.hit.prim_id != truth.prim_id;
  add_triangles(panel, scene.triangles, is_missed ? truth.prim_id : no_primitive, scene.triangles.size() <= 24);
  add_cells(panel, cells, walk, true);
  add_ray(panel, scene);
  if (truth.is_hit()) panel.dots.push_back({point_of(scene.ray.at(truth.t)), Role::right, "expected"});
  if (walk.hit.is_hit() && walk.hit.prim_id != truth.prim_id) {
    panel.dots.push_back({point_of(scene.ray.at(walk.hit.t)), Role::wrong, "got"});
  }
  return {"A ray's walk",
          "Leaves are numbered in the order in which the walk came to them; those without a number it never touched.",
          {{"", std::move(panel)}}};
}

Drawing picture_of_structure(Subject& subject) {
  SmallScene scene;
  Random random(11);
  for (int i = 0; i < 260; ++i) {
    const float angle = random.uniform(0.0f, 6.2831853f), height = random.uniform(-1.0f, 1.0f);
    const float ring = 0.4f + 0.6f * std::sqrt(1 - height * height);
    const Vec3f at{ring * std::cos(angle), height, ring * std::sin(angle)};
    const auto near = [&] {
      const float x = random.uniform(-0.1f, 0.1f), y = random.uniform(-0.1f, 0.1f), z = random.uniform(-0.1f, 0.1f);
      return at + Vec3f(x, y, z);
    };
    const Vec3f a = near(), b = near(), c = near();
    scene.triangles.push_back({a, b, c});
  }
  scene.ray = {{-1.8f, 0.3f, 0.2f}, {1, -0.12f, -0.1f}};
  Drawing drawing = draw_walk(scene, subject);
  auto& panel = std::get<SpacePanel>(drawing.panels.front().content);
  std::erase_if(panel.boxes, [](const SpacePanel::Box& box) { return box.order < 0; });
  std::erase_if(panel.balls, [](const SpacePanel::Ball& ball) { return ball.order < 0; });
  const auto facts = build(subject, scene.triangles);
  drawing.title = facts.name + " finds its way";
  return drawing;
}

}  // namespace sightline::labs
