#include "viz/texture/normals_picture.h"

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viz/paper.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

using Align = Canvas::Align;

constexpr double sheet_width = 1600, sheet_height = 1000, margin = 28, head = 122, side = 520, low_side = 260;
constexpr double reach = 1.16;
constexpr std::array<DentKind, 3> kinds{DentKind::none, DentKind::normals, DentKind::displaced};
constexpr std::array<const char*, 3> titles{"a sphere", "its normals dented", "the surface displaced"};
constexpr std::array<const char*, 3> remarks{"as it is", "shading follows noise, the surface does not",
                                             "every vertex moved by the same noise"};

std::string text_of(const char* format, double x) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), format, x);
  return text.data();
}

std::string size_text(double bytes) {
  return bytes == 0 ? "no memory" : bytes < 1e6 ? text_of("%.0f kB", bytes / 1e3) : text_of("%.1f MB", bytes / 1e6);
}

ColorGrid silhouette(const DentedSphere& sphere) {
  ColorGrid grid{sphere.shaded.width, sphere.shaded.height, {}};
  for (const std::uint8_t is_covered : sphere.is_covered) {
    for (const double share : is_covered ? ink : Rgb{1, 1, 1}) {
      grid.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
  return grid;
}

/// Every `step`th pixel of every `step`th row.
ColorGrid thinned(const ColorGrid& grid, int step) {
  ColorGrid thin{grid.width / step, grid.height / step, {}};
  for (int y = 0; y < thin.height; ++y) {
    for (int x = 0; x < thin.width; ++x) {
      const auto at = (static_cast<std::size_t>(y * step) * static_cast<std::size_t>(grid.width) +
                       static_cast<std::size_t>(x * step)) *
                      3;
      thin.bytes.insert(thin.bytes.end(), &grid.bytes[at], &grid.bytes[at] + 3);
    }
  }
  return thin;
}

std::size_t differing(const DentedSphere& a, const DentedSphere& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.is_covered.size(); ++i) count += a.is_covered[i] != b.is_covered[i];
  return count;
}

}  // namespace

double NormalsPicture::unit() const { return std::min(width / sheet_width, height / sheet_height); }

NormalsPicture::NormalsPicture(const Dents& dents, int divisions, int its_width, int its_height)
    : width(its_width), height(its_height), amplitude_(dents.amplitude) {
  const int size = static_cast<int>(std::lround(side * unit()));
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    spheres_[i] = dented_sphere(kinds[i], dents, size, reach, divisions);
  }
}

void NormalsPicture::show_in(vtkRenderWindow& window, int scale) const {
  const double across = width / unit(), down = height / unit();
  Canvas canvas(down, unit() * scale);
  canvas.text({margin, 38}, "Dented normals", {27, ink, Align::left, true});
  canvas.text(
      {margin, 74},
      "n' is n less the part of the noise's gradient that lies in the surface: light falls as on dents of up to " +
          text_of("%.3g", amplitude_) + " radii, but nothing moves",
      {16, soft_ink});
  const double column = (across - 2 * margin) / 3;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const DentedSphere& sphere = spheres_[i];
    const double middle = margin + (static_cast<double>(i) + 0.5) * column, top = head + 36;
    canvas.text({middle, head - 6}, titles[i], {18, ink, Align::center, true});
    canvas.text({middle, head + 17}, remarks[i], {14, soft_ink, Align::center});
    canvas.image({middle - side / 2, top}, sphere.shaded, 1 / unit());
    const double low = top + side + 26;
    const ColorGrid shadow = thinned(silhouette(sphere), 2);
    canvas.image({middle - column / 2 + 20, low}, shadow, 1 / unit());
    const Canvas::Point center{middle - column / 2 + 20 + shadow.width / unit() / 2, low + shadow.height / unit() / 2};
    canvas.ring(center, shadow.width / unit() / 2 / reach, 1.6, accent);
    const double text = middle - column / 2 + 20 + low_side + 26;
    const std::size_t wrong = differing(sphere, spheres_[0]);
    double y = low + 22;
    const auto line = [&](const std::string& words, bool is_bold = false) {
      canvas.text({text, y}, words, {14, is_bold ? ink : soft_ink, Align::left, is_bold});
      y += 23;
    };
    line(i == 0       ? "its silhouette: a circle"
         : wrong == 0 ? "its silhouette: the same circle"
                      : "its silhouette: another",
         true);
    if (i > 0) line(text_of("%.0f pixels differ", static_cast<double>(wrong)));
    line(size_text(static_cast<double>(sphere.bytes)));
    if (sphere.triangles > 0) line(text_of("%.0f triangles", static_cast<double>(sphere.triangles)));
    if (sphere.triangles > 0) line("per pixel " + text_of("%.1f nodes,", sphere.nodes));
    if (sphere.triangles > 0) line(text_of("%.1f candidates,", sphere.candidates));
    line((sphere.triangles > 0 ? "" : "per pixel ") + text_of("%.0f noise samples", sphere.noise_samples));
  }
  window.GetRenderers()->RemoveAllItems();
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  canvas.add_to(*renderer);
  window.AddRenderer(renderer);
}

void NormalsPicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, width, height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

std::string NormalsPicture::table() const {
  std::string text = "                           ns/pixel  build, ms     memory  triangles  nodes  candidates  noise\n";
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const DentedSphere& sphere = spheres_[i];
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%-24s %10.0f %10.1f %10s %10zu %6.1f %11.1f %6.0f\n", titles[i],
                  sphere.nanoseconds, 1e3 * sphere.build_seconds, size_text(static_cast<double>(sphere.bytes)).c_str(),
                  sphere.triangles, sphere.nodes, sphere.candidates, sphere.noise_samples);
    text += line.data();
  }
  return text + "Of each pixel that the sphere covers, on one thread; the last pass of two is timed.\n";
}

}  // namespace sightline::viz
