#include "viz/csg_trace.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "sightline/csg/evaluator.h"
#include "viz/csg_light.h"

namespace sightline::viz {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t no_face = 0xffff'ffff;

std::uint32_t key_of(const Boundary& boundary) { return boundary.primitive * 64 + boundary.face % 64; }

/// What one ray sees of one solid.
struct Sight {
  double t = infinity;
  std::uint32_t key = no_face;
  float facing = 0;  ///< Cosine between view and normal.
};

struct GhostSight {
  Sight front, back;
};

std::vector<Aabb> bounded_boxes(const LadderSolid& solid) {
  std::vector<Aabb> boxes;
  for (const Solid& part : solid.parts()) {
    if (part.is_bounded() && !part.bounds().is_empty()) boxes.push_back(part.bounds());
  }
  if (boxes.empty()) boxes.push_back({Vec3f(-1), Vec3f(1)});
  return boxes;
}

/// Where a line is within a box; empty where it never is.
Interval<double> part_within(const Aabb& box, const Ray<double>& ray) {
  Interval<double> part{0, infinity};
  for (int i = 0; i < 3; ++i) {
    const double a = (box.lo[i] - ray.origin[i]) / ray.direction[i], b = (box.hi[i] - ray.origin[i]) / ray.direction[i];
    part = {std::fmax(part.lo, std::fmin(a, b)), std::fmin(part.hi, std::fmax(a, b))};
  }
  return part;
}

template <Level level>
class Tracing {
 public:
  Tracing(const LadderSolid& solid, const std::vector<std::uint32_t>& ghosts, const Camera& camera)
      : solid_(solid),
        ghosts_(ghosts),
        camera_(camera),
        scene_box_(scene_box(solid)),
        is_endless_(is_endless(solid)),
        width_(camera.width * side),
        height_(camera.height * side) {
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    light_.resize(pixels);
    sights_.resize(pixels);
    ghost_sights_.resize(pixels * ghosts.size());
    const Vec3d right = glm::normalize(camera.right), up = glm::normalize(camera.up);
    key_light_ = glm::normalize(-0.55 * right + 0.9 * up - 0.75 * camera.forward);
  }

  SolidView run() {
    tbb::parallel_for(0, height_, [&](int y) {
      for (int x = 0; x < width_; ++x) look(x, y);
    });
    tbb::parallel_for(0, height_, [&](int y) {
      for (int x = 0; x < width_; ++x) blend(x, y);
    });
    SolidView view{averaged(light_, camera_.width, camera_.height), {}};
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) view.depths.push_back(sights_[at(x * side, y * side)].t);
    }
    return view;
  }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  Ray<double> ray(int x, int y) const { return ray_through(camera_, (x + 0.5) / side, (y + 0.5) / side); }

  void look(int x, int y) {
    const Ray<double> ray = this->ray(x, y);
    NoSolidProbe probe;
    const std::size_t pixel = at(x, y);
    SolidEvaluator<level> evaluator(solid_.quick(), ray, probe);
    const double share = double(y) / height_;
    Vec3d light = Vec3d(0.955, 0.97, 0.985) - Vec3d(0.12, 0.11, 0.095) * share;
    const auto boundary = evaluator.first(0, infinity);
    if (!boundary && is_endless_) light = 0.45 * light + 0.55 * light_of(solid_, 0);
    if (boundary) {
      const Vec3d view = glm::normalize(ray.direction);
      Vec3d normal = solid_.quick().normal(*boundary, ray);
      if (glm::dot(normal, view) > 0) normal = -normal;
      sights_[pixel] = {boundary->t, key_of(*boundary), static_cast<float>(-glm::dot(normal, view))};
      light = shade(light_of(solid_, boundary->primitive), normal, view, ray.at(boundary->t));
    }
    light_[pixel] = Vec3f(light);
    const Interval<double> within = part_within(scene_box_, ray);
    for (std::size_t i = 0; i < ghosts_.size(); ++i) {
      const Solid& part = solid_.parts()[ghosts_[i]];
      SolidEvaluator<level> ghost(part, ray, probe);
      const SpanList list = ghost.spans({0, infinity});
      std::span<const Boundary> seen = ghost[list];
      if (!part.is_bounded()) {  // what goes on without end is cut off
        while (!seen.empty() && seen.front().t < within.lo) seen = seen.subspan(1);
        while (!seen.empty() && seen.back().t > within.hi) seen = seen.first(seen.size() - 1);
      }
      if (seen.empty()) continue;
      const auto sight = [&](const Boundary& b) -> Sight {
        return {b.t, b.face,
                static_cast<float>(std::fabs(glm::dot(part.normal(b, ray), glm::normalize(ray.direction))))};
      };
      ghost_sights_[pixel * ghosts_.size() + i] = {sight(seen.front()), sight(seen.back())};
    }
  }

  Vec3d shade(const Vec3d& color, const Vec3d& normal, const Vec3d& view, const Vec3d& point) const {
    const double sky = 0.5 + 0.5 * normal.y;
    double key = std::fmax(0, glm::dot(normal, key_light_));
    if (key > 0) {
      NoSolidProbe probe;
      // Lifted off the surface, by far more than the point is rounded and less than a pixel shows.
      const double lift = 1e-6 * (1 + max_norm(point));
      const Ray<double> shadow{point + lift * normal, key_light_};
      if (SolidEvaluator<level>(solid_.quick(), shadow, probe).first(0, infinity)) key *= 0.25;
    }
    const double head = -glm::dot(normal, view);
    const Vec3d half = glm::normalize(key_light_ - view);
    const double shine = 0.12 * std::pow(std::fmax(0, glm::dot(normal, half)), 40) * (key > 0);
    return color * (0.16 + 0.14 * sky + 0.62 * key + 0.24 * head) + Vec3d(shine);
  }

  /// Whether a neighbor shows another face.
  template <class Get>
  bool is_edge(int x, int y, Get&& get) const {
    const std::uint32_t key = get(at(x, y));
    return (x + 1 < width_ && get(at(x + 1, y)) != key) || (y + 1 < height_ && get(at(x, y + 1)) != key);
  }

  void blend(int x, int y) {
    const std::size_t pixel = at(x, y);
    Vec3d light(light_[pixel]);
    const Sight& seen = sights_[pixel];
    if (is_edge(x, y, [&](std::size_t p) { return sights_[p].key; })) light *= 0.45;
    for (std::size_t i = 0; i < ghosts_.size(); ++i) {
      const auto ghost_at = [&](std::size_t p) -> const GhostSight& { return ghost_sights_[p * ghosts_.size() + i]; };
      const Vec3d color = light_of(solid_, ghosts_[i]);
      for (const bool is_front : {false, true}) {
        const auto get = [&](std::size_t p) -> const Sight& { return is_front ? ghost_at(p).front : ghost_at(p).back; };
        const Sight& ghost = get(pixel);
        const bool is_hidden = !(ghost.t < seen.t * (1 - 1e-9));
        const bool is_line = !is_hidden && is_edge(x, y, [&](std::size_t p) { return get(p).key; });
        if (ghost.key == no_face || is_hidden) continue;
        const double rim = std::pow(1 - ghost.facing, 3);
        const double share = is_line ? (is_front ? 0.75 : 0.35) : (is_front ? 0.07 + 0.30 * rim : 0.03);
        light = light * (1 - share) + color * share;
      }
    }
    light_[pixel] = Vec3f(light);
  }

  const LadderSolid& solid_;
  const std::vector<std::uint32_t>& ghosts_;
  const Camera& camera_;
  Aabb scene_box_;
  bool is_endless_;
  int width_, height_;
  Vec3d key_light_;
  std::vector<Vec3f> light_;
  std::vector<Sight> sights_;
  std::vector<GhostSight> ghost_sights_;
};

}  // namespace

