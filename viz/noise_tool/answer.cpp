#include "viz/noise_tool/answer.h"

#include <array>
#include <charconv>
#include <istream>
#include <ostream>
#include <span>
#include <stdexcept>
#include <vector>

namespace sightline::noise_tool {
namespace {

constexpr std::size_t batch_size = 4096;
/// Longer ones are no points.
constexpr std::size_t longest_line = 4096;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

template <class T>
void append(std::string& text, T number) {
  std::array<char, 64> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end);
}

std::string shown(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string text(word.substr(0, most));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return '\'' + text + (word.size() > most ? "...'" : "'");
}

/// Points of one number of coordinates that follow each other, answered together.
class Batch {
 public:
  Batch(const NoiseField& field, const Request& request) : field_(field), request_(request) {}

  bool takes(const Point& point) const {
    return points_.empty() || (point.dims == dims_ && points_.size() < batch_size);
  }
  void add(const Point& point) {
    dims_ = point.dims;
    points_.push_back(point.p);
  }

  /// Lines for all, and none are left.
  void answer(std::string& text) {
    if (points_.empty()) return;
    const bool is_float = request_.precision == Level::fast;
    if (dims_ == 2) {
      is_float ? answer_as<2, float>(text) : answer_as<2, double>(text);
    } else {
      is_float ? answer_as<3, float>(text) : answer_as<3, double>(text);
    }
    points_.clear();
  }

 private:
  template <int dims, class T>
  void answer_as(std::string& text) const {
    std::vector<glm::vec<dims, T>> points;
    for (const glm::dvec3& p : points_) points.emplace_back(p);
    const T footprint = static_cast<T>(request_.footprint);
    if (request_.has_gradient) {
      std::vector<NoiseSample<T, dims>> samples(points.size());
      field_.samples<dims, T>(points, samples, footprint);
      for (const auto& sample : samples) {
        append_number(text, sample.value);
        for (int axis = 0; axis < dims; ++axis) append_number(text += ' ', sample.gradient[axis]);
        text += '\n';
      }
    } else {
      std::vector<T> values(points.size());
      field_.values<dims, T>(points, values, footprint);
      for (const T value : values) {
        append_number(text, value);
        text += '\n';
      }
    }
  }

  const NoiseField& field_;
  const Request& request_;
  int dims_ = 3;
  std::vector<glm::dvec3> points_;
};

}  // namespace

void append_number(std::string& text, double number) { append(text, number); }
void append_number(std::string& text, float number) { append(text, number); }

Point parse_point(std::string_view line) {
  std::array<double, 3> numbers{};
  std::size_t count = 0, at = 0;
  const auto fail = [&](const std::string& expected, const std::string& found) {
    throw std::invalid_argument("column " + std::to_string(at + 1) + ": expected " + expected + ", found " + found);
  };
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at])) ++at;
  };
  for (;;) {
    skip_blanks();
    if (count > 0 && at < line.size() && line[at] == ',') {
      ++at;
      skip_blanks();
      if (at == line.size()) fail("a number after the comma", "the end of the line");
    }
    if (at == line.size()) break;
    const std::size_t end = line.find_first_of(", \t\r\v\f", at);
    const std::string_view word = line.substr(at, end == line.npos ? line.npos : end - at);
    if (count == numbers.size()) fail("two or three numbers", shown(word));
    const char* first = word.data();
    const char* const last = word.data() + word.size();
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') ++first;
    const auto [stop, error] = std::from_chars(first, last, numbers[count]);
    if (stop != last || error == std::errc::invalid_argument) fail("a number", shown(word));
    if (error == std::errc::result_out_of_range) fail("a number that is finite as a double", shown(word));
    ++count;
    at += word.size();
  }
  if (count < 2) fail("two or three numbers", "the end of the line after " + std::to_string(count));
  return {static_cast<int>(count), {numbers[0], numbers[1], numbers[2]}};
}

std::size_t answer_points(const NoiseField& field, const Request& request, std::istream& in, std::ostream& out,
                          std::ostream& errors) {
  Batch batch(field, request);
  std::size_t bad_lines = 0, number = 0;
  std::string line, text;
  const auto write = [&] {
    batch.answer(text);
    out << text << std::flush;
    if (!out) throw std::runtime_error("cannot write the answers");
    text.clear();
  };
  while (std::getline(in, line)) {
    ++number;
    const std::size_t begin = line.find_first_not_of(" \t\r\v\f");
    if (begin != line.npos && line[begin] != '#') {
      try {
        if (line.size() > longest_line) {
          throw std::invalid_argument("expected a line of at most " + std::to_string(longest_line) +
                                      " characters, found " + std::to_string(line.size()));
        }
        const Point point = parse_point(line);
        if (!batch.takes(point)) write();
        batch.add(point);
      } catch (const std::invalid_argument& error) {
        ++bad_lines;
        errors << "sightline-noise: line " << number << ": " << error.what() << '\n';
      }
    }
    // Whoever waits for an answer before asking on gets it.
    if (in.rdbuf()->in_avail() <= 0) write();
  }
  write();
  if (in.bad()) throw std::runtime_error("cannot read on");
  return bad_lines;
}

}  // namespace sightline::noise_tool
