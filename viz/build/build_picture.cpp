#include "viz/build/build_picture.h"

#include <vtkRendererCollection.h>

#include <algorithm>

#include "viz/build/build_chart.h"
#include "viz/build/build_space.h"
#include "viz/canvas.h"
#include "viz/command_text.h"
#include "viz/paper.h"
#include "viz/partition_picture.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

constexpr double reference_width = 1920;
constexpr double margin_left = 36, space_right = 960, head = 124, foot = 50, legend_height = 64, facts_height = 210;

/// Text over several lines, no wider than that.
std::vector<std::string> wrapped(const Canvas& canvas, const std::string& text, const Canvas::TextStyle& style,
                                 double width) {
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (!lines.back().empty() && canvas.text_width(longer, style) > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    at = end + 1;
  }
  return lines;
}

void draw_legend(Canvas& canvas, const BuildStep& step, const SpaceTold& told, double y) {
  const Canvas::TextStyle style{18};
  double x = margin_left;
  const auto entry = [&](const Rgb& color, const std::string& text, bool is_line) {
    is_line ? canvas.rectangle({x, y - 3}, 26, 6, color) : canvas.rectangle({x, y - 9}, 18, 18, color);
    canvas.text({x + (is_line ? 34 : 26), y}, text, style);
    x += (is_line ? 34 : 26) + canvas.text_width(text, style) + 26;
  };
  entry(ink, step.decision.chosen && told.planes > 0 ? "the node, and the plane taken" : "the node", true);
  if (!step.decision.below.empty() || !step.decision.above.empty()) {
    entry(below_color, "below", false);
    entry(above_color, "above", false);
    entry(both_color, "in both", false);
  }
  const std::size_t parts = step.decision.parts.size();
  if (parts > 0) entry({0.10, 0.45, 0.70}, "its children" + std::string(parts <= 8 ? ", a color each" : ""), true);
  if (!step.decision.merged.empty()) entry({0.55, 0.57, 0.62}, "given up", true);
  if (told.planes_drawn == 0) return;
  x = margin_left;
  y += 32;
  const std::string low = cost_text(told.cheapest), high = cost_text(told.dearest);
  const std::string text =
      "planes weighed (" + with_commas(told.planes_drawn) + " of " + with_commas(told.planes) + " drawn), cost " + low;
  canvas.text({x, y}, text, style);
  x += canvas.text_width(text, style) + 10;
  for (int i = 0; i < 60; ++i) canvas.rectangle({x + 3.0 * i, y - 9}, 3.5, 18, ramp(i / 59.0));
  canvas.text({x + 190, y}, high, style);
}

}  // namespace

std::string command_of(const BuildStep& step, const BuildLook& look) {
  const BuildLook usual;
  std::string text = step.command + camera_text(look.azimuth, look.elevation, look.zoom);
  if (look.width != usual.width || look.height != usual.height) text += size_text(look.width, look.height);
  return text;
}

void BuildPicture::show_in(vtkRenderWindow& window, double scale) const {
  const double unit = look.width / reference_width * scale, height = look.height * scale / unit;
  const double bottom = height - foot, space_bottom = bottom - legend_height, facts_top = bottom - facts_height;
  window.GetRenderers()->RemoveAllItems();
  auto paper = New<vtkRenderer>::New();
  paper->SetBackground(1, 1, 1);
  paper->InteractiveOff();

  auto space = New<vtkRenderer>::New();
  space->SetBackground(1, 1, 1);
  space->SetViewport(0, 1 - space_bottom / height, space_right / reference_width, 1 - head / height);
  light_space(*space);
  const SpaceTold told = show_space(*space, story, step, look, space_right / (space_bottom - head), unit);

  Canvas canvas(height, unit);
  canvas.text({margin_left, 36}, step.title, {28, ink, Canvas::Align::left, true});
  const Canvas::TextStyle strong{24};
  const std::string reason = "The node " + step.decision.reason + ".";
  canvas.text({margin_left, 80}, canvas.shortened(reason, strong, reference_width - 2 * margin_left), strong);
  draw_legend(canvas, step, told, space_bottom + 12);
  double y = facts_top + 20;
  const double right = space_right + 40;
  const Canvas::TextStyle fact{20};
  for (const std::string& line : facts_of(story, step)) {
    for (const std::string& part : wrapped(canvas, line, fact, reference_width - right - margin_left)) {
      canvas.text({right, y}, part, fact);
      y += 29;
    }
    y += 9;
  }
  canvas.text({margin_left, height - 24},
              canvas.shortened(command_of(step, look), {18, soft_ink}, reference_width - 180), {18, soft_ink});
  canvas.text({reference_width - margin_left, height - 24}, "H: keys", {18, soft_ink, Canvas::Align::right});
  canvas.add_to(*paper);
  window.AddRenderer(paper);
  window.AddRenderer(space);
  constexpr double chart_left = space_right + 10, chart_right = reference_width - 20;
  auto chart = chart_of(step.decision, "", (chart_right - chart_left) * unit, (facts_top - head) * unit, unit);
  chart->SetViewport(chart_left / reference_width, 1 - facts_top / height, chart_right / reference_width,
                     1 - head / height);
  chart->InteractiveOff();
  window.AddRenderer(chart);
}

void BuildPicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, look.width, look.height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

}  // namespace sightline::viz
