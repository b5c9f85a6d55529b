#include "viz/csg_picture.h"

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "sightline/csg/span_list.h"
#include "viz/csg_rows.h"
#include "viz/material_color.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

using Point = Canvas::Point;
using Align = Canvas::Align;

constexpr std::size_t most_ghosts = 14, most_outlines = 60;

std::string text_of(const Vec3d& v) {
  return "(" + short_text(v.x) + ", " + short_text(v.y) + ", " + short_text(v.z) + ")";
}

/// The ray over the solid's view: thick and in the solid's colors where it is inside, as if one could see it there.
class RayDrawing {
 public:
  RayDrawing(Canvas& canvas, const CsgLayout& layout, const LadderLayout& range, const LadderSolid& solid,
             const Ladder& ladder, const Camera& camera, const SolidView& view)
      : canvas_(canvas), range_(range), solid_(solid), ladder_(ladder), camera_(camera), view_(view) {
    const SolidPanel panel = layout.panel();
    unit_ = layout.unit();
    left_ = panel.x / unit_, top_ = panel.y / unit_;
  }

  void run() {
    const auto begin = project(range_.t_min), end = project(range_.t_max);
    if (begin && end && std::hypot(end->x - begin->x, end->y - begin->y) < 24) {
      draw_end_on(*begin);
      return;
    }
    draw_outside();
    const LadderRow& root = ladder_.rows.front();
    for_each_span(root.boundaries, root.begins_inside, [&](double lo, double hi, const Boundary* a, const Boundary* b) {
      const auto [enter, leave] = bar_colors(solid_, a, b);
      draw_inside(std::max(lo, range_.t_min), std::min(hi, range_.t_max), enter, leave);
    });
    for (const Boundary& boundary : root.boundaries) mark(boundary.t, 4, ink);
    if (range_.has_origin) mark_origin();
    if (ladder_.hit) draw_hit();
    draw_tip();
  }

 private:
  static constexpr int pieces = 160;

  /// In units; none outside of the panel or behind the eye.
  std::optional<Point> project(double t) const {
    const Vec3d q = ladder_.ray.at(t) - camera_.eye;
    const double depth = glm::dot(q, camera_.forward);
    if (!(depth > 1e-9)) return std::nullopt;
    const double across = glm::dot(q, camera_.right) / glm::dot(camera_.right, camera_.right) / depth;
    const double upward = glm::dot(q, camera_.up) / glm::dot(camera_.up, camera_.up) / depth;
    if (!(std::fabs(across) < 1) || !(std::fabs(upward) < 1)) return std::nullopt;
    return Point{left_ + (across + 1) / 2 * camera_.width / unit_, top_ + (1 - upward) / 2 * camera_.height / unit_};
  }

  bool is_hidden(double t, const Point& at) const {
    const int x = std::clamp(static_cast<int>((at.x - left_) * unit_), 0, camera_.width - 1);
    const int y = std::clamp(static_cast<int>((at.y - top_) * unit_), 0, camera_.height - 1);
    const double distance = glm::length(ladder_.ray.at(t) - camera_.eye);
    return view_.depths[static_cast<std::size_t>(y) * camera_.width + x] < distance * 0.999;
  }

  double at(int piece) const { return range_.t_min + (range_.t_max - range_.t_min) * piece / pieces; }

  void draw_outside() {
    for (int i = 0; i < pieces; ++i) {
      const auto from = project(at(i)), to = project(at(i + 1));
      if (!from || !to) continue;
      const bool is_behind = range_.has_origin && at(i) < 0;
      if (is_hidden(0.5 * (at(i) + at(i + 1)), *to)) {
        if (i % 4 < 2) canvas_.line(*from, *to, 1.6, ink, 0.45);
      } else {
        canvas_.line(*from, *to, is_behind ? 1.2 : 2.2, ink, is_behind ? 0.4 : 1);
      }
    }
  }

  void draw_inside(double lo, double hi, const Rgb& enter, const Rgb& leave) {
    for (const bool is_casing : {true, false}) {
      for (int i = 0; i < pieces; ++i) {
        const double share = double(i) / pieces;
        const auto from = project(lo + (hi - lo) * share), to = project(lo + (hi - lo) * (share + 1.0 / pieces));
        if (!from || !to) continue;
        Rgb color{1, 1, 1};
        for (std::size_t c = 0; c < 3 && !is_casing; ++c) color[c] = enter[c] + (leave[c] - enter[c]) * share;
        canvas_.line(*from, *to, is_casing ? 11 : 7, color);
      }
    }
  }

  void mark(double t, double radius, const Rgb& color) {
    if (const auto place = project(t)) {
      canvas_.disc(*place, radius + 1.5, {1, 1, 1});
      canvas_.disc(*place, radius, color);
    }
  }

