#include "sightline/render/sky_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace sightline {
namespace {

using std::numbers::pi;

constexpr std::size_t most_columns = 1024, most_rows = 512;

/// Sums up to each, over that of all; of nothing, as if all were alike.
void accumulate(std::span<const double> values, std::span<float> sums) {
  double all = 0;
  for (const double value : values) all += value;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[i] = static_cast<float>(all > 0 ? sum / all : static_cast<double>(i) / static_cast<double>(values.size()));
    sum += values[i];
  }
  sums.back() = 1;
}

/// The cell that x in [0, 1) falls into, and x becomes its place within.
std::size_t choose(std::span<const float> sums, double& x) {
  const auto after = std::upper_bound(sums.begin(), sums.end() - 1, static_cast<float>(x));
  const auto cell = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - sums.begin() - 1, 0));
  const double width = double(sums[cell + 1]) - double(sums[cell]);
  x = width > 0 ? std::clamp((x - double(sums[cell])) / width, 0.0, 0x1.fffffffffffffp-1) : 0.5;
  return cell;
}

double luminance_at(const Image& image, int x, int y) {
  const int columns = image.width, c = image.channels;
  const auto first = (static_cast<std::size_t>(std::clamp(y, 0, image.height - 1)) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>((x + columns) % columns)) *
                     static_cast<std::size_t>(c);
  const float* const pixel = &image.pixels[first];
  const double value = c < 3 ? double(pixel[0]) : 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
  return std::isfinite(value) ? std::max(value, 0.0) : 0;
}

/// The integral over a texel of what is interpolated between the middles of texels.
double mean_over_texel(const Image& image, int x, int y) {
  constexpr double weights[3] = {0.125, 0.75, 0.125};
  double sum = 0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) sum += weights[i + 1] * weights[j + 1] * luminance_at(image, x + i, y + j);
  }
  return sum;
}

}  // namespace

std::optional<SkyDistribution> SkyDistribution::of(const SkyImage& sky) {
  return of(read_image(sky.image), sky.rotation);
}

std::optional<SkyDistribution> SkyDistribution::of(const Image& image, double rotation) {
  SkyDistribution all;
  all.rotation_ = rotation;
  all.columns_ = std::min(most_columns, static_cast<std::size_t>(image.width));
  all.rows_ = std::min(most_rows, static_cast<std::size_t>(image.height));
  std::vector<double> cells(all.columns_ * all.rows_);
  double least = INFINITY, most = 0;
  for (int y = 0; y < image.height; ++y) {
    const auto row =
        static_cast<std::size_t>(image.height - 1 - y) * all.rows_ / static_cast<std::size_t>(image.height);
    const double across = std::sin(pi * (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      const auto column = static_cast<std::size_t>(x) * all.columns_ / static_cast<std::size_t>(image.width);
      const double value = mean_over_texel(image, x, y);
      least = std::min(least, value);
      most = std::max(most, value);
      cells[row * all.columns_ + column] += value * across;
    }
  }
  if (!(most > least)) return std::nullopt;
  all.sums_.resize((all.columns_ + 1) * all.rows_);
  all.row_sums_.resize(all.rows_ + 1);
  std::vector<double> of_rows(all.rows_);
  for (std::size_t row = 0; row < all.rows_; ++row) {
    const std::span<const double> values = std::span(cells).subspan(row * all.columns_, all.columns_);
    for (const double value : values) of_rows[row] += value;
    accumulate(values, std::span(all.sums_).subspan(row * (all.columns_ + 1), all.columns_ + 1));
  }
  accumulate(of_rows, all.row_sums_);
  return all;
}

/// D1: by the sums as they were rounded, from which cells are chosen. `v` is the height, from 0 to 1.
double SkyDistribution::density_in(std::size_t row, std::size_t column, double v) const {
  const double of_row = double(row_sums_[row + 1]) - double(row_sums_[row]);
  const double of_cell = double(at(row, column + 1)) - double(at(row, column));
  const double solid_angle = 2 * pi * pi * std::sin(pi * v);  // of the unit square
  return solid_angle > 0 ? of_row * of_cell * static_cast<double>(rows_ * columns_) / solid_angle : 0;
}

SkyDistribution::Sample SkyDistribution::sample(const glm::dvec2& square) const {
  double x = square.x, y = square.y;
  const std::size_t row = choose(row_sums_, y);
  const std::size_t column = choose(std::span(sums_).subspan(row * (columns_ + 1), columns_ + 1), x);
  const double u = (static_cast<double>(column) + x) / static_cast<double>(columns_);
  const double v = (static_cast<double>(row) + y) / static_cast<double>(rows_);
  const double angle = 2 * pi * (u - 0.5 - rotation_ / 360), across = std::sin(pi * v);
  return {{across * std::sin(angle), -std::cos(pi * v), -across * std::cos(angle)}, density_in(row, column, v)};
}

double SkyDistribution::density(const Vec3d& direction) const {
  SkyImage sky;
  sky.rotation = rotation_;
  const glm::dvec2 uv = sky.uv_of(direction);
  const double u = uv.x - std::floor(uv.x);
  const auto cell = [](double x, std::size_t count) {
    return std::min(static_cast<std::size_t>(x * static_cast<double>(count)), count - 1);
  };
  return density_in(cell(uv.y, rows_), cell(u, columns_), uv.y);
}

}  // namespace sightline
