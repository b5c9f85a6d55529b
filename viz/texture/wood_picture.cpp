#include "viz/texture/wood_picture.h"

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "viz/paper.h"
#include "viz/texture/block_picture.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

using Align = Canvas::Align;

constexpr double sheet_width = 1600, sheet_height = 1080, margin = 28;

std::string number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

SolidColor color_of(const Texture& texture) {
  return [&texture](const Vec3d& p, const Footprint& footprint) { return texture(p, footprint); };
}

void put_block(Canvas& canvas, const Texture& texture, double x, double y, double width, double height, double unit) {
  const ColorGrid grid =
      block_picture(color_of(texture), Vec3d(-0.65, -1, -0.65), 2, static_cast<int>(std::lround(width * unit)),
                    static_cast<int>(std::lround(height * unit)));
  canvas.image({x, y}, grid, 1 / unit);
}

struct Knob {
  const char* title;
  const char* symbol;
  const char* meaning[2];
  double WoodOptions::*member;
};
constexpr std::array<Knob, 3> knobs{{
    {"texture frequency", "t", {"how close rings are:", "distances count t times"}, &WoodOptions::texture_frequency},
    {"noise frequency", "n", {"how many bumps", "a ring has"}, &WoodOptions::noise_frequency},
    {"noise amplitude", "a", {"how far bumps go,", "in rings"}, &WoodOptions::noise_amplitude},
}};

void draw_tuning(Canvas& canvas, const WoodOptions& base, double unit, double across, double down) {
  constexpr int columns = 5;
  constexpr double label_width = 178, head = 118;
  canvas.text({margin, 38}, "Tuning wood", {27, ink, Align::left, true});
  canvas.text({margin, 74},
              "f(P) = ((t X)^2 + (t Z)^2 + a noise(n P)) mod 1,   color = early wood + f (late wood - early wood)",
              {17, soft_ink});
  const double cell_width = (across - 2 * margin - label_width) / columns;
  const double cell_height = (down - head - margin) / static_cast<double>(knobs.size());
  for (std::size_t row = 0; row < knobs.size(); ++row) {
    const Knob& knob = knobs[row];
    const double y = head + static_cast<double>(row) * cell_height;
    canvas.text({margin, y + cell_height / 2 - 30}, std::string(knob.title) + " " + knob.symbol,
                {16, ink, Align::left, true});
    canvas.text({margin, y + cell_height / 2 - 6}, knob.meaning[0], {13.5, soft_ink});
    canvas.text({margin, y + cell_height / 2 + 12}, knob.meaning[1], {13.5, soft_ink});
    for (int column = 0; column < columns; ++column) {
      WoodOptions options = base;
      options.*knob.member = 1 + 2.0 * column / (columns - 1);
      const double x = margin + label_width + column * cell_width;
      put_block(canvas, Texture(Wood(options)), x + 6, y, cell_width - 12, cell_height - 34, unit);
      canvas.text({x + cell_width / 2, y + cell_height - 20},
                  std::string(knob.symbol) + " = " + number(options.*knob.member),
                  {15, base.*knob.member == options.*knob.member ? accent : ink, Align::center, true});
    }
  }
}

void draw_texture(Canvas& canvas, const Texture& texture, const std::string& spec, double unit, double across,
                  double down) {
  const std::string name = spec.substr(0, spec.find(':'));
  canvas.text({margin, 38}, name, {27, ink, Align::left, true});
  canvas.text({margin, 74}, spec, {15, soft_ink});
  constexpr double head = 110, foot = 40, gap = 40;
  const double height = down - head - foot, half = (across - 2 * margin - gap) / 2;
  put_block(canvas, texture, margin, head, half, height, unit);
  canvas.text({margin + half / 2, down - 22}, "a block with sides of 2, y up", {14, soft_ink, Align::center});
  const double side = std::min(half, height);
  const ColorGrid section =
      section_picture(color_of(texture), Vec3d(-2, 0.37, -2), 4, static_cast<int>(std::lround(side * unit)));
  canvas.image({margin + half + gap, head}, section, 1 / unit);
  canvas.text({margin + half + gap + side / 2, down - 22}, "cut across at y = 0.37: x and z from -2 to 2",
              {14, soft_ink, Align::center});
}

}  // namespace

void WoodPicture::show_in(vtkRenderWindow& window, int scale) const {
  const Texture texture = make_texture(spec);
  const double unit = std::min(width / sheet_width, height / (is_tuning ? sheet_height : 900));
  const double across = width / unit, down = height / unit;
  Canvas canvas(down, unit * scale);
  if (is_tuning) {
    const auto* wood = std::get_if<Wood>(&texture.any());
    if (!wood) throw std::invalid_argument("--tune " + spec + ": expected wood, whose sheet it is");
    draw_tuning(canvas, wood->options(), unit, across, down);
  } else {
    draw_texture(canvas, texture, spec, unit, across, down);
  }
  window.GetRenderers()->RemoveAllItems();
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  canvas.add_to(*renderer);
  window.AddRenderer(renderer);
}

void WoodPicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, width, height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

}  // namespace sightline::viz
