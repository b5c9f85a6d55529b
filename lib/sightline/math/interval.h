#pragma once
/// A closed interval of ray parameters.

#include <limits>

namespace sightline {

template <class T>
struct Interval {
  T lo = std::numeric_limits<T>::infinity();
  T hi = -std::numeric_limits<T>::infinity();

  /// True as well when an end is NaN, so that nothing is found in a broken interval.
  bool is_empty() const { return !(lo <= hi); }
};

}  // namespace sightline
