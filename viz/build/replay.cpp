#include "viz/build/replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace sightline::viz {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<BuildReplay> (*make)(const Primitives&, const TracerSettings&);
};

constexpr std::array entries{
    Entry{"kd-tree", make_kd_replay},
    Entry{"box-tree", make_box_replay},
    Entry{"sphere-tree", make_sphere_replay},
    Entry{"cylinder-tree", make_cylinder_replay},
    Entry{"bih", make_bih_replay},
    Entry{"bsp-tree", make_bsp_replay},
    Entry{"wide-tree", make_wide_replay},
    Entry{"grid", make_grid_replay},
};

constexpr auto names = [] {
  std::array<std::string_view, entries.size()> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = entries[i].name;
  return all;
}();

}  // namespace

std::span<const std::string_view> replayed_structures() { return names; }

std::unique_ptr<BuildReplay> make_replay(const std::string& accelerator, const Primitives& primitives,
                                         const TracerSettings& settings) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.name == accelerator) return entry.make(primitives, settings);
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw std::invalid_argument("build " + accelerator + ": expected one of " + known);
}

std::string cost_text(double value) {
  const double size = std::fabs(value);
  char text[32];
  if (size < 1000 || size >= 1e9) {
    std::snprintf(text, sizeof text, size >= 100 && size < 1000 ? "%.0f" : "%.3g", value);
    return text;
  }
  std::string digits = std::to_string(std::llround(value));
  for (auto at = std::ssize(digits) - 3; at > (value < 0 ? 1 : 0); at -= 3) {
    digits.insert(static_cast<std::size_t>(at), ",");
  }
  return digits;
}

std::string place_text(int axis, double position) {
  char text[48];
  std::snprintf(text, sizeof text, "%c = %.4g", "xyz"[axis], position);
  return text;
}

}  // namespace sightline::viz
