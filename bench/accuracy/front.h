#pragma once
/// Which choices are worth taking: those that no other beats in both error and time.

#include <span>
#include <string>
#include <vector>

#include "bench/estimate.h"

namespace sightline::bench {

/// What the front is made of: an error, which is known, and seconds of each round, which scatter.
struct Candidate {
  double error = 0;
  std::vector<double> round_seconds;
};

enum class Place {
  on_front,      ///< Nothing that is as accurate is faster.
  dominated,     ///< By one that is as accurate, and faster by an interval that excludes 1.
  not_resolved,  ///< One is as accurate, and which of the two is faster the rounds do not tell.
  unknown,       ///< Has no error to be placed by.
};

struct Standing {
  Place place = Place::unknown;
  std::size_t by = 0;  ///< Which one dominates, the fastest of those; or cannot be told apart.
  Estimate ratio{};    ///< This one's time over that one's, paired by round.
};

/// With fewer rounds no interval of medians has a confidence of 95 % (estimate.h), and nothing is resolved.
inline constexpr int least_rounds = 6;

/// By index. A choice without an error takes no part.
std::vector<Standing> standings(std::span<const Candidate> candidates);

std::string_view name_of(Place place);

}  // namespace sightline::bench
