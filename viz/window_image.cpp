#include "viz/window_image.h"

#include <vtkSVGExporter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

#include "sightline/io/image_file.h"
#include "sightline/io/output_file.h"
#include "viz/color_ramp.h"

namespace sightline::viz {

namespace {

/// Writes what the window shows, each `oversampling` x `oversampling` pixels averaged to one, as light adds.
void write_window(vtkRenderWindow& window, int oversampling, const std::filesystem::path& path) {
  const int* size = window.GetSize();
  const int width = size[0], height = size[1];
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window.GetPixelData(0, 0, width - 1, height - 1, 0, bytes);

  Image image{width / oversampling, height / oversampling, 3, {}};
  image.pixels.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3, 0);
  std::array<float, 256> light{};
  for (std::size_t byte = 0; byte < light.size(); ++byte) {
    light[byte] = static_cast<float>(linear_from_srgb(double(byte) / 255) / (oversampling * oversampling));
  }
  for (int y = 0; y < image.height * oversampling; ++y) {
    const int row = image.height - 1 - y / oversampling;  // OpenGL counts rows from below
    for (int x = 0; x < image.width * oversampling; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const auto to = (static_cast<std::size_t>(row) * image.width + x / oversampling) * 3 + channel;
        const auto from = (static_cast<vtkIdType>(y) * width + x) * 3 + channel;
        image.pixels[to] += light[bytes->GetValue(from)];
      }
    }
  }
  write_image(path, image);
}

}  // namespace

void write_picture(const std::filesystem::path& path, int width, int height,
                   const std::function<void(vtkRenderWindow&, int)>& show) {
  constexpr int oversampling = 2;
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * oversampling, height * oversampling);
  show(*window, oversampling);
  window->Render();
  write_window(*window, oversampling, path);
}

void write_svg(const std::filesystem::path& path, vtkRenderer& renderer, int width, int height) {
  OutputFile file(path);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->AddRenderer(&renderer);
  window->Render();
  auto exporter = vtkSmartPointer<vtkSVGExporter>::New();
  exporter->SetRenderWindow(window);
  exporter->SetFileName(file.temporary().c_str());
  exporter->Write();
  file.commit();
}

}  // namespace sightline::viz
