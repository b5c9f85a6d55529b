#include "sightline/io/text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sightline/io/file_error.h"
#include "sightline/io/polygons.h"

namespace sightline {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  return word.empty() ? "the end of the line"
                      : "\"" + std::string(word.substr(0, longest)) + (word.size() > longest ? "...\"" : "\"");
}

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

bool TextReader::next_line() {
  if (offset_ >= text_.size()) return false;
  const std::size_t end = text_.find('\n', offset_);
  rest_ = text_.substr(offset_, end == std::string_view::npos ? end : end - offset_);
  offset_ = end == std::string_view::npos ? text_.size() : end + 1;
  ++line_;
  return true;
}

bool TextReader::next_filled_line() {
  while (next_line()) {
    rest_ = rest_.substr(0, rest_.find('#'));
    if (has_word()) return true;
  }
  return false;
}

bool TextReader::has_word() { return rest_.find_first_not_of(blanks) != std::string_view::npos; }

std::string_view TextReader::word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  const std::string_view found = rest_.substr(0, rest_.find_first_of(blanks));
  rest_.remove_prefix(found.size());
  return found;
}

float TextReader::number(std::string_view expected) {
  const std::string_view found = word(), digits = without_plus(found);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) fail(expected, quoted(found));
  // Out of range may mean too small as well, which strtod rounds to zero.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
  const auto narrow = static_cast<float>(value);
  if (!std::isfinite(narrow)) fail(std::string(expected) + ", finite as a float", quoted(found));
  return narrow;
}

std::int64_t TextReader::integer(std::string_view expected) { return to_integer(word(), expected); }

std::int64_t TextReader::to_integer(std::string_view word, std::string_view expected) const {
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) fail(expected, quoted(word));
  if (error == std::errc::result_out_of_range) {
    using limits = std::numeric_limits<std::int64_t>;
    return digits[0] == '-' ? limits::min() : limits::max();
  }
  return value;
}

std::uint32_t TextReader::index(std::string_view expected, std::int64_t count) {
  const std::int64_t found = integer(expected);
  if (found < 0 || found >= count || found > std::numeric_limits<std::uint32_t>::max()) {
    fail(std::string(expected) + " below " + std::to_string(count), std::to_string(found));
  }
  return static_cast<std::uint32_t>(found);
}

void TextReader::check_corners(std::int64_t corners) const {
  if (corners >= 3 && corners <= most_corners) return;
  fail("a polygon of 3 to " + std::to_string(most_corners) + " corners", std::to_string(corners));
}

void TextReader::fail(std::string_view expected, std::string_view found) const {
  throw FileError(path_, line_, std::string(expected), std::string(found));
}

}  // namespace sightline
