#include "viz/compare/compare_picture.h"

#include <vtkRendererCollection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "viz/compare/compare_legend.h"
#include "viz/compare/work_maps.h"
#include "viz/heat_map.h"
#include "viz/partition_picture.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

using Align = Canvas::Align;

constexpr double text_size = CompareLegend::text_size, title_size = 23;

std::string decimal(double number, bool has_sign = false) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), has_sign ? "%+.1f" : "%.1f", number);
  return text.data();
}

void draw_border(Canvas& canvas, const PanelFrame& f) {
  const Rgb color{0.80, 0.82, 0.87};
  const Canvas::Point a{f.x, f.y}, b{f.x + f.width, f.y}, c{f.x + f.width, f.y + f.height}, d{f.x, f.y + f.height};
  canvas.line(a, b, 1, color), canvas.line(b, c, 1, color), canvas.line(c, d, 1, color), canvas.line(d, a, 1, color);
}

void draw_head(Canvas& canvas, const PanelFrame& panel, const std::string& title, const std::string& text) {
  const Canvas::TextStyle head{title_size, ink, Align::left, true}, body{text_size, soft_ink};
  canvas.text({panel.x, panel.y + 14}, canvas.shortened(title, head, panel.width), head);
  canvas.text({panel.x, panel.y + 43}, canvas.shortened(text, body, panel.width), body);
}

std::string walk_text(const Walk& walk) {
  const TraversalStats stats = walk.statistics();
  std::string text = counted(stats.nodes, "node", "nodes") + ", " + counted(stats.leaves, "leaf", "leaves") + ", " +
                     counted(stats.candidates, "candidate", "candidates");
  if (stats.culled > 0) text += ", " + with_commas(stats.culled) + " culled";
  return text;
}

/// One of its kinds, drawn panel by panel onto two canvases: one under the renderers that it adds, one over them.
class Drawing {
 public:
  Drawing(const ComparePicture& picture, double scale)
      : picture_(picture),
        layout_(picture.layout()),
        place_{layout_.unit() * scale, layout_.width(), layout_.height()},
        paper_(layout_.height(), place_.scale),
        over_(layout_.height(), place_.scale) {}

  void draw() {
    draw_title();
    switch (picture_.look.kind) {
      case CompareKind::walk:
        draw_walks();
        break;
      case CompareKind::work:
        draw_work();
        break;
      case CompareKind::difference:
        draw_differences();
        break;
      case CompareKind::histogram:
        draw_histograms();
        break;
    }
    const Canvas::TextStyle style{text_size, soft_ink};
    const double room = layout_.width() - 2 * CompareLayout::margin;
    const std::string line = command_line(picture_.source, picture_.look, picture_.width, picture_.height);
    paper_.text({CompareLayout::margin, layout_.command_line()}, paper_.shortened(line, style, room), style);
  }

  void show_in(vtkRenderWindow& window) const {
    window.GetRenderers()->RemoveAllItems();
    window.SetNumberOfLayers(5);
    auto back = vtkSmartPointer<vtkRenderer>::New();
    back->SetBackground(1, 1, 1);
    back->InteractiveOff();
    paper_.add_to(*back);
    window.AddRenderer(back);
    for (const auto& renderer : renderers_) window.AddRenderer(renderer);
    auto front = vtkSmartPointer<vtkRenderer>::New();
    front->SetLayer(4);
    front->InteractiveOff();
    over_.add_to(*front);
    window.AddRenderer(front);
  }

 private:
  const CompareLook& look() const { return picture_.look; }
  const TriangleMesh& mesh() const { return picture_.compared.front().tracer->mesh(); }
  const CompareFindings& findings() const { return picture_.findings; }
  const std::string& label(std::size_t i) const { return picture_.compared[i].label; }
  LegendBar legend_bar(double left) const {
    return {left, layout_.legend_line() - 16, layout_.width() - CompareLayout::margin - left - 30};
  }

  void draw_title() {
    const std::string what[] = {"one ray's walk", "work per ray", "differences of work per ray", "work per ray"};
    const Verdict verdict = verdict_of(picture_.compared, findings());
    const Canvas::TextStyle bold{29, ink, Align::left, true};
    const double room = layout_.width() - 2 * CompareLayout::margin;
    const std::string title = picture_.source.scene + ": " + what[static_cast<std::size_t>(look().kind)];
    paper_.text({CompareLayout::margin, CompareLayout::title_line}, paper_.shortened(title, bold, room), bold);
    const std::string text = picture_.compared.size() > 1
                                 ? verdict.text
                                 : "each pixel: the " + std::string(unit_of(look().work)) + " of its ray";
    const Canvas::TextStyle style{20, verdict.is_same ? soft_ink : accent, Align::left, !verdict.is_same};
    paper_.text({CompareLayout::margin, CompareLayout::verdict_line}, paper_.shortened(text, style, room), style);
  }

