#include "viz/heat_map.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sightline::viz {
namespace {

constexpr int legend_height = 56, margin = 20, bar_height = 14;
constexpr float paper = 1;

Rgb heat(double work, double highest) {
  Rgb color = heat_color(work, highest);
  for (double& component : color) component = linear_from_srgb(component);
  return color;
}

void put(Image& image, int x, int y, const Rgb& light) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  const std::size_t at = (static_cast<std::size_t>(y) * image.width + x) * 3;
  for (std::size_t channel = 0; channel < 3; ++channel) image.pixels[at + channel] = static_cast<float>(light[channel]);
}

/// Black text, its middle at `x` (held within the picture) and its top at `y`. Drawn by FreeType: needs no display.
void put_text(Image& image, const std::string& text, int x, int y) {
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (!renderer) return;
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  property->SetFontFamilyToArial();
  property->SetFontSize(13);
  property->SetColor(0, 0, 0);
  auto drawn = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 2> size{};
  if (!renderer->RenderString(property, vtkStdString(text), drawn, size.data(), 72)) return;
  const int left = std::clamp(x - size[0] / 2, 4, std::max(4, image.width - size[0] - 4));
  for (int row = 0; row < size[1]; ++row) {
    for (int column = 0; column < size[0]; ++column) {
      const double cover = drawn->GetScalarComponentAsDouble(column, size[1] - 1 - row, 0, 3) / 255;
      if (cover > 0) put(image, left + column, y + row, {1 - cover, 1 - cover, 1 - cover});
    }
  }
}

void put_legend(Image& image, int top, double highest) {
  const int length = image.width - 2 * margin;
  for (int x = 0; x < length; ++x) {
    const double work = std::pow(highest, double(x) / (length - 1));
    for (int y = 0; y < bar_height; ++y) put(image, margin + x, top + 8 + y, heat(work, highest));
  }
  for (double decade = 1; decade <= highest; decade *= 10) {
    for (const int step : {1, 3}) {
      const double work = decade * step;
      if (work > highest) continue;
      const int x = margin + static_cast<int>(std::lround(heat_share(work, highest) * (length - 1)));
      for (int y = 0; y < 4; ++y) put(image, x, top + 8 + bar_height + y, {0, 0, 0});
      put_text(image, std::to_string(static_cast<long>(work)) + (work == 1 ? " step per pixel" : ""), x,
               top + 14 + bar_height);
    }
  }
}

}  // namespace

double heat_share(double work, double highest) {
  return std::clamp(std::log(std::fmax(work, 1)) / std::log(highest), 0.0, 1.0);
}

Rgb heat_color(double work, double highest) {
  return work < 1 ? Rgb{0, 0, 0} : ramp(heat_share(work, highest), 0.15, 0.93);
}

double scale_for(std::span<const std::uint32_t> work) {
  std::vector<std::uint32_t> sorted(work.begin(), work.end());
  if (sorted.empty()) return 10;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 999 / 1000);
  std::nth_element(sorted.begin(), at, sorted.end());
  return std::max(10.0, double(*at));
}

Image heat_map(std::span<const std::uint32_t> work, int width, int height, double highest) {
  Image image{width, height + legend_height, 3, {}};
  image.pixels.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3, paper);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      put(image, x, y, heat(work[static_cast<std::size_t>(y) * width + x], highest));
    }
  }
  put_legend(image, height, highest);
  return image;
}

}  // namespace sightline::viz