  void mark_origin() {
    if (const auto place = project(0)) {
      mark(0, 4.5, ink);
      const bool has_room = place->x > left_ + 70;
      const Canvas::TextStyle style{13, ink, has_room ? Align::right : Align::center, true};
      canvas_.text(has_room ? Point{place->x - 11, place->y + 1} : Point{std::max(place->x, left_ + 24), place->y + 19},
                   "t = 0", style);
    }
  }

  void draw_hit() {
    const auto place = project(ladder_.hit->boundary.t);
    if (!place) return;
    canvas_.ring(*place, 9.5, 5, {1, 1, 1});
    canvas_.ring(*place, 9.5, 3, accent);
    if (const auto tip = to_screen(ladder_.hit->normal, ladder_.hit->boundary.t)) {
      const double x = tip->x - place->x, y = tip->y - place->y, length = std::hypot(x, y);
      if (length < 8) return;
      canvas_.line({place->x + 11 * x / length, place->y + 11 * y / length}, *tip, 2.4, accent);
      canvas_.arrow_head({tip->x + 5 * x / length, tip->y + 5 * y / length}, std::atan2(y, x), 11, accent);
    }
  }

  /// Where a step from the ray's point at t ends.
  std::optional<Point> to_screen(const Vec3d& normal, double t) const {
    const double depth = glm::dot(ladder_.ray.at(t) - camera_.eye, camera_.forward);
    const double length = 46 * unit_ / (0.5 * camera_.height) * glm::length(camera_.up) * depth;
    const Vec3d q = ladder_.ray.at(t) + length * normal - camera_.eye;
    const double far = glm::dot(q, camera_.forward);
    if (!(far > 0)) return std::nullopt;
    return Point{
        left_ +
            (glm::dot(q, camera_.right) / glm::dot(camera_.right, camera_.right) / far + 1) / 2 * camera_.width / unit_,
        top_ + (1 - glm::dot(q, camera_.up) / glm::dot(camera_.up, camera_.up) / far) / 2 * camera_.height / unit_};
  }

  void draw_tip() {
    for (int i = pieces; i > 0; --i) {
      const auto tip = project(at(i)), before = project(at(i - 1));
      if (!tip || !before) continue;
      canvas_.arrow_head(*tip, std::atan2(tip->y - before->y, tip->x - before->x), 14, ink);
      return;
    }
  }

  /// A ray that runs along the view is a point.
  void draw_end_on(const Point& place) {
    const Rgb color = ladder_.hit ? accent : ink;
    canvas_.ring(place, 10, 5, {1, 1, 1});
    canvas_.ring(place, 10, 2.6, color);
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      canvas_.line({place.x + 6 * x, place.y + 6 * y}, {place.x + 20 * x, place.y + 20 * y}, 2, color);
    }
    const Canvas::TextStyle style{13, color, Align::center, true};
    const std::string text = "the ray, from its origin";
    const double half = canvas_.text_width(text, style) / 2 + 7, y = place.y + 36;
    const double x = std::clamp(place.x, left_ + half + 4, left_ + camera_.width / unit_ - half - 4);
    canvas_.rectangle({x - half, y - 11}, 2 * half, 22, {1, 1, 1}, 0.88);
    canvas_.text({x, y}, text, style);
  }

  Canvas& canvas_;
  const LadderLayout& range_;
  const LadderSolid& solid_;
  const Ladder& ladder_;
  const Camera& camera_;
  const SolidView& view_;
  double unit_, left_, top_;
};

/// Of unit length, at right angles to the ray, as near to the picture's up as can be.
Vec3d up_of(const Vec3d& direction, const Camera& camera) {
  const Vec3d along = glm::normalize(direction);
  for (const Vec3d& wanted : {Vec3d(0, 1, 0), glm::normalize(camera.up), glm::normalize(camera.right)}) {
    const Vec3d up = wanted - glm::dot(wanted, along) * along;
    if (glm::length(up) > 0.2) return glm::normalize(up);
  }
  return {1, 0, 0};
}

void draw_frame(Canvas& canvas, Point at, double width, double height) {
  const Rgb color{0.80, 0.82, 0.86};
  const Point b{at.x + width, at.y}, c{at.x + width, at.y + height}, d{at.x, at.y + height};
  canvas.line(at, b, 1, color), canvas.line(b, c, 1, color), canvas.line(c, d, 1, color), canvas.line(d, at, 1, color);
}

void draw_materials(Canvas& canvas, const CsgLayout& layout, const LadderSolid& solid) {
  std::set<std::string> seen;
  double x = CsgLayout::margin;
  const double y = layout.height() - CsgLayout::bottom + 34;
  const Canvas::TextStyle style{13.5, ink};
  for (std::uint32_t i = 0; i < solid.plain().primitives().size(); ++i) {
    const std::string& material = solid.material(i);
    if (material.empty() || !seen.insert(material).second) continue;
    const double width = canvas.text_width(material, style) + 42;
    if (x + width > layout.tree_left() - CsgLayout::margin) break;
    canvas.rectangle({x, y - 8}, 16, 16, material_color(material, i));
    canvas.text({x + 22, y}, material, style);
    x += width;
  }
  canvas.text({CsgLayout::margin, y + 27},
              is_endless(solid) ? "The solid goes on without end: it is seen from within, as far as its holes"
                                : "The solid, its operands as ghosts, and the ray: thick where it is inside the solid",
              {13.5, soft_ink});
}

}  // namespace

