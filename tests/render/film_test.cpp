#include "sightline/render/film.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <thread>
#include <vector>

#include "sightline/render/exposure.h"
#include "tests/render/fake_source.h"

namespace sightline {
namespace {

const std::atomic<bool> never{false};

FilmState exposed(const PictureSource& source, double error_bound, const ExposureOptions& options = {},
                  FactsAsked asks = FactsAsked::none) {
  Film film(blank_film(source.width(), source.height(), source.samples(), error_bound, asks));
  EXPECT_TRUE(expose(film, source, options, never));
  return film.copy();
}

/// Stops itself after so many samples.
class StoppingSource : public FakeSource {
 public:
  using FakeSource::FakeSource;
  std::uint64_t most = 0;
  mutable std::atomic<bool> stops{false};

  Vec3d sample(int x, int y, std::uint32_t number) const override {
    if (asked >= most) stops = true;
    return FakeSource::sample(x, y, number);
  }
};

TEST(Film, PassesShowAPictureSoonAndGrow) {
  std::vector<std::uint32_t> ends{0};
  while (ends.back() < 100) ends.push_back(next_end_of_pass(ends.back(), 100));
  EXPECT_EQ(ends, (std::vector<std::uint32_t>{0, 1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 100}));
  EXPECT_EQ(next_end_of_pass(0xc000'0000u, 0xffff'ffffu), 0xffff'ffffu);
  EXPECT_EQ(next_end_of_pass(0, 1), 1u);
}

TEST(Film, TilesCoverThePictureOnceFromTheMiddle) {
  Film film(blank_film(100, 70, 4, 0));
  EXPECT_TRUE(film.open_tiles(32).empty());
  ASSERT_TRUE(film.begin_pass());
  for (const int side : {1, 7, 32, 1000}) {
    std::vector<int> covered(100 * 70);
    const std::vector<TileRect> tiles = film.open_tiles(side);
    for (const TileRect& tile : tiles) {
      EXPECT_LE(tile.width, side);
      EXPECT_LE(tile.height, side);
      for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x) ++covered.at(static_cast<std::size_t>(100 * y + x));
      }
    }
    EXPECT_EQ(covered, std::vector<int>(100 * 70, 1));
    const TileRect& first = tiles.front();
    EXPECT_LE(std::abs(first.x + side / 2 - 50), side);
    EXPECT_LE(std::abs(first.y + side / 2 - 35), side);
  }
}

TEST(Film, EveryPixelGetsAllSamplesWithoutABound) {
  const FakeSource source(37, 21, 11);
  const FilmState film = exposed(source, 0, {}, FactsAsked::with_work);
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 37; ++x) {
      PixelSum sum;
      for (std::uint32_t number = 0; number < 11; ++number) sum.add(source.sample(x, y, number));
      const auto pixel = static_cast<std::size_t>(37 * y + x);
      EXPECT_EQ(film.sums[pixel], sum);
      EXPECT_EQ(film.facts[pixel].object, static_cast<std::uint32_t>(x));
      EXPECT_EQ(film.facts[pixel].work, static_cast<std::uint32_t>(x) + 1);
    }
  }
  EXPECT_EQ(film.counters.camera_rays, 37u * 21u * 11u);
  EXPECT_EQ(film.counters[Effect::meshes], 37u * 21u * 11u);
}

TEST(Film, IsTheSameForAnyThreadsAndTiles) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 6);  // than there may be
  const FakeSource source(61, 45, 40);
  for (const double bound : {0.0, 0.02, 0.03}) {
    const FilmState film = exposed(source, bound, {.threads = 1});
    for (const int threads : {2, 5}) {
      for (const int side : {1, 7, 64})
        EXPECT_EQ(exposed(source, bound, {.threads = threads, .tile_side = side}), film);
    }
  }
}

TEST(Film, IsTheSameHoweverOftenItIsStopped) {
  const FakeSource whole(61, 45, 40);
  const FilmState film = exposed(whole, 0.025);
  for (const std::uint64_t step : {1u, 1000u, 5000u}) {
    StoppingSource source(61, 45, 40);
    FilmState state = blank_film(61, 45, 40, 0.025);
    int runs = 0;
    bool is_done = false;
    for (; !is_done; ++runs) {
      source.most = source.asked + step;
      source.stops = false;
      Film part(state);
      is_done = expose(part, source, {.threads = 2, .tile_side = 16 + runs % 3}, source.stops);
      state = part.copy();
    }
    EXPECT_GT(runs, 5);
    EXPECT_EQ(state, film);
    EXPECT_EQ(source.asked, whole.asked);
  }
}

TEST(Film, AdaptiveSamplingEndsPixelsThatAreKnown) {
  FakeSource source(64, 48, 512);
  source.scatter = 0.3;
  constexpr double bound = 0.01;  // of a standard deviation of 0.3 / sqrt(3): some 300 samples
  const FilmState film = exposed(source, bound);
  double squares = 0;
  int noisy = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const PixelSum& sum = film.sums[static_cast<std::size_t>(64 * y + x)];
      if (x < 31) {
        EXPECT_EQ(sum.samples, 8u);  // its neighbours at 32 scatter
      } else if (x > 32) {
        EXPECT_GE(sum.samples, 256u);
        EXPECT_LE(sum.samples, 384u);
        const double error = PixelSum::luminance(sum.color) / sum.samples - source.mean(x);
        squares += error * error;
        ++noisy;
      }
      if (sum.samples < 512) {
        EXPECT_LE(squared_error(film, x, y), bound * bound);
      }
    }
  }
  // The mean of some 1500 squares, each with a relative deviation of sqrt(2), is within 5 deviations below 1.2.
  EXPECT_LT(squares / noisy, 1.2 * bound * bound);
  EXPECT_LT(source.asked, 64u * 48u * 400u / 2 + 64u * 48u * 100u);
}

