/// sightline-noise: what noise is at points, asked and answered in lines of numbers, or drawn as a slice.

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "viz/noise_tool/answer.h"
#include "viz/noise_tool/field_flags.h"
#include "viz/noise_tool/slice.h"
#include "viz/run_tool.h"

namespace sightline::noise_tool {
namespace {

constexpr const char* about = R"(Answers what noise is at points: reads lines of numbers, and writes one line for each.

  x y z    a point in space: its value, and with --gradient also the derivatives along x, y and z
  x y      a point in the plane, where noise has a lattice of its own (improved noise: the slice at z = 0)

Numbers are apart by blanks or commas. Answers are the shortest digits that are read back as the same number; the
gradient is exact, no difference of values. Blank lines and those that begin with # are skipped. A line that is no point
is told on the standard error, with its number and column, and the others are answered.

Noise is random and yet the same whenever it is asked: a lattice point gets a gradient (perlin, improved) or a value
(value) by hashing its coordinates, and between lattice points they are eased over. It lives within a band of
frequencies, about a cycle a cell, so that a sum over octaves, each lacunarity times as fine and gain times as strong as
the one before, can be made to look like clouds, marble or mountains.)";

constexpr const char* examples = R"(
Examples
  echo '0.5 0.5 0.5' | sightline-noise --kind improved                -0.25
  echo '3.14 42 7' | sightline-noise --kind improved --gradient
  sightline-noise --in points.txt --fractal fbm --octaves 6 --gain 0.5
  sightline-noise --image clouds.png --fractal fbm --extent 4 --size 800x600
  sightline-noise --image slice.exr --slice z=0.5                         values as they are

Exit status: 0 all lines were answered, 1 some could not be, or a file could not be read or written, 2 wrong usage.
)";

struct Words {
  std::string precision = "precise", size = "512x512", slice = "z=0";
};

void add_options(CLI::App& app, Request& request, Words& words) {
  const auto text = [](auto number) { return "; default " + CLI::detail::to_string(number); };
  app.add_option(
         "--footprint", request.footprint,
         "Width of what a value stands for: octaves too fine for it fade to their mean" + text(request.footprint))
      ->option_text("WIDTH");
  app.add_flag("--gradient", request.has_gradient, "After the value, its exact derivatives");
  app.add_option("--precision", words.precision,
                 "default precise"
                 "\n  fast: float throughout"
                 "\n  precise: double")
      ->option_text("fast|precise");
  app.add_option("--in", request.in, "Lines of points; normally, and for -, those of the standard input")
      ->option_text("FILE");
}

void add_image_options(CLI::App& app, Request& request, Words& words, std::vector<CLI::Option*>& of_image) {
  app.add_option("--image", request.image,
                 "Writes a slice instead of reading points; the extension says the format. EXR and TIFF hold values as "
                 "they are; in PNG and the like -1 is black and 1 is white, times the sum of all amplitudes")
      ->option_text("FILE");
  of_image = {app.add_option("--size", words.size, "Pixels of the slice; default 512x512")->option_text("WxH"),
              app.add_option("--slice", words.slice, "Where space is cut; default z=0")->option_text("z=POSITION"),
              app.add_option("--extent", request.slice.extent, "Cells across, around the origin; default 8")
                  ->option_text("CELLS")};
}

void require(bool is_good, const std::string& expected, double found) {
  if (is_good) return;
  std::string number;
  append_number(number, found);
  throw std::invalid_argument(expected + ", found " + number);
}

int run(int argc, char** argv) {
  CLI::App app(about, "sightline-noise");
  app.footer(examples);
  Request request;
  Words words;
  std::vector<CLI::Option*> of_image;
  const FieldFlags flags(app);
  add_options(app, request, words);
  add_image_options(app, request, words, of_image);
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;
  request.field = flags.options();
  request.precision = parse_precision(words.precision);
  parse_size(words.size, request.slice);
  request.slice.z = parse_slice(words.slice);
  require(request.footprint >= 0, "--footprint: expected a width of at least 0", request.footprint);
  require(request.slice.extent > 0 && std::isfinite(request.slice.extent),
          "--extent: expected a number of cells above 0", request.slice.extent);
  const NoiseField field(request.field);

  if (!request.image.empty()) {
    if (request.in != "-") throw std::invalid_argument("--image: expected either --image or --in, found both");
    if (request.has_gradient) throw std::invalid_argument("--image: expected values alone, found --gradient");
    write_slice(field, request);
    return success;
  }
  for (const CLI::Option* option : of_image) {
    if (option->count() > 0) throw std::invalid_argument(option->get_name() + ": expected with --image, found without");
  }
  if (request.in != "-") {
    std::ifstream in(request.in, std::ios::binary);
    if (!in || (in.peek() == std::ifstream::traits_type::eof() && in.bad())) {
      throw std::runtime_error(request.in + ": cannot be read");
    }
    return answer_points(field, request, in, std::cout, std::cerr) == 0 ? success : failure;
  }
  if (isatty(STDIN_FILENO)) {
    std::cerr << "sightline-noise: waiting for points, a line each: x y z, or x y; Ctrl-D ends. --help tells more\n";
  }
  return answer_points(field, request, std::cin, std::cout, std::cerr) == 0 ? success : failure;
}

}  // namespace
}  // namespace sightline::noise_tool

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  return sightline::run_tool("sightline-noise", [&] { return sightline::noise_tool::run(argc, argv); });
}