std::optional<Ray<double>> ray_through_pixel(const LadderSolid& solid, int width, int height, int x, int y) {
  const SolidPanel panel = CsgLayout(width, height).panel();
  x -= panel.x, y -= panel.y;
  if (x < 0 || x >= panel.width || y < 0 || y >= panel.height) return std::nullopt;
  return ray_through(camera_for(solid, panel.width, panel.height), x + 0.5, y + 0.5);
}

void CsgPicture::show_in(vtkRenderWindow& window, int scale) const {
  const CsgLayout layout(width, height);
  const LadderLayout rows = lay_out(layout, ladder, solid);
  Canvas canvas(layout.height(), layout.unit() * scale);
  const SolidPanel panel = layout.panel();
  const double pixel = 1 / layout.unit();

  canvas.text({CsgLayout::margin, 36}, name, {27, ink, Align::left, true});
  const double title = canvas.text_width(name, {27, ink, Align::left, true});
  canvas.text({CsgLayout::margin + title + 16, 38}, description, {17, soft_ink});
  std::string line = "ray  " + text_of(ladder.ray.origin) + " + t " + text_of(ladder.ray.direction) + ",  precision " +
                     std::string(info_of(ladder.level).name);
  canvas.text({CsgLayout::margin, 70}, line, {15, soft_ink});
  const Canvas::TextStyle verdict{15, ladder.hit ? accent : ink, Align::left, true};
  if (ladder.hit) {
    const std::string& material = solid.material(ladder.hit->boundary.primitive);
    line = "hit at t = " + short_text(ladder.hit->boundary.t) + (material.empty() ? "" : " on " + material) +
           ", point " + text_of(ladder.hit->point) + ", normal " + text_of(ladder.hit->normal);
  } else {
    line = "no hit: nothing of the solid begins or ends at t >= 0";
  }
  canvas.text({layout.tree_left(), 70}, line, verdict);

  const Camera camera = camera_for(solid, panel.width, panel.height);
  const SolidView view = trace_solid(solid, primitives_to_show(solid, ladder, most_ghosts), camera, ladder.level);
  canvas.image({panel.x * pixel, panel.y * pixel}, view.colors, pixel);
  draw_frame(canvas, {panel.x * pixel, panel.y * pixel}, panel.width * pixel, panel.height * pixel);
  RayDrawing(canvas, layout, rows, solid, ladder, camera, view).run();
  draw_materials(canvas, layout, solid);

  const double bars = layout.bars_right() - layout.bars_left();
  const int across = static_cast<int>(std::lround(bars * layout.unit()));
  const int down = static_cast<int>(std::lround(rows.section_height * layout.unit()));
  const SectionPlane plane{rows.t_min, rows.t_max, up_of(ladder.ray.direction, camera)};
  const ColorGrid section = trace_section(solid, primitives_to_show(solid, ladder, most_outlines), ladder.ray, plane,
                                          across, down, ladder.level);
  canvas.image({layout.bars_left(), CsgLayout::top}, section, pixel);
  draw_frame(canvas, {layout.bars_left(), CsgLayout::top}, bars, rows.section_height);
  draw_rows(canvas, layout, rows, ladder, solid);
  const double middle = CsgLayout::top + rows.section_height / 2;
  canvas.line({layout.bars_left(), middle}, {layout.bars_right(), middle}, 2, ink);
  canvas.arrow_head({layout.bars_right() + 2, middle}, 0, 13, ink);
  canvas.text({layout.tree_left(), CsgLayout::top + 10}, "cut open along the ray", {15, ink, Align::left, true});
  canvas.text({layout.tree_left(), CsgLayout::top + 31}, "t runs to the right, as below;", {13.5, soft_ink});
  canvas.text({layout.tree_left(), CsgLayout::top + 48}, "thick: the solid's boundary,", {13.5, soft_ink});
  canvas.text({layout.tree_left(), CsgLayout::top + 65}, "fine: its operands'", {13.5, soft_ink});
  if (!rows.has_origin) {
    canvas.text({layout.bars_left() - 8, middle},
                std::string("t = 0 is far to the ") + (rows.t_min > 0 ? "left" : "right"),
                {13, soft_ink, Align::right});
  }
  draw_legend(canvas, layout, ladder);

  window.GetRenderers()->RemoveAllItems();
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  canvas.add_to(*renderer);
  window.AddRenderer(renderer);
}

void CsgPicture::write_png(const std::filesystem::path& path) const {
  constexpr int oversampling = 2;
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * oversampling, height * oversampling);
  show_in(*window, oversampling);
  window->Render();
  write_window(*window, oversampling, path);
}

}  // namespace sightline::viz