bool is_endless(const LadderSolid& solid) {
  const Solid& tree = solid.quick();
  if (tree.is_bounded()) return tree.root().is_complement;
  NoSolidProbe probe;
  const Ray<double> ray{{0, 0, 0}, {-0.62, 0.42, 1}};
  SolidEvaluator<Level::watertight> evaluator(tree, ray, probe);
  const SpanList list = evaluator.spans();
  return list.begins_inside != (list.count % 2 != 0);
}

Aabb scene_box(const LadderSolid& solid) {
  Aabb box;
  for (const Aabb& part : bounded_boxes(solid)) box.extend(part);
  const Vec3f size = box.hi - box.lo;
  const Vec3f margin(0.08f * std::max({size.x, size.y, size.z}));
  return {box.lo - margin, box.hi + margin};
}

Camera camera_for(const LadderSolid& solid, int width, int height) {
  constexpr double field_of_view = 28, share = 0.88;  // of the panel, by the boxes of the solid's parts
  const std::vector<Aabb> boxes = bounded_boxes(solid);
  Aabb extent;
  for (const Aabb& box : boxes) extent.extend(box);
  // Rays like to come from the left, and should be seen to arrive.
  const Vec3d middle = 0.5 * (Vec3d(extent.lo) + Vec3d(extent.hi)), toward_eye = glm::normalize(Vec3d(-0.62, 0.42, 1));
  const Camera near = Camera::looking_at(middle + toward_eye, middle, {0, 1, 0}, field_of_view, width, height);
  const double across = share * glm::length(near.right), upward = share * glm::length(near.up);
  const Vec3d right = glm::normalize(near.right), up = glm::normalize(near.up);
  double distance = 0;
  for (const Aabb& box : boxes) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d q = Vec3d((corner & 1) ? box.hi.x : box.lo.x, (corner & 2) ? box.hi.y : box.lo.y,
                            (corner & 4) ? box.hi.z : box.lo.z) -
                      middle;
      const double nearer = glm::dot(q, toward_eye);
      distance = std::max(
          {distance, nearer + std::fabs(glm::dot(q, right)) / across, nearer + std::fabs(glm::dot(q, up)) / upward});
    }
  }
  if (!(distance > 0)) distance = 1;
  return Camera::looking_at(middle + distance * toward_eye, middle, {0, 1, 0}, field_of_view, width, height);
}

Ray<double> ray_through(const Camera& camera, double x, double y) {
  const double across = 2 * x / camera.width - 1, upward = 1 - 2 * y / camera.height;
  return {camera.eye, glm::normalize(camera.forward + across * camera.right + upward * camera.up)};
}

SolidView trace_solid(const LadderSolid& solid, const std::vector<std::uint32_t>& ghosts, const Camera& camera,
                      Level level) {
  return with_level(level, [&]<Level l>() { return Tracing<l>(solid, ghosts, camera).run(); });
}

std::vector<std::uint32_t> primitives_to_show(const LadderSolid& solid, const Ladder& ladder, std::size_t count) {
  std::vector<std::uint32_t> chosen;
  for (const auto& [is_met, is_bounded] : {std::pair{true, true}, {true, false}, {false, true}, {false, false}}) {
    for (const LadderRow& row : ladder.rows) {
      if (row.kind != SolidTree::Kind::primitive || row.boundaries.empty() == is_met) continue;
      if (solid.parts()[row.primitive].is_bounded() != is_bounded) continue;
      if (chosen.size() < count) chosen.push_back(row.primitive);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace sightline::viz
