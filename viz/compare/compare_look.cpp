#include "viz/compare/compare_look.h"

#include <algorithm>
#include <charconv>

namespace sightline::viz {
namespace {

template <class T>
std::string shortest(T number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

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

}  // namespace

std::string_view name_of(CompareKind kind) {
  constexpr std::string_view names[] = {"walk", "work", "difference", "histogram"};
  return names[static_cast<std::size_t>(kind)];
}

bool operator==(const CompareLook& a, const CompareLook& b) {
  return a.kind == b.kind && a.work == b.work && a.against == b.against && a.alone == b.alone &&
         a.azimuth == b.azimuth && a.elevation == b.elevation && a.zoom == b.zoom && a.ray.origin == b.ray.origin &&
         a.ray.direction == b.ray.direction;
}

std::string ray_text(const Ray<float>& ray) {
  std::string text;
  for (const Vec3f& v : {ray.origin, ray.direction}) {
    for (int axis = 0; axis < 3; ++axis) text += (text.empty() ? "" : ",") + shortest(v[axis]);
  }
  return text;
}

std::string command_line(const CompareSource& source, const CompareLook& look, int width, int height) {
  const CompareLook usual;
  std::string text = "sightline-view compare";
  const auto add = [&](const std::string& option, const std::string& value) {
    text += ' ' + option + (value.starts_with('-') ? "=" : " ") + quoted(value);
  };
  for (const std::string& word : source.common) text += ' ' + quoted(word);
  add("--accel", source.accelerators);
  for (const std::string& setting : source.settings) add("--set", setting);
  add("--scene", source.scene);
  add("--show", std::string(name_of(look.kind)));
  if (look.work != usual.work) add("--count", std::string(name_of(look.work)));
  if (look.against != usual.against) add("--against", source.labels[look.against]);
  if (look.alone) add("--alone", std::to_string(*look.alone + 1));
  add("--ray", ray_text(look.ray));
  if (look.azimuth != usual.azimuth) add("--azimuth", shortest(look.azimuth));
  if (look.elevation != usual.elevation) add("--elevation", shortest(look.elevation));
  if (look.zoom != usual.zoom) add("--zoom", shortest(look.zoom));
  add("--size", std::to_string(width) + 'x' + std::to_string(height));
  return text;
}

}  // namespace sightline::viz
