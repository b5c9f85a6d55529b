#include "viz/noise_tool/request.h"

#include <charconv>
#include <stdexcept>

namespace sightline::noise_tool {
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

}  // namespace sightline::noise_tool
