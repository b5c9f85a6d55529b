#include "viz/noise/field_flags.h"

#include "viz/view_options.h"

namespace sightline::viz {
namespace {

template <class Infos>
std::string names_of(const Infos& infos) {
  std::string names;
  for (std::size_t i = 0; i < infos.size(); ++i) {
    names += (i == 0 ? "" : i + 1 == infos.size() ? " or " : ", ") + std::string(infos[i].name);
  }
  return names;
}

template <class Infos>
std::size_t index_of(const Infos& infos, const std::string& option, const std::string& text) {
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (infos[i].name == text) return i;
  }
  throw UsageError(option + ' ' + text + ": expected " + names_of(infos));
}

}  // namespace

FieldFlags::FieldFlags(CLI::App& command) {
  command.add_option("--kind", kind_, names_of(noise_infos) + "; default perlin")->option_text("KIND");
  command.add_option("--ease", ease_, "Of perlin and value: cubic or quintic; default cubic")->option_text("EASE");
  command.add_option("--seed", options_.noise.seed, "Another seed, another noise; default 0")->option_text("N");
  command
      .add_option("--period", options_.noise.period, "After as many cells it repeats: a power of two; default 0, never")
      ->option_text("CELLS");
  command.add_option("--fractal", fractal_, names_of(fractal_infos) + "; default none")->option_text("KIND");
  command.add_option("--octaves", options_.octaves, "Of a fractal, 1 to 32; default 5")->option_text("N");
  command.add_option("--lacunarity", options_.lacunarity, "How much finer each octave is; default 2")
      ->option_text("FACTOR");
  command.add_option("--gain", options_.gain, "How strong each octave is beside the one before; default 0.5")
      ->option_text("FACTOR");
  command.add_option("--frequency", options_.frequency, "Lattice cells per unit of length; default 1")
      ->option_text("F");
  command.add_option("--warp", options_.warp, "How many cells noise moves points by before; default 0")
      ->option_text("CELLS");
}

FieldOptions FieldFlags::options() const {
  FieldOptions options = options_;
  options.noise.kind = noise_infos[index_of(noise_infos, "--kind", kind_)].kind;
  options.noise.ease = ease_infos[index_of(ease_infos, "--ease", ease_)].ease;
  options.fractal = fractal_infos[index_of(fractal_infos, "--fractal", fractal_)].kind;
  return options;
}

}  // namespace sightline::viz
