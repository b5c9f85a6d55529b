#pragma once
/// What sightline-probe answers.

#include <cstddef>
#include <string>
#include <string_view>

#include "sightline/math/level.h"

namespace sightline::probe {

/// One line of JSON, without its end.
struct Answer {
  std::string text;
  bool is_good;  ///< The question was understood; else `text` says why not.
};

/// Answers a question, a line of JSON that may be anything at all. `number` is its line's, from 1.
Answer answer(std::string_view question, std::size_t number, Level level);

/// To a line that is not read to its end.
Answer refuse_long_line(std::size_t longest, std::size_t number);

}  // namespace sightline::probe
