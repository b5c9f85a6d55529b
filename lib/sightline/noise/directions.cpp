#include "sightline/noise/directions.h"

#include <cmath>
#include <numbers>

namespace sightline {
namespace {

/// Makes a table of its first half.
template <class T, std::size_t dims>
class Filler {
 public:
  void add(const std::array<double, dims>& direction) {
    for (std::size_t k = 0; k < dims; ++k) {
      const T component = static_cast<T>(direction[k]);
      table_.components[k][count_] = component;
      table_.components[k][count_ + table_.size] = -component;
    }
    ++count_;
  }
  const DirectionTable<T, dims>& table() const { return table_; }

 private:
  DirectionTable<T, dims> table_;
  std::size_t count_ = 0;
};

template <class T>
DirectionTable<T, 2> in_plane() {
  Filler<T, 2> filler;
  for (int i = 0; i < 16; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 16;
    filler.add({std::cos(angle), std::sin(angle)});
  }
  return filler.table();
}

/// Four diagonals of a cube, and for both solids the three pairs (0, +-a, b), (b, 0, +-a), (+-a, b, 0).
template <class T>
DirectionTable<T, 3> in_space() {
  constexpr double phi = std::numbers::phi;
  const double whole = std::sqrt(3.0), icosa = std::sqrt(1 + phi * phi);
  Filler<T, 3> filler;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) filler.add({x / whole, y / whole, 1 / whole});
  }
  const auto add_pairs = [&](double a, double b) {
    for (const double side : {-a, a}) {
      filler.add({0, side, b});
      filler.add({b, 0, side});
      filler.add({side, b, 0});
    }
  };
  add_pairs(1 / (phi * whole), phi / whole);
  add_pairs(1 / icosa, phi / icosa);
  return filler.table();
}

}  // namespace

template <>
DirectionTable<float, 2> unit_directions() {
  return in_plane<float>();
}
template <>
DirectionTable<double, 2> unit_directions() {
  return in_plane<double>();
}
template <>
DirectionTable<float, 3> unit_directions() {
  return in_space<float>();
}
template <>
DirectionTable<double, 3> unit_directions() {
  return in_space<double>();
}

template <class T>
DirectionTable<T, 3> edge_directions() {
  Filler<T, 3> filler;
  for (int i = 0; i < 16; ++i) {
    // Perlin's bits say which two axes, and their signs.
    const std::size_t first = i < 8 ? 0 : 1, second = i < 4 ? 1 : i == 12 || i == 14 ? 0 : 2;
    std::array<double, 3> direction{};
    direction[first] = (i & 1) != 0 ? -1 : 1;
    direction[second] = (i & 2) != 0 ? -1 : 1;
    filler.add(direction);
  }
  return filler.table();
}
template DirectionTable<float, 3> edge_directions();
template DirectionTable<double, 3> edge_directions();

}  // namespace sightline
