#include "viz/graph/graph_picture.h"

#include <vtkRendererCollection.h>

#include <algorithm>

#include "viz/graph/tree_panel.h"
#include "viz/paper.h"
#include "viz/partition_picture.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

using Point = Canvas::Point;
using Align = Canvas::Align;

std::string text_of(const Vec3d& v) {
  return "(" + short_number(v.x) + ", " + short_number(v.y) + ", " + short_number(v.z) + ")";
}

void draw_border(Canvas& canvas, const PanelFrame& f) {
  const Rgb color{0.84, 0.86, 0.9};
  const Point a{f.x, f.y}, b{f.x + f.width, f.y}, c{f.x + f.width, f.y + f.height}, d{f.x, f.y + f.height};
  canvas.line(a, b, 1, color), canvas.line(b, c, 1, color), canvas.line(c, d, 1, color), canvas.line(d, a, 1, color);
}

/// From left to right, as far as there is room.
class Legend {
 public:
  Legend(Canvas& canvas, double y, double right) : canvas_(canvas), y_(y), right_(right) {}

  void text(const std::string& text) {
    const Canvas::TextStyle style{14, ink};
    const double width = canvas_.text_width(text, style);
    if (x_ + width <= right_) canvas_.text({x_, y_}, text, style);
    x_ += width + 26;
  }

  void depths(const GraphLook& look) {
    const Canvas::TextStyle style{14, ink};
    canvas_.text({x_, y_}, "depth", {14, ink, Align::left, true});
    x_ += canvas_.text_width("depth", {14, ink, Align::left, true}) + 12;
    constexpr std::uint32_t most = 10;
    const std::uint32_t step = 1 + look.deepest / most;
    for (std::uint32_t depth = 0; depth <= look.deepest; depth += step) {
      canvas_.rectangle({x_, y_ - 7}, 14, 14, color_of_depth(depth, look.deepest));
      const std::string number = std::to_string(depth);
      canvas_.text({x_ + 19, y_}, number, style);
      x_ += 19 + canvas_.text_width(number, style) + 11;
    }
    x_ += 18;
  }

  void line(const Rgb& color, double width, bool is_dashed, const std::string& meaning) {
    if (is_dashed) {
      canvas_.dashes({x_, y_}, {x_ + 38, y_}, width, 7, 6, color);
    } else {
      canvas_.line({x_, y_}, {x_ + 38, y_}, width, color);
    }
    x_ += 46;
    text(meaning);
  }

  void number(const std::string& meaning) {
    draw_number(canvas_, {x_ + 11, y_}, 2, false);
    x_ += 30;
    text(meaning);
  }

  void ring(const std::string& meaning) {
    canvas_.ring({x_ + 7, y_}, 5, 2, soft_ink);
    x_ += 22;
    text(meaning);
  }

 private:
  Canvas& canvas_;
  double x_ = GraphLayout::margin, y_, right_;
};

void draw_legend(Canvas& canvas, const GraphPicture& picture, const GraphLayout& layout) {
  Legend legend(canvas, layout.height() - 28, layout.width() - GraphLayout::margin + 4);
  legend.depths(picture.look);
  if (picture.frames.back().moved != no_node) {
    legend.number("the event's way up");
    legend.line(accent, 2, true, "stale bound");
    legend.line(ink, 2.6, false, "bound after");
    legend.line(soft_ink, 1.6, true, "before");
    legend.ring("moves along, is not told");
  } else if (picture.frames.size() > 1) {
    legend.line(soft_ink, 1.6, true, "bound in the frame before");
    legend.text("tinted rows: nodes that events pass");
  } else {
    legend.text("lines: the bound of a node and of all below it");
    if (picture.look.selected != root_node)
      legend.line(accent, 2.8, false, picture.drawn.graph.path(picture.look.selected));
  }
}

}  // namespace

SpaceCamera GraphPicture::camera() const {
  const PanelFrame space = layout().frames().front().space;
  return camera_for(drawn, frames, look, space.width / space.height);
}

