#include "bench/solids/povray.h"

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "bench/run_program.h"

namespace sightline::bench {
namespace {

/// The number behind the first `before` that comes after the first `start`.
double number_in(const std::string& text, std::string_view start, std::string_view before) {
  const std::size_t from = text.find(start);
  const std::size_t at = from == std::string::npos ? from : text.find(before, from);
  double number = 0;
  if (at == std::string::npos ||
      std::from_chars(text.data() + at + before.size(), text.data() + text.size(), number).ec != std::errc()) {
    throw std::runtime_error("expected '" + std::string(start) + "' in POV-Ray's statistics, found none");
  }
  return number;
}

/// Binary PPM with two bytes a channel, of which all are the same; the header may have comments.
Picture picture_of(const std::string& bytes) {
  std::istringstream in(bytes);
  const auto next = [&] {
    std::string word;
    while (in >> word && word.front() == '#') in.ignore(static_cast<std::streamsize>(bytes.size()), '\n');
    return word;
  };
  const bool is_ppm = next() == "P6";
  const int width = std::atoi(next().c_str()), height = std::atoi(next().c_str()), most = std::atoi(next().c_str());
  in.get();
  const auto begin = static_cast<std::size_t>(in.tellg());
  Picture picture(width, height);
  if (!is_ppm || most != 65535 || bytes.size() != begin + 6 * picture.size())
    throw std::runtime_error("expected a PPM with 16 bits a channel from POV-Ray, found something else");
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[begin + 6 * i + k]); };
    picture.shades[i] = static_cast<float>(256 * byte(0) + byte(1)) / 65535.0f;
  }
  return picture;
}

}  // namespace

Povray::Povray()
    : source_(folder_.path() / "scene.pov"), log_(folder_.path() / "log"), picture_(folder_.path() / "picture.ppm") {}

std::optional<Povray> Povray::find() {
  Povray povray;
  if (run_program({"povray", "--version"}, povray.log_) == no_such_program) return std::nullopt;
  std::istringstream lines(text_in(povray.log_));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("POV-Ray ")) povray.version_ = line.substr(8);
  }
  if (povray.version_.empty()) return std::nullopt;
  return povray;
}

std::string Povray::run(const std::string& scene, int width, int height, const std::string& output) {
  std::ofstream(source_) << scene;
  std::vector<std::string> words{"povray", "+I" + source_.string(), "+W" + std::to_string(width),
                                 "+H" + std::to_string(height), "File_Gamma=1.0"};
  std::istringstream options(std::string(povray_options) + ' ' + output);
  for (std::string word; options >> word;) words.push_back(word);
  const int code = run_program(words, log_);
  std::string text = text_in(log_);
  if (code != 0) throw std::runtime_error("POV-Ray failed with exit code " + std::to_string(code) + ":\n" + text);
  return text;
}

Picture Povray::paint(const std::string& scene, int width, int height) {
  run(scene, width, height, "+FP16 +O" + picture_.string());
  return picture_of(text_in(picture_));
}

Povray::TraceTime Povray::trace(const std::string& scene, int width, int height) {
  const std::string text = run(scene, width, height, "-F");
  return {number_in(text, "Trace Time", "thread(s) with "), number_in(text, "Trace Time", "(")};
}

}  // namespace sightline::bench
