#include "viz/command_text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace sightline::viz {
namespace {

template <class T>
std::string digits_of(T number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

template <class T>
std::string numbers_of(const Ray<T>& ray) {
  std::string text;
  for (const auto& v : {ray.origin, ray.direction}) {
    for (int axis = 0; axis < 3; ++axis) text += (text.empty() ? "" : ",") + digits_of(v[axis]);
  }
  return text;
}

}  // namespace

std::string shortest(double number) { return digits_of(number); }
std::string shortest(float number) { return digits_of(number); }
std::string text_of(const Ray<float>& ray) { return numbers_of(ray); }
std::string text_of(const Ray<double>& ray) { return numbers_of(ray); }

std::string quoted(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_=.,:/+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string option_text(const std::string& option, const std::string& value) {
  return ' ' + option + (value.starts_with('-') ? "=" : " ") + quoted(value);
}

std::string camera_text(double azimuth, double elevation, double zoom) {
  std::string text;
  if (azimuth != 24) text += option_text("--azimuth", shortest(azimuth));
  if (elevation != 20) text += option_text("--elevation", shortest(elevation));
  if (zoom != 1) text += option_text("--zoom", shortest(zoom));
  return text;
}

std::string size_text(int width, int height) {
  return " --size " + std::to_string(width) + 'x' + std::to_string(height);
}

std::vector<std::string> words_of(std::string_view command) {
  std::vector<std::string> words;
  bool is_quoted = false, is_within = false;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (c == ' ' && !is_quoted) {
      is_within = false;
      continue;
    }
    if (!is_within) words.emplace_back();
    is_within = true;
    if (c == '\'') {
      is_quoted = !is_quoted;
    } else if (c == '\\' && !is_quoted && i + 1 < command.size()) {
      words.back() += command[++i];
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace sightline::viz