TEST(Film, BrightPixelsAreAllowedAShare) {
  struct Bright : FakeSource {
    using FakeSource::FakeSource;
    Vec3d sample(int x, int y, std::uint32_t number) const override { return 100.0 * FakeSource::sample(x, y, number); }
  };
  const Bright bright(32, 32, 256);
  // In the noisy half a deviation of 25 / sqrt(3), and 2% of some 68: 110 samples. Taken as it is, the bound would ask
  // for half a million.
  const FilmState film = exposed(bright, 0.02);
  for (int x = 18; x < 32; ++x) {
    EXPECT_GE(film.sums[static_cast<std::size_t>(x)].samples, 64u);
    EXPECT_LE(film.sums[static_cast<std::size_t>(x)].samples, 192u);
  }
}

/// One sample in 16 is bright: of 8 samples, none is so in more than half of the pixels.
struct RareSource : FakeSource {
  using FakeSource::FakeSource;
  Vec3d sample(int x, int y, std::uint32_t number) const override {
    Random random(Random::hash(static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x)) ^ number);
    return Vec3d(random.below(16) == 0 ? 4.0 : 0.0);
  }
};

TEST(Film, LuckyPixelsDoNotEndEarly) {
  const RareSource source(48, 48, 256);
  const FilmState film = exposed(source, 0.05);  // the deviation is 1: as many as there are
  std::size_t early = 0;
  for (const PixelSum& sum : film.sums) early += sum.samples < 96;
  EXPECT_LT(early, film.sums.size() / 200);
}

TEST(Film, WhatIsNotANumberGetsAllSamples) {
  struct Broken : FakeSource {
    using FakeSource::FakeSource;
    Vec3d sample(int x, int, std::uint32_t) const override { return Vec3d(x == 5 ? std::nan("") : 1.0); }
  };
  const Broken source(16, 4, 32);
  const FilmState film = exposed(source, 0.1);
  EXPECT_EQ(film.sums[5].samples, 32u);
  EXPECT_EQ(film.sums[0].samples, 8u);
}

TEST(Film, TellsHowFarItIs) {
  const FakeSource source(20, 10, 16);
  Film film(blank_film(20, 10, 16, 0));
  EXPECT_EQ(film.progress().done, 0u);
  EXPECT_EQ(film.progress().expected, 20u * 10u * 16u);
  expose(film, source, {}, never);
  EXPECT_EQ(film.progress().done, 20u * 10u * 16u);
  EXPECT_EQ(film.progress().expected, 20u * 10u * 16u);
  EXPECT_EQ(film.progress().counters.camera_rays, 20u * 10u * 16u);

  Film known(blank_film(20, 10, 16, 1.0));
  expose(known, source, {}, never);
  EXPECT_EQ(known.progress().done, 20u * 10u * 8u);
  EXPECT_EQ(known.progress().expected, 20u * 10u * 8u);
}

TEST(Film, KeepsWhatIsDoneWhereTheSourceFails) {
  struct Failing : FakeSource {
    using FakeSource::FakeSource;
    Vec3d sample(int x, int y, std::uint32_t number) const override {
      if (x == 40 && y == 3 && number == 1) throw std::runtime_error("no more");
      return FakeSource::sample(x, y, number);
    }
  };
  const Failing failing(64, 64, 4);
  Film film(blank_film(64, 64, 4, 0));
  EXPECT_THROW(expose(film, failing, {.tile_side = 8}, never), std::runtime_error);
  EXPECT_GE(film.progress().done, 64u * 64u);
  EXPECT_LT(film.progress().done, 64u * 64u * 2u);
  const FakeSource sound(64, 64, 4);
  EXPECT_TRUE(expose(film, sound, {}, never));
  EXPECT_EQ(film.copy(), exposed(sound, 0));
}

/// Threads of the test's own, which the thread sanitizer watches; TBB's it does not.
TEST(Film, CanBeCopiedAndGoneOnWithWhileItIsExposed) {
  const FakeSource source(48, 40, 24);
  const FilmState whole = exposed(source, 0.02);
  Film film(blank_film(48, 40, 24, 0.02));
  std::vector<FilmState> copies;
  while (film.begin_pass()) {
    const std::vector<TileRect> tiles = film.open_tiles(8);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < tiles.size(); i = next++) {
        TileTask task = film.task(tiles[i]);
        RenderCounters counters;
        expose_tile(task, source, counters);
        film.put(task, counters);
      }
    };
    const std::jthread first(work), second(work);
    copies.push_back(film.copy());
    EXPECT_LE(film.progress().done, film.progress().expected);
  }
  EXPECT_EQ(film.state(), whole);
  for (const FilmState& copy : copies) {
    std::uint64_t samples = 0;
    for (const PixelSum& sum : copy.sums) samples += sum.samples;
    EXPECT_EQ(copy.counters.camera_rays, samples);
    Film gone_on(copy);
    EXPECT_TRUE(expose(gone_on, source, {}, never));
    EXPECT_EQ(gone_on.state(), whole);
  }
}

TEST(Film, RefusesWhatIsNoFilm) {
  EXPECT_THROW(blank_film(0, 1, 1, 0), std::invalid_argument);
  EXPECT_THROW(blank_film(1, -1, 1, 0), std::invalid_argument);
  EXPECT_THROW(blank_film(1, 1, 0, 0), std::invalid_argument);
  EXPECT_THROW(blank_film(1, 1, 1, -1), std::invalid_argument);
  EXPECT_THROW(blank_film(1, 1, 1, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
