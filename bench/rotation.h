#pragma once

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace sightline::bench {

struct Rotation {
  std::size_t rounds = 1, lines = 1;
  double line_seconds = 60;  ///< A line that has taken longer sits out the rest.
};

/// Times all lines once a round. Each round begins with the next line and goes on in another stride, so that whatever
/// slows the machine for a while meets all of them, and none always comes behind the same one. time(line, round)
/// returns the seconds that it took; tell(text) is told of each round.
template <class Tell, class Time>
void in_rotation(const Rotation& rotation, const Tell& tell, const Time& time) {
  const std::size_t lines = rotation.lines;
  std::vector<std::size_t> strides{1};
  for (std::size_t stride = 2; stride < lines; ++stride) {
    if (std::gcd(stride, lines) == 1) strides.push_back(stride);  // meets every line
  }
  std::vector<double> spent(lines);
  for (std::size_t round = 0; round < rotation.rounds; ++round) {
    tell("round " + std::to_string(round + 1) + " of " + std::to_string(rotation.rounds));
    for (std::size_t k = 0; k < lines; ++k) {
      const std::size_t line = (k * strides[round % strides.size()] + round) % lines;
      if (spent[line] <= rotation.line_seconds) spent[line] += time(line, round);
    }
  }
}

}  // namespace sightline::bench
