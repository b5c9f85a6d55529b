#include "sightline/render/film_image.h"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

/// Ids and counts below 2^24 are exact.
void add_values(const FilmState& film, std::size_t pixel, Aov aov, std::vector<float>& values) {
  const PixelFacts& facts = film.facts[pixel];
  switch (aov) {
    case Aov::depth:
      values.push_back(facts.depth);
      break;
    case Aov::normal:
      values.insert(values.end(), {facts.normal.x, facts.normal.y, facts.normal.z});
      break;
    case Aov::id:
      values.push_back(facts.object == PixelFacts::no_object ? -1 : static_cast<float>(facts.object));
      break;
    case Aov::cost:
      values.push_back(static_cast<float>(facts.work));
      break;
    case Aov::samples:
      values.push_back(static_cast<float>(film.sums[pixel].samples));
  }
}

void add_channels(Aov aov, std::vector<std::string>& channels) {
  for (const std::string_view channel : info_of(aov).channels) {
    if (!channel.empty()) channels.emplace_back(channel);
  }
}

}  // namespace

FactsAsked facts_for(std::span<const Aov> aovs) {
  FactsAsked asks = FactsAsked::none;
  for (const Aov aov : aovs) {
    if (aov == Aov::cost) return FactsAsked::with_work;
    if (aov != Aov::samples) asks = FactsAsked::seen;
  }
  return asks;
}

LayeredImage picture_of(const FilmState& film, double exposure, std::span<const Aov> aovs) {
  LayeredImage image{film.width, film.height, {"R", "G", "B"}, {}, false, {}};
  for (const Aov aov : aovs) add_channels(aov, image.channels);
  image.pixels.reserve(film.sums.size() * image.channels.size());
  const double gain = std::exp2(exposure);
  for (std::size_t i = 0; i < film.sums.size(); ++i) {
    const PixelSum& sum = film.sums[i];
    const double scale = gain / std::max(sum.samples, 1u);
    for (int channel = 0; channel < 3; ++channel)
      image.pixels.push_back(static_cast<float>(sum.color[channel] * scale));
    for (const Aov aov : aovs) add_values(film, i, aov, image.pixels);
  }
  return image;
}

LayeredImage picture_of(const FilmState& film, Aov aov) {
  LayeredImage image{film.width, film.height, {}, {}, false, {}};
  add_channels(aov, image.channels);
  for (std::size_t i = 0; i < film.sums.size(); ++i) add_values(film, i, aov, image.pixels);
  return image;
}

}  // namespace sightline