std::vector<GraphSpace> GraphPicture::show_in(vtkRenderWindow& window, int scale,
                                              const std::optional<SpaceCamera>& fixed) const {
  const GraphLayout places = layout();
  const PartPlace part{places.unit() * scale, places.width(), places.height()};
  Canvas paper(places.height(), part.scale), over(places.height(), part.scale);

  const Canvas::TextStyle bold{27, ink, Align::left, true};
  paper.text({GraphLayout::margin, 36}, title, bold);
  paper.text({GraphLayout::margin + paper.text_width(title, bold) + 16, 38}, subtitle, {16, soft_ink});
  const Canvas::TextStyle strong{16, accent, Align::left, true};
  paper.text({GraphLayout::margin, 70}, paper.shortened(verdict, strong, places.width() - 2 * GraphLayout::margin),
             strong);

  const SpaceCamera camera = fixed ? *fixed : this->camera();
  std::vector<GraphSpace> spaces;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FramePlace& place = places.frames()[i];
    if (place.tree.width > 0) {
      const TreePanel tree(drawn, look.selected, place.tree);
      tree.draw(paper, has_one_tree ? frames.back() : frames[i], look);
    }
    const double x = has_one_tree ? place.space.x : place.tree.x;
    const Canvas::TextStyle head{17, ink, Align::left, true};
    const double room = place.space.x + place.space.width - x;
    paper.text({x, place.head}, paper.shortened(frames[i].title, head, room), head);
    paper.text({x, place.head + 20}, paper.shortened(frames[i].text, {13.5, soft_ink}, room), {13.5, soft_ink});
    spaces.push_back(space_of(drawn, frames[i], look, camera, place.space, part, over));
    draw_border(over, place.space);
  }
  draw_legend(paper, *this, places);

  window.GetRenderers()->RemoveAllItems();
  window.SetNumberOfLayers(2);
  auto back = vtkSmartPointer<vtkRenderer>::New();
  back->SetBackground(1, 1, 1);
  back->InteractiveOff();
  paper.add_to(*back);
  window.AddRenderer(back);
  for (const GraphSpace& space : spaces) window.AddRenderer(space.renderer);
  auto front = vtkSmartPointer<vtkRenderer>::New();
  front->SetLayer(1);
  front->InteractiveOff();
  over.add_to(*front);
  window.AddRenderer(front);
  return spaces;
}

void GraphPicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, width, height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

std::string summary(const DrawnScene& drawn, const GraphLook& look) {
  std::size_t things = 0;
  for (NodeId node = 0; node < drawn.graph.size(); ++node) things += drawn.graph.geometry(node) != no_item;
  const std::string kind = look.kind == BoundKind::box ? "boxes" : std::string(name_of(look.kind)) + "s";
  std::string text = "scene graph of " + counted(drawn.graph.size(), "node") + ", " + with_commas(things) +
                     " with geometry;  bounds: " + kind + " of depth " + std::to_string(look.shallowest);
  const std::uint32_t deepest = std::min(look.deepest, drawn.shape.deepest);
  if (deepest != look.shallowest) text += " to " + std::to_string(deepest);
  text += " of " + std::to_string(drawn.shape.deepest);
  if (drawn.surfaces.endless() > 0) text += ";  " + counted(drawn.surfaces.endless(), "endless solid") + " left out";
  return text;
}

std::string verdict_of(const Change& change, const SceneGraph& graph) {
  return graph.path(change.node) + " dragged by " + text_of(change.by) + ": the event passes " +
         counted(change.way.size(), "node") + " up to the root; asked for, " + counted(change.work.worlds, "place") +
         " and " + counted(change.work.bounds, "bound") +
         " are computed.  Root: " + short_number(volume_of(change.before->bounds[root_node])) + " to " +
         short_number(volume_of(change.after->bounds[root_node])) + " cubic units";
}

}  // namespace sightline::viz
