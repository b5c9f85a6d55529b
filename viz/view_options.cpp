#include "viz/view_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sightline::viz {
namespace {

/// The whole of `text` as a number from `lowest` to `highest`; nothing where it is not one.
template <class T>
std::optional<T> number(std::string_view text, T lowest, T highest) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= lowest && value <= highest)) return {};
  return value;
}

constexpr int deepest_depth = 1'000'000;

}  // namespace

DepthRange parse_depth(const std::string& text, const std::string& option) {
  const std::string expected = "MIN:MAX, MIN:, :MAX or one depth, whole numbers from 0, MIN not above MAX; as in 2:7";
  const std::size_t colon = text.find(':');
  DepthRange range;
  const std::string low = text.substr(0, colon), high = colon == std::string::npos ? low : text.substr(colon + 1);
  if (low.empty() && high.empty()) refuse(option, text, expected);
  if (!low.empty()) {
    const auto value = number(low, 0, deepest_depth);
    if (!value) refuse(option, text, expected);
    range.shallowest = *value;
  }
  if (!high.empty()) {
    range.deepest = number(high, 0, deepest_depth);
    if (!range.deepest || *range.deepest < range.shallowest) refuse(option, text, expected);
  } else {
    range.deepest = deepest_depth;
  }
  return range;
}

std::optional<std::vector<double>> finite_numbers(std::string_view text, std::size_t count, char separator) {
  std::vector<double> values;
  while (true) {
    const std::size_t end_of_value = std::min(text.find(separator), text.size());
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + end_of_value, value);
    if (error != std::errc() || end != text.data() + end_of_value || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    if (end_of_value == text.size()) break;
    text.remove_prefix(end_of_value + 1);
  }
  return values.size() == count ? std::optional(values) : std::nullopt;
}

Slice parse_slice(const std::string& text) {
  const std::string expected = "AXIS=POSITION, an axis x, y or z and a share of the extent from 0 to 1; as in y=0.5";
  const std::string_view axes = "xyz";
  if (text.size() < 3 || text[1] != '=' || axes.find(text[0]) == std::string_view::npos) {
    refuse("--slice", text, expected);
  }
  const auto share = number(std::string_view(text).substr(2), 0.0, 1.0);
  if (!share) refuse("--slice", text, expected);
  return {static_cast<int>(axes.find(text[0])), *share};
}

AcceleratorSpec parse_structure(const std::string& text, const std::vector<std::string>& settings) try {
  std::vector<AcceleratorSpec> specs = parse_accelerators(text);
  if (specs.size() != 1) refuse("--accel", text, "one structure");
  apply_settings(specs, settings);
  check_accelerator(specs.front());
  return specs.front();
} catch (const std::invalid_argument& error) {
  throw UsageError(error.what());
}

PictureSize parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto width = number(std::string_view(text).substr(0, cross), 400, 4000);
  const auto height =
      cross == std::string::npos ? std::optional<int>() : number(std::string_view(text).substr(cross + 1), 300, 4000);
  if (!width || !height) {
    refuse("--size", text, "WIDTHxHEIGHT, from 400x300 to 4000x4000; as in 1200x900");
  }
  return {*width, *height};
}

Ray<float> parse_ray(const std::string& option, const std::string& text) {
  const auto v = finite_numbers(text, 6, ',');
  if (!v) refuse(option, text, "OX,OY,OZ,DX,DY,DZ, six finite numbers: an origin and a direction");
  const Ray<double> wide{{(*v)[0], (*v)[1], (*v)[2]}, {(*v)[3], (*v)[4], (*v)[5]}};
  const Ray<float> ray{Vec3f(wide.origin), Vec3f(wide.direction)};
  if (!is_valid(ray)) refuse(option, text, "numbers that are finite as floats, and a direction that is not zero");
  return ray;
}

std::optional<Pixel> pixel_in(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  constexpr int farthest = 1'000'000;
  const auto x = number(std::string_view(text).substr(0, comma), -farthest, farthest);
  const auto y = number(std::string_view(text).substr(std::min(comma + 1, text.size())), -farthest, farthest);
  return x && y ? std::optional(Pixel{*x, *y}) : std::nullopt;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

PictureSize parse_size(const std::string& text, const PictureSize& least) {
  const PictureSize size = parse_size(text);
  if (size.width < least.width || size.height < least.height) {
    refuse("--size", text,
           "at least " + std::to_string(least.width) + "x" + std::to_string(least.height) + ", so that it can be read");
  }
  return size;
}

void refuse(const std::string& option, const std::string& text, const std::string& expected) {
  throw UsageError(option + " " + text + ": expected " + expected);
}

void require_number(const std::string& option, double value) {
  if (!std::isfinite(value)) refuse(option, value != value ? "nan" : "inf", "a number");
}

}  // namespace sightline::viz
