#pragma once
/// Families of questions that get harder by a number, until only what was made for it still answers.

#include <cstdint>
#include <string_view>

#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

struct Family {
  std::string_view name;
  std::string_view help;        ///< What is asked, and what is true.
  std::string_view difficulty;  ///< What the number k means.
  std::string_view unit;        ///< Of an axis of k, such as "k: distance 2^-k".
  int easiest, hardest;         ///< Limits of k.
  Oracle oracle;
  /// So many questions at one difficulty, told to the trial: answers of the library and of naive code, to the same
  /// questions. The same arguments give the same questions.
  void (*ask)(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial);
};

}  // namespace sightline::hard
