#pragma once
/// Points as lines of text, and what noise is there as lines of text.

#include <iosfwd>
#include <string>
#include <string_view>

#include "sightline/noise/noise_field.h"
#include "viz/noise_tool/request.h"

namespace sightline::noise_tool {

/// Two coordinates or three.
struct Point {
  int dims = 3;
  glm::dvec3 p{0};
};

/// Numbers apart by blanks or commas.
/// \throws std::invalid_argument: in which column, what was expected and what was found.
Point parse_point(std::string_view line);

/// The shortest digits that are read back as the same number.
void append_number(std::string& text, double number);
void append_number(std::string& text, float number);

/// Answers line by line, in batches, and at once where no more has come yet. Blank lines and those that begin with #
/// are skipped, bad ones are told to `errors`. Returns how many those were. \throws std::runtime_error where `out`
/// fails.
std::size_t answer_points(const NoiseField& field, const Request& request, std::istream& in, std::ostream& out,
                          std::ostream& errors);

}  // namespace sightline::noise_tool
