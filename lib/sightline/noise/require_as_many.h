#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace sightline {

/// \throws std::invalid_argument where there are not as many results as points.
inline void require_as_many(std::size_t points, std::size_t results) {
  if (points == results) return;
  throw std::invalid_argument("expected as many results as points, " + std::to_string(points) + ", found " +
                              std::to_string(results));
}

}  // namespace sightline
