#include "sightline/render/film_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sightline {
namespace {

TEST(FilmImage, HasMeansAndWhatWasAskedFor) {
  FilmState film = blank_film(2, 1, 4, 0, FactsAsked::with_work);
  film.sums[0].add({1, 2, 4});
  film.sums[0].add({3, 2, 0});
  film.facts[0] = {7.5f, {0, 1, 0}, 12, 99};
  constexpr std::array all{Aov::depth, Aov::normal, Aov::id, Aov::cost, Aov::samples};
  const LayeredImage image = picture_of(film, 1, all);
  EXPECT_EQ(image.channels,
            (std::vector<std::string>{"R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "id", "cost", "samples"}));
  const std::vector<float> pixel{4, 4, 4, 7.5f, 0, 1, 0, 12, 99, 2};
  EXPECT_EQ(std::vector<float>(image.pixels.begin(), image.pixels.begin() + 10), pixel);
  const std::vector<float> empty{0, 0, 0, INFINITY, 0, 0, 0, -1, 0, 0};
  EXPECT_EQ(std::vector<float>(image.pixels.begin() + 10, image.pixels.end()), empty);
  EXPECT_EQ(picture_of(film, Aov::id).pixels, (std::vector<float>{12, -1}));
  EXPECT_EQ(picture_of(film, -1).pixels[0], 1);
}

TEST(FilmImage, AsksForNoMoreFactsThanItShows) {
  const auto asked = [](std::vector<Aov> aovs) { return facts_for(aovs); };
  EXPECT_EQ(asked({}), FactsAsked::none);
  EXPECT_EQ(asked({Aov::samples}), FactsAsked::none);
  EXPECT_EQ(asked({Aov::samples, Aov::depth}), FactsAsked::seen);
  EXPECT_EQ(asked({Aov::cost, Aov::depth}), FactsAsked::with_work);
}

}  // namespace
}  // namespace sightline
