#include "viz/noise_tool/field_flags.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace sightline::noise_tool {
namespace {

/// "perlin|improved|value|white" and the like, of which `lines` has one with its description each.
struct Choices {
  std::string names, lines;
};

template <class Infos>
Choices choices_of(const Infos& infos) {
  Choices choices;
  for (const auto& info : infos) {
    choices.names += (choices.names.empty() ? "" : "|") + std::string(info.name);
    if constexpr (requires { info.description; }) {
      choices.lines += "\n  " + std::string(info.name) + ": " + std::string(info.description);
    }
  }
  return choices;
}

template <class Infos>
const auto& found(const char* flag, const Infos& infos, const std::string& text) {
  for (const auto& info : infos) {
    if (info.name == text) return info;
  }
  throw std::invalid_argument(std::string(flag) + ": expected one of " + choices_of(infos).names + ", found " + text);
}

}  // namespace

FieldFlags::FieldFlags(CLI::App& command) {
  const auto text = [](auto number) { return "; default " + CLI::detail::to_string(number); };
  command.add_option("--kind", kind_, "What lattice points give; default perlin" + choices_of(noise_infos).lines)
      ->option_text(choices_of(noise_infos).names);
  command
      .add_option("--ease", ease_,
                  "How perlin and value go from one lattice point to the next; default cubic"
                  "\n  cubic: 3 t^2 - 2 t^3, whose curvature jumps at lattice points"
                  "\n  quintic: 6 t^5 - 15 t^4 + 10 t^3, whose curvature does not")
      ->option_text(choices_of(ease_infos).names);
  command
      .add_option("--seed", options_.noise.seed,
                  "Another seed, another noise; default 0, of improved Perlin's own table")
      ->option_text("N");
  command
      .add_option("--period", options_.noise.period,
                  "Repeat after so many cells: a power of two up to 2^30; default 0, never (improved: always 256)")
      ->option_text("N");
  command.add_option("--fractal", fractal_, "What is made of octaves; default none" + choices_of(fractal_infos).lines)
      ->option_text(choices_of(fractal_infos).names);
  command.add_option("--octaves", options_.octaves, "Of a fractal, 1 to 32" + text(options_.octaves))->option_text("N");
  command
      .add_option("--lacunarity", options_.lacunarity,
                  "How much finer each octave is: above 1, at most 16" + text(options_.lacunarity))
      ->option_text("L");
  command
      .add_option("--gain", options_.gain, "How strong, of the one before: above 0, at most 1" + text(options_.gain))
      ->option_text("G");
  command.add_option("--frequency", options_.frequency, "Lattice cells per unit of length" + text(options_.frequency))
      ->option_text("F");
  command
      .add_option("--warp", options_.warp, "Move points by noise first, by up to so many cells" + text(options_.warp))
      ->option_text("CELLS");
}

FieldOptions FieldFlags::options() const {
  FieldOptions options = options_;
  options.noise.kind = found("--kind", noise_infos, kind_).kind;
  options.noise.ease = found("--ease", ease_infos, ease_).ease;
  options.fractal = found("--fractal", fractal_infos, fractal_).kind;
  return options;
}

double parse_slice(const std::string& text) {
  const std::string_view digits = std::string_view(text).substr(text.starts_with("z=") ? 2 : 0);
  double z = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), z);
  if (error == std::errc() && end == digits.data() + digits.size() && std::isfinite(z)) return z;
  throw std::invalid_argument("--slice: expected z=POSITION, a finite number, found " + text);
}

}  // namespace sightline::noise_tool
