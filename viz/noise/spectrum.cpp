#include "viz/noise/spectrum.h"

#include <vtkImageData.h>
#include <vtkImageFFT.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
namespace sightline::viz {
namespace {

constexpr int cells = 64, samples = 512;
constexpr int steps_per_cycle = 32;
constexpr double highest = samples / (2.0 * cells);  // Nyquist, in cycles per cell

vtkSmartPointer<vtkImageData> windowed(const NoiseField& field) {
  const double step = cells / field.options().frequency / samples;
  std::vector<glm::dvec2> points;
  for (int i = 0; i < samples * samples; ++i)
    points.emplace_back((i % samples + 0.5) * step, (i / samples + 0.5) * step);
  std::vector<double> values(points.size());
  field.values<2, double>(points, values);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples, samples, 1);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* to = static_cast<double*>(image->GetScalarPointer());
  double mean = 0;
  for (const double value : values) mean += value;
  mean /= static_cast<double>(values.size());
  const auto hann = [&](int i) { return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (i + 0.5) / samples); };
  for (int i = 0; i < samples * samples; ++i) {
    *to++ = (values[static_cast<std::size_t>(i)] - mean) * hann(i % samples) * hann(i / samples);
  }
  return image;
}

}  // namespace

Spectrum spectrum_of(const NoiseField& field) {
  auto transform = vtkSmartPointer<vtkImageFFT>::New();
  transform->SetInputData(windowed(field));
  transform->SetDimensionality(2);
  transform->Update();
  const auto* number = static_cast<const double*>(transform->GetOutput()->GetScalarPointer());

  Spectrum spectrum;
  spectrum.densities.assign(static_cast<std::size_t>(highest * steps_per_cycle), 0);
  for (std::size_t i = 0; i < spectrum.densities.size(); ++i) {
    spectrum.frequencies.push_back((static_cast<double>(i) + 0.5) / steps_per_cycle);
  }
  double total = 0, along_axes = 0, along_diagonals = 0;
  const auto signed_index = [](int i) { return i < samples / 2 ? i : i - samples; };
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x, number += 2) {
      const double fx = double(signed_index(x)) / cells, fy = double(signed_index(y)) / cells;
      const double power = number[0] * number[0] + number[1] * number[1], frequency = std::hypot(fx, fy);
      const auto bin = static_cast<std::size_t>(frequency * steps_per_cycle);
      if (bin >= spectrum.densities.size()) continue;  // corners, which not all directions have
      spectrum.densities[bin] += power;
      total += power;
      if (frequency < 0.25) spectrum.below_quarter += power;
      if (frequency > 2) spectrum.above_two += power;
      const double degrees = std::atan2(std::fabs(fy), std::fabs(fx)) * 180 / std::numbers::pi;
      if (std::min(degrees, 90 - degrees) < 10) along_axes += power;
      if (std::fabs(degrees - 45) < 10) along_diagonals += power;
    }
  }
  if (!(total > 0)) return spectrum;
  for (double& density : spectrum.densities) density *= steps_per_cycle / total;
  spectrum.below_quarter /= total;
  spectrum.above_two /= total;
  spectrum.axis_over_diagonal = along_axes / along_diagonals;
  return spectrum;
}

}  // namespace sightline::viz
