#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace sightline {

/// Reads a text line by line and word by word, and names the line where something else was expected.
class TextReader {
 public:
  TextReader(std::filesystem::path path, std::string_view text) : path_(std::move(path)), text_(text) {}

  /// Moves to the next line; false at the end of the text.
  bool next_line();
  /// Moves to the next line that has words before any '#'; false at the end of the text.
  bool next_filled_line();

  /// The next word of the line, words being separated by blanks; empty at the end of the line.
  std::string_view word();
  bool has_word();

  /// The next word as a number that is finite as a float.
  float number(std::string_view expected);
  /// The next word as a whole number. What does not fit is taken as the nearest that does.
  std::int64_t integer(std::string_view expected);
  std::int64_t to_integer(std::string_view word, std::string_view expected) const;
  /// The next word as a number of a list: 0 ... count - 1.
  std::uint32_t index(std::string_view expected, std::int64_t count);
  /// Throws unless a polygon may have so many corners.
  void check_corners(std::int64_t corners) const;

  /// Lines from 1; 0 before the first.
  std::size_t line() const { return line_; }
  /// Bytes up to the end of the line, its end included.
  std::size_t offset() const { return offset_; }

  [[noreturn]] void fail(std::string_view expected, std::string_view found) const;
  [[noreturn]] void fail_at_end(std::string_view expected) const { fail(expected, "the end of the file"); }

 private:
  std::filesystem::path path_;
  std::string_view text_;
  std::string_view rest_;  ///< Of the line.
  std::size_t offset_ = 0;
  std::size_t line_ = 0;
};

}  // namespace sightline