  void draw_walks() {
    std::size_t most = 1;
    for (const Walk& walk : findings().walks) most = std::max(most, openings(walk).size());
    const ComparedSpace space{mesh(), picture_.surface, picture_.camera(), most};
    for (std::size_t i = 0; i < picture_.shown().size(); ++i) {
      const std::size_t which = picture_.shown()[i];
      const Walk& walk = findings().walks[which];
      draw_head(paper_, layout_.panels()[i], label(which), walk_text(walk));
      const PanelFrame frame = layout_.units(layout_.pictures()[i]);
      for (const auto& renderer : space.renderers(walk, frame, place_, 0)) renderers_.push_back(renderer);
      draw_hit(walk, frame);
      draw_border(over_, frame);
      draw_close(space, walk, frame);
    }
    CompareLegend legend(paper_, CompareLayout::margin, layout_.legend_line());
    legend.turns(most);
    legend.line(opening_color(1, 4), 1.5, 0, "inner");
    legend.line(opening_color(2, 4), 3.4, 0, "leaf");
    legend.line(culled_color, 2, 4, "culled");
    legend.box(tested_color, "candidate tested");
    legend.box(hit_color, "hit");
    legend.line(ink, 3.4, 0, "ray");
    legend.line(soft_ink, 1.6, 10, "beyond its hit");
  }

  void draw_hit(const Walk& walk, const PanelFrame& frame) {
    const auto place = picture_.place_of_hit(walk, frame);
    if (!place) return;
    over_.ring(*place, 8.5, 5, {1, 1, 1});
    over_.ring(*place, 8.5, 2.6, hit_color);
  }

  /// What is around the hit, larger.
  void draw_close(const ComparedSpace& space, const Walk& walk, const PanelFrame& frame) {
    const auto inset = picture_.inset_in(walk, frame);
    if (!inset) return;
    ComparedSpace close = space;
    close.camera = inset->camera;
    for (const auto& renderer : close.renderers(walk, inset->frame, place_, 2)) renderers_.push_back(renderer);
    draw_border(over_, inset->frame);
    const Vec3d hit = point_of_hit(walk);
    const double factor =
        space.camera.half_height_at(hit) / close.camera.half_height_at(hit) * inset->frame.height / frame.height;
    over_.rectangle({inset->frame.x, inset->frame.y}, 52, 27, {1, 1, 1}, 0.85);
    over_.text({inset->frame.x + 8, inset->frame.y + 14}, std::to_string(std::lround(factor)) + " x", {18, ink});
  }

  void draw_map(std::size_t i, const ColorGrid& map) {
    const PanelFrame frame = layout_.units(layout_.pictures()[i]);
    paper_.image({frame.x, frame.y}, map, findings().pixel_size / layout_.unit());
    draw_hit(findings().walks[picture_.shown()[i]], frame);
    draw_border(over_, frame);
  }

