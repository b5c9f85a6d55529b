#include "bench/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace sightline::bench {
namespace {

const auto quiet = [](const std::string&) {};

TEST(Rotation, TimesEachLineOnceARoundAndBeginsWithTheNext) {
  for (const std::size_t lines : {1, 2, 3, 5, 6, 22}) {
    std::vector<std::vector<std::size_t>> rounds(50);
    in_rotation({rounds.size(), lines}, quiet, [&](std::size_t line, std::size_t round) {
      rounds[round].push_back(line);
      return 0.0;
    });
    for (std::size_t round = 0; round < rounds.size(); ++round) {
      EXPECT_EQ(rounds[round].front(), round % lines);
      std::sort(rounds[round].begin(), rounds[round].end());
      ASSERT_EQ(rounds[round].size(), lines);
      for (std::size_t line = 0; line < lines; ++line) EXPECT_EQ(rounds[round][line], line);
    }
  }
}

/// What one leaves in the caches is not always to the same one's good.
TEST(Rotation, EachComesBehindEachOfFive) {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  std::size_t last_round = 0, last_line = 0;
  in_rotation({40, 5}, quiet, [&](std::size_t line, std::size_t round) {
    if (round == last_round && line != last_line) pairs.insert({last_line, line});
    last_round = round, last_line = line;
    return 0.0;
  });
  EXPECT_EQ(pairs.size(), 5u * 4);
}

TEST(Rotation, WhatHasTakenLongSitsOut) {
  std::vector<int> counts(3);
  in_rotation({10, 3, 1.0}, quiet, [&](std::size_t line, std::size_t) {
    ++counts[line];
    return line == 1 ? 0.4 : 0.0;
  });
  EXPECT_EQ(counts, (std::vector<int>{10, 3, 10}));
}

}  // namespace
}  // namespace sightline::bench
