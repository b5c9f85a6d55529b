#include "bench/accuracy/front.h"

#include <cmath>

namespace sightline::bench {
namespace {

Standing standing_of(std::span<const Candidate> candidates, std::size_t own) {
  const Candidate& candidate = candidates[own];
  Standing standing;
  if (std::isnan(candidate.error)) return standing;
  standing.place = Place::on_front;
  for (std::size_t other = 0; other < candidates.size(); ++other) {
    if (other == own || !(candidates[other].error <= candidate.error)) continue;
    const auto ratio = paired_ratio(candidate.round_seconds, candidates[other].round_seconds);
    if (!ratio) continue;
    const bool is_resolved = ratio->confidence >= 0.95;
    if (is_resolved && ratio->high < 1) continue;
    const Place place = is_resolved && ratio->low > 1 ? Place::dominated : Place::not_resolved;
    const bool is_stronger = place == standing.place ? ratio->median > standing.ratio.median
                                                     : place == Place::dominated || standing.place == Place::on_front;
    if (is_stronger) standing = {place, other, *ratio};
  }
  return standing;
}

}  // namespace

std::vector<Standing> standings(std::span<const Candidate> candidates) {
  std::vector<Standing> all;
  for (std::size_t i = 0; i < candidates.size(); ++i) all.push_back(standing_of(candidates, i));
  return all;
}

std::string_view name_of(Place place) {
  switch (place) {
    case Place::on_front:
      return "front";
    case Place::dominated:
      return "dominated";
    case Place::not_resolved:
      return "not resolved";
    case Place::unknown:
      break;
  }
  return "unknown";
}

}  // namespace sightline::bench