  void draw_work() {
    std::vector<std::vector<std::uint32_t>> works;
    double highest = 10;
    for (const TracedPicture& traced : findings().traced) {
      works.push_back(work_of(traced, look().work));
      highest = std::max(highest, viz::scale_for(std::span<const std::uint32_t>(works.back())));
    }
    for (std::size_t i = 0; i < picture_.shown().size(); ++i) {
      const std::size_t which = picture_.shown()[i];
      const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(works[which]));
      draw_head(paper_, layout_.panels()[i], label(which),
                "mean " + decimal(s.mean()) + ", median " + with_commas(s.median) + ", 99 % below " +
                    with_commas(s.percentile_99 + 1) + ", most " + with_commas(s.highest));
      draw_map(i, work_map(works[which], findings().camera.width, findings().camera.height, highest));
    }
    CompareLegend legend(paper_, CompareLayout::margin, layout_.legend_line() - 7);
    legend.text(std::string(unit_of(look().work)) + " per ray", true);
    legend.box({0, 0, 0}, "none");
    draw_work_legend(paper_, legend_bar(legend.x() + 20), highest);
  }

  void draw_differences() {
    const std::vector<std::uint32_t> base = work_of(findings().traced[look().against], look().work);
    std::vector<std::vector<std::int64_t>> all;
    double scale = 10;
    for (const TracedPicture& traced : findings().traced) {
      all.push_back(differences(work_of(traced, look().work), base));
      scale = std::max(scale, viz::scale_for(std::span<const std::int64_t>(all.back())));
    }
    for (std::size_t i = 0; i < picture_.shown().size(); ++i) {
      const std::size_t which = picture_.shown()[i];
      if (which == look().against) {
        draw_reference(i, base);
        continue;
      }
      const DifferenceStatistics s = statistics_of(std::span<const std::int64_t>(all[which]));
      const auto share = [&](std::uint64_t rays) { return decimal(100 * double(rays) / double(s.rays())) + " %"; };
      draw_head(
          paper_, layout_.panels()[i], label(which) + " minus " + label(look().against),
          "mean " + decimal(s.mean(), true) + "; fewer at " + share(s.less) + " of rays, more at " + share(s.more));
      draw_map(i, difference_map(all[which], findings().camera.width, findings().camera.height, scale));
    }
    CompareLegend legend(paper_, CompareLayout::margin, layout_.legend_line() - 7);
    legend.text("difference in " + std::string(unit_of(look().work)) + " per ray", true);
    draw_difference_legend(paper_, legend_bar(legend.x() + 20), scale);
  }

  /// What others are compared with has no difference to show: instead, what the rays see.
  void draw_reference(std::size_t i, const std::vector<std::uint32_t>& work) {
    const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(work));
    draw_head(paper_, layout_.panels()[i], label(look().against) + ": what others are compared with",
              "mean " + decimal(s.mean()) + ", median " + with_commas(s.median) + "; here, what the rays see");
    const Image image = shaded_picture(mesh(), findings().camera, findings().traced[look().against].hits);
    ColorGrid grid{image.width, image.height, {}};
    for (const float light : image.pixels) {
      grid.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(light))));
    }
    draw_map(i, grid);
  }

  void draw_histograms() {
    sheet_ = picture_.histograms();
    for (std::size_t i = 0; i < sheet_.panels.size(); ++i) {
      draw_head(paper_, layout_.panels()[i], sheet_.panels[i].title, sheet_.panels[i].text);
    }
    auto renderer = sheet_.renderer(place_);
    renderer->SetLayer(1);
    renderers_.push_back(renderer);
    CompareLegend legend(paper_, CompareLayout::margin, layout_.legend_line() + 8);
    legend.text(std::string(unit_of(look().work)) + " per ray", true);
    legend.text(
        "bins: 0, 1, 2, 3, then four a doubling, labelled where they begin; gray: no work, cut off; marked: the "
        "median, and what 99 % of rays do not exceed");
  }

  const ComparePicture& picture_;
  CompareLayout layout_;
  PartPlace place_;
  Canvas paper_, over_;
  HistogramSheet sheet_;  ///< What its renderer refers to.
  std::vector<vtkSmartPointer<vtkRenderer>> renderers_;
};

}  // namespace

HistogramSheet ComparePicture::histograms() const {
  const CompareLayout places = layout();
  HistogramSheet sheet{
      source.scene + ": work per ray", look.work == WorkKind::all ? "steps" : std::string(unit_of(look.work)), {}};
  std::uint32_t highest = 10;
  std::vector<std::vector<std::uint32_t>> works;
  for (const TracedPicture& traced : findings.traced) {
    works.push_back(work_of(traced, look.work));
    highest = std::max(highest, statistics_of(std::span<const std::uint32_t>(works.back())).highest);
  }
  for (std::size_t i = 0; i < shown().size(); ++i) {
    const std::size_t which = shown()[i];
    const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(works[which]));
    const double idle = 100 * double(s.idle) / double(std::max<std::uint64_t>(s.rays, 1));
    sheet.panels.push_back({compared[which].label,
                            "mean " + decimal(s.mean()) + ", most " + with_commas(s.highest) + "; none at " +
                                decimal(idle) + " % of rays, median of the others " + with_commas(s.busy_median),
                            histogram_of(works[which], highest), s, places.units(places.pictures()[i])});
  }
  return sheet;
}

void ComparePicture::show_in(vtkRenderWindow& window, int scale) const {
  Drawing drawing(*this, scale);
  drawing.draw();
  drawing.show_in(window);
}

void ComparePicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, width, height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

}  // namespace sightline::viz
