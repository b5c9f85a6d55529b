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

/// The order of lines in a round. Each round begins with the next line and goes on in another stride, so that whatever
/// slows the machine for a while meets all of them, and none always comes behind the same one, whose data it may find
/// in the caches.
class Turns {
 public:
  explicit Turns(std::size_t lines) : lines_(lines) {
    for (std::size_t stride = 2; stride < lines; ++stride) {
      if (std::gcd(stride, lines) == 1) strides_.push_back(stride);  // meets every line
    }
  }
  std::size_t line(std::size_t round, std::size_t turn) const {
    return (turn * strides_[round % strides_.size()] + round) % lines_;
  }

 private:
  std::size_t lines_;
  std::vector<std::size_t> strides_{1};
};

/// Times all lines once a round. time(line, round) returns the seconds that it took; tell(text) is told of each round.
template <class Tell, class Time>
void in_rotation(const Rotation& rotation, const Tell& tell, const Time& time) {
  const std::size_t lines = rotation.lines;
  const Turns turns(lines);
  std::vector<double> spent(lines);
  for (std::size_t round = 0; round < rotation.rounds; ++round) {
    tell("round " + std::to_string(round + 1) + " of " + std::to_string(rotation.rounds));
    for (std::size_t k = 0; k < lines; ++k) {
      const std::size_t line = turns.line(round, k);
      if (spent[line] <= rotation.line_seconds) spent[line] += time(line, round);
    }
  }
}

}  // namespace sightline::bench
