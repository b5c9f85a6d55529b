#include "viz/material_color.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sightline::viz {
namespace {

constexpr std::array<std::pair<std::string_view, Rgb>, 22> named{{
    {"red", {0.84, 0.22, 0.20}},    {"green", {0.20, 0.62, 0.32}},  {"blue", {0.17, 0.42, 0.80}},
    {"yellow", {0.93, 0.75, 0.16}}, {"orange", {0.93, 0.50, 0.13}}, {"violet", {0.52, 0.32, 0.72}},
    {"teal", {0.06, 0.56, 0.58}},   {"sky", {0.38, 0.68, 0.90}},    {"white", {0.93, 0.93, 0.93}},
    {"gray", {0.56, 0.58, 0.60}},   {"black", {0.17, 0.17, 0.19}},  {"oak", {0.80, 0.58, 0.32}},
    {"walnut", {0.45, 0.28, 0.17}}, {"steel", {0.47, 0.56, 0.66}},  {"brass", {0.80, 0.63, 0.20}},
    {"rust", {0.72, 0.35, 0.16}},   {"ivory", {0.86, 0.79, 0.62}},  {"sand", {0.85, 0.70, 0.42}},
    {"cheese", {0.95, 0.76, 0.26}}, {"amber", {0.83, 0.50, 0.05}},  {"glass", {0.58, 0.80, 0.84}},
    {"stone", {0.60, 0.57, 0.53}},
}};

/// Far apart, also for the color-blind: Okabe and Ito, "Color Universal Design", 2008.
constexpr std::array<Rgb, 7> others{{{0.00, 0.45, 0.70},
                                     {0.90, 0.60, 0.00},
                                     {0.00, 0.62, 0.45},
                                     {0.80, 0.40, 0.00},
                                     {0.80, 0.47, 0.65},
                                     {0.34, 0.71, 0.91},
                                     {0.75, 0.70, 0.15}}};

}  // namespace

Rgb material_color(std::string_view name, std::uint32_t primitive) {
  const auto found = std::find_if(named.begin(), named.end(), [&](const auto& entry) { return entry.first == name; });
  if (found != named.end()) return found->second;
  // Fowler, Noll and Vo's hash (FNV-1a).
  std::uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return others[(name.empty() ? primitive : hash) % others.size()];
}

Rgb diluted(const Rgb& color, double share) {
  Rgb light;
  for (std::size_t i = 0; i < 3; ++i) light[i] = 1 - share * (1 - color[i]);
  return light;
}

}  // namespace sightline::viz
