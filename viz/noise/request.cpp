#include "viz/noise/request.h"

#include <charconv>
#include <span>
#include <stdexcept>
#include <string_view>

namespace sightline::noise_tool {
namespace {

template <class Infos>
Choices choices_of(const Infos& infos) {
  Choices choices;
  for (const auto& info : infos) {
    choices.names += (choices.names.empty() ? "" : "|") + std::string(info.name);
    if constexpr (requires { info.description; }) {
      choices.lines += "\n  " + std::string(info.name) + ": " + std::string(info.description);
    }
  }
  return choices;
}

template <class Infos>
const auto& found(const char* flag, const Infos& infos, const std::string& text) {
  for (const auto& info : infos) {
    if (info.name == text) return info;
  }
  throw std::invalid_argument(std::string(flag) + ": expected one of " + choices_of(infos).names + ", found " + text);
}

}  // namespace

NoiseKind parse_kind(const std::string& text) { return found("--kind", noise_infos, text).kind; }
Ease parse_ease(const std::string& text) { return found("--ease", ease_infos, text).ease; }
FractalKind parse_fractal(const std::string& text) { return found("--fractal", fractal_infos, text).kind; }

Level parse_precision(const std::string& text) {
  if (text == info_of(Level::fast).name) return Level::fast;
  if (text == info_of(Level::precise).name) return Level::precise;
  throw std::invalid_argument("--precision: expected one of fast|precise, found " + text);
}

void parse_size(const std::string& text, Slice& slice) {
  const char* const end = text.data() + text.size();
  const auto [after_width, width_error] = std::from_chars(text.data(), end, slice.width);
  bool is_size = width_error == std::errc() && after_width != end && *after_width == 'x';
  if (is_size) {
    const auto [after, error] = std::from_chars(after_width + 1, end, slice.height);
    is_size = error == std::errc() && after == end;
  }
  constexpr int longest = 1 << 14;
  if (is_size && slice.width >= 1 && slice.height >= 1 && slice.width <= longest && slice.height <= longest) return;
  throw std::invalid_argument("--size: expected WIDTHxHEIGHT, each from 1 to " + std::to_string(longest) + ", found " +
                              text);
}

Choices kinds() { return choices_of(noise_infos); }
Choices eases() { return choices_of(ease_infos); }
Choices fractals() { return choices_of(fractal_infos); }

}  // namespace sightline::noise_tool
