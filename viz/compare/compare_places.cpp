/// Where things are in a comparison's picture.

#include <cmath>
#include <numeric>

#include "viz/compare/compare_picture.h"

namespace sightline::viz {

Vec3d point_of_hit(const Walk& walk) { return Vec3d(walk.ray.origin) + double(walk.hit.t) * Vec3d(walk.ray.direction); }

std::vector<std::size_t> ComparePicture::shown() const {
  if (look.alone) return {*look.alone};
  std::vector<std::size_t> all(compared.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

SpaceCamera ComparePicture::camera() const {
  const CompareLayout places = layout();
  const PixelFrame& frame = places.pictures().front();
  return camera_for(compared.front().tracer->mesh(), look, double(frame.width) / frame.height);
}

std::optional<Canvas::Point> ComparePicture::place_of_hit(const Walk& walk, const PanelFrame& frame) const {
  if (!walk.hit.is_hit()) return std::nullopt;
  const auto seen = camera().project(point_of_hit(walk));
  if (!seen || std::fabs(seen->x) > 1 || std::fabs(seen->y) > 1) return std::nullopt;
  return Canvas::Point{frame.x + (seen->x + 1) / 2 * frame.width, frame.y + (1 - seen->y) / 2 * frame.height};
}

/// In the corner that is farthest from the hit.
std::optional<CompareInset> ComparePicture::inset_in(const Walk& walk, const PanelFrame& frame) const {
  const auto hit = place_of_hit(walk, frame);
  if (!hit) return std::nullopt;
  const double across = 0.31 * frame.width, down = 0.42 * frame.height;
  const bool is_right = hit->x < frame.x + frame.width / 2, is_below = hit->y < frame.y + frame.height / 2;
  const PanelFrame inset{frame.x + (is_right ? frame.width - across : 0),
                         frame.y + (is_below ? frame.height - down : 0), across, down};
  return CompareInset{
      inset, close_camera(camera(), compared.front().tracer->mesh().bounds(), point_of_hit(walk), across / down)};
}

std::optional<Ray<float>> ComparePicture::ray_through_pixel(int x, int y) const {
  const CompareLayout places = layout();
  for (std::size_t i = 0; look.kind == CompareKind::walk && i < shown().size(); ++i) {
    const auto inset = inset_in(findings.walks[shown()[i]], places.units(places.pictures()[i]));
    if (!inset) continue;
    const double unit = places.unit(), right = ((x + 0.5) / unit - inset->frame.x) / inset->frame.width,
                 down = ((y + 0.5) / unit - inset->frame.y) / inset->frame.height;
    if (!(right >= 0 && right < 1 && down >= 0 && down < 1)) continue;
    const SpaceCamera& close = inset->camera;
    const double half = close.half_height_at(close.focus);
    const Vec3d toward =
        close.focus + half * ((2 * right - 1) * close.aspect * close.axes.x + (1 - 2 * down) * close.axes.y);
    return Ray<float>{Vec3f(close.eye), Vec3f(toward - close.eye)};
  }
  return viz::ray_through_pixel(compared.front().tracer->mesh(), look, places, x, y);
}

std::optional<Ray<float>> ray_through_pixel(const TriangleMesh& mesh, const CompareLook& look,
                                            const CompareLayout& layout, int x, int y) {
  for (const PixelFrame& f : layout.pictures()) {
    if (!f.contains(x, y)) continue;
    return tracing_camera(camera_for(mesh, look, double(f.width) / f.height), f.width, f.height).ray(x - f.x, y - f.y);
  }
  return std::nullopt;
}

}  // namespace sightline::viz
