#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/query/accelerator_spec.h"
#include "viz/partition_picture.h"

namespace sightline::viz {

/// A wrong command line: reported in one line, exit status 2.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// \throws UsageError "--zoom nan: expected ..."
[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& expected);

/// CLI::Range lets pass what is no number; this does not. \throws UsageError
void require_number(const std::string& option, double value);

struct DepthRange {
  int shallowest = 0;
  std::optional<int> deepest;
};

/// "2:7", "2:", ":7" or "4"; `deepest` is given. \throws UsageError that names the option.
DepthRange parse_depth(const std::string& text, const std::string& option = "--depth");
/// So many finite numbers between separators; nothing where the text is not that.
std::optional<std::vector<double>> finite_numbers(std::string_view text, std::size_t count, char separator);
/// "y=0.5". \throws UsageError
Slice parse_slice(const std::string& text);
/// --accel and --set, of one structure that the registry knows and allows. \throws UsageError
AcceleratorSpec parse_structure(const std::string& text, const std::vector<std::string>& settings);
/// "1200x900". \throws UsageError
struct PictureSize {
  int width, height;
};
PictureSize parse_size(const std::string& text);
/// The same, no smaller than `least`. \throws UsageError
PictureSize parse_size(const std::string& text, const PictureSize& least);
/// The same for what can be read from Picture::lowest_width and lowest_height on. \throws UsageError
template <class Picture>
PictureSize parse_size_of(const std::string& text) {
  return parse_size(text, {Picture::lowest_width, Picture::lowest_height});
}

/// "OX,OY,OZ,DX,DY,DZ". \throws UsageError
Ray<float> parse_ray(const std::string& option, const std::string& text);
/// From the top left corner of a picture.
struct Pixel {
  int x, y;
};
/// "X,Y", two whole numbers; nothing where the text is not that.
std::optional<Pixel> pixel_in(const std::string& text);

/// In lower case, with its dot: ".png".
std::string extension_of(const std::string& path);

}  // namespace sightline::viz
