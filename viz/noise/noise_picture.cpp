#include "viz/noise/noise_picture.h"

#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "viz/noise/chart_panels.h"
#include "viz/noise/space_panels.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// In units: what must find room.
constexpr double sheet_width = 1600, sheet_height = 1000, panel_width = 620, panel_height = 560;
constexpr double margin = 28, head = 78, gap = 30;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string subtitle(const FieldOptions& options) {
  const auto& noise = options.noise;
  std::string text(noise_infos[static_cast<std::size_t>(noise.kind)].description);
  text += ";  seed " + std::to_string(noise.seed);
  if (noise.period > 0) text += ", period " + std::to_string(noise.period);
  if (options.fractal != FractalKind::none) {
    text += ", " + std::string(fractal_infos[static_cast<std::size_t>(options.fractal)].name) + " of " +
            std::to_string(options.octaves) + " octaves, lacunarity " + number(options.lacunarity) + ", gain " +
            number(options.gain);
  }
  if (options.frequency != 1) text += ", frequency " + number(options.frequency);
  if (options.warp > 0) text += ", warp " + number(options.warp);
  return text;
}

}  // namespace

void NoisePicture::show_in(vtkRenderWindow& window, int scale) const {
  const double unit = only ? std::min(width / panel_width, height / panel_height)
                           : std::min(width / sheet_width, height / sheet_height);
  const double across = width / unit, down = height / unit;
  NoiseLook scaled = look;
  scaled.unit = unit;
  Canvas canvas(down, unit * scale);
  const PartPlace place{unit * scale, across, down};

  const std::string name(noise_infos[static_cast<std::size_t>(look.field.options().noise.kind)].name);
  const Canvas::TextStyle title{27, ink, Canvas::Align::left, true};
  canvas.text({margin, 38}, name + " noise", title);
  if (only) {
    canvas.text({margin, 66}, subtitle(look.field.options()), {12, soft_ink});
  } else {
    canvas.text({margin + canvas.text_width(name + " noise", title) + 16, 40}, subtitle(look.field.options()),
                {15, soft_ink});
  }

  std::vector<vtkSmartPointer<vtkRenderer>> parts;
  const auto draw = [&](NoisePanel panel, const PanelFrame& frame) {
    switch (panel) {
      case NoisePanel::slice:
        return draw_slice(canvas, frame, scaled);
      case NoisePanel::gradients:
        return draw_gradients(canvas, frame, scaled);
      case NoisePanel::lattice:
        return draw_lattice(canvas, frame, scaled);
      case NoisePanel::coherence:
        return draw_coherence(canvas, frame, scaled);
      case NoisePanel::ease:
        parts.push_back(ease_chart(canvas, frame, scaled, place));
        return;
      case NoisePanel::spectrum:
        parts.push_back(spectrum_chart(canvas, frame, scaled, place));
        return;
      case NoisePanel::isosurfaces:
        parts.push_back(isosurface_view(canvas, frame, scaled, place));
        return;
      case NoisePanel::volume:
        parts.push_back(volume_view(canvas, frame, scaled, place));
        return;
    }
  };
  if (only) {
    draw(*only, {margin, head + 16, across - 2 * margin, down - head - 16 - margin});
  } else {
    constexpr int columns = 4;
    const double part_width = (across - 2 * margin - (columns - 1) * gap) / columns;
    const double part_height = (down - head - margin - gap) / 2;
    for (std::size_t i = 0; i < noise_panel_infos.size(); ++i) {
      draw(noise_panel_infos[i].panel,
           {margin + static_cast<double>(i % columns) * (part_width + gap),
            head + static_cast<double>(i / columns) * (part_height + gap), part_width, part_height});
    }
  }

  window.GetRenderers()->RemoveAllItems();
  auto paper = New<vtkRenderer>::New();
  paper->SetBackground(1, 1, 1);
  canvas.add_to(*paper);
  paper->InteractiveOff();
  window.AddRenderer(paper);
  for (const auto& part : parts) {
    if (part) window.AddRenderer(part);
  }
}

void NoisePicture::write_png(const std::filesystem::path& path) const {
  constexpr int oversampling = 2;
  auto window = New<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * oversampling, height * oversampling);
  show_in(*window, oversampling);
  window->Render();
  write_window(*window, oversampling, path);
}

}  // namespace sightline::viz
