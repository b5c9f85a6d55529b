#include "sightline/render/checkpoint.h"

#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "sightline/math/random.h"

namespace sightline {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are stored as they are in memory");

/// The last character counts versions: with each change of the format, or of what a sample is.
constexpr std::string_view magic = "sightline film 2";

/// Of bytes, eight at a time, and of how many they are.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = Random::hash(bytes.size());
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::string_view part = bytes.substr(0, sizeof word);
    std::memcpy(&word, part.data(), part.size());
    sum = Random::hash(sum ^ word) + word;
    bytes.remove_prefix(part.size());
  }
  return sum;
}

class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  std::string bytes;
};

/// Its bytes must be as many as are asked for.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  void operator()(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
  }

 private:
  std::string_view rest_;
};

/// Counts the bytes that the others move.
class Counter {
 public:
  template <class T>
  void operator()(const T&) {
    bytes += sizeof(T);
  }
  std::size_t bytes = 0;
};

template <class Archive, class State>
void move_head(Archive& archive, State& film, std::uint64_t& fingerprint) {
  archive(film.width), archive(film.height), archive(film.samples), archive(film.error_bound);
  archive(fingerprint), archive(film.asks), archive(film.end_of_pass);
  for (auto& count : film.counters.counts) archive(count);
  archive(film.counters.camera_rays), archive(film.counters.rays_cut_off);
  archive(film.counters.shadow_trials), archive(film.counters.shadow_rays_spared);
}

template <class Archive, class State>
void move_pixel(Archive& archive, State& film, std::size_t pixel) {
  auto& sum = film.sums[pixel];
  archive(sum.color.x), archive(sum.color.y), archive(sum.color.z), archive(sum.luminance_squares);
  archive(sum.samples), archive(sum.lamps_seen);
  auto& facts = film.facts[pixel];
  archive(facts.depth), archive(facts.normal.x), archive(facts.normal.y), archive(facts.normal.z);
  archive(facts.object), archive(facts.work);
  archive(film.is_wanted[pixel]);
}

struct Sizes {
  std::size_t head, pixel;
};
Sizes sizes() {
  FilmState film = blank_film(1, 1, 1, 0);
  std::uint64_t fingerprint = 0;
  Counter head, pixel;
  move_head(head, film, fingerprint);
  move_pixel(pixel, film, 0);
  return {magic.size() + head.bytes, pixel.bytes};
}

/// What a film that goes on relies on, beyond its sizes.
bool is_sound(const FilmState& film) {
  if (film.end_of_pass > film.samples) return false;
  for (std::size_t i = 0; i < film.sums.size(); ++i) {
    if (film.is_wanted[i] > 1 || film.sums[i].samples > film.end_of_pass) return false;
  }
  return true;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const FilmState& film, std::uint64_t fingerprint) {
  Writer writer;
  const auto [head, pixel] = sizes();
  writer.bytes.reserve(head + film.sums.size() * pixel + sizeof(std::uint64_t));
  writer.bytes = magic;
  move_head(writer, film, fingerprint);
  for (std::size_t i = 0; i < film.sums.size(); ++i) move_pixel(writer, film, i);
  writer(checksum(writer.bytes));
  write_text(path, writer.bytes);
}

FilmState read_checkpoint(const std::filesystem::path& path, const FilmState& blank, std::uint64_t fingerprint) {
  const auto require = [&](bool is_so, const std::string& expected, const std::string& found) {
    if (!is_so) throw FileError(path, 0, expected, found);
  };
  const std::string bytes = read_bytes(path);
  const std::string_view all = bytes;
  const auto [head, pixel] = sizes();
  constexpr std::size_t tail = sizeof(std::uint64_t);
  require(all.substr(0, magic.size()) == magic, "a checkpoint of this version of Sightline", "something else");
  require(all.size() >= head + tail, "a whole checkpoint", "only " + std::to_string(all.size()) + " bytes");
  std::uint64_t sum = 0;
  std::memcpy(&sum, all.data() + all.size() - tail, tail);
  require(sum == checksum(all.substr(0, all.size() - tail)), "a whole checkpoint",
          "one that was cut off or changed: its checksum is another");

  FilmState film;
  std::uint64_t found = 0;
  Reader heads(all.substr(magic.size()));
  move_head(heads, film, found);
  const auto size = [](const FilmState& of) { return std::to_string(of.width) + " x " + std::to_string(of.height); };
  require(film.width == blank.width && film.height == blank.height, "a checkpoint of " + size(blank) + " pixels",
          size(film));
  require(film.samples == blank.samples, "a checkpoint of " + std::to_string(blank.samples) + " samples a pixel",
          std::to_string(film.samples));
  require(film.error_bound == blank.error_bound, "a checkpoint of the error bound " + std::to_string(blank.error_bound),
          std::to_string(film.error_bound));
  require(film.asks == blank.asks, "a checkpoint with the same --aov", "other facts of pixels");
  require(found == fingerprint, "a checkpoint of this scene and these settings", "that of another picture");
  const std::size_t pixels = blank.sums.size();
  require(all.size() == head + pixels * pixel + tail, "a whole checkpoint", std::to_string(all.size()) + " bytes");

  film.sums.resize(pixels);
  film.facts.resize(pixels);
  film.is_wanted.resize(pixels);
  Reader reader(all.substr(head));
  for (std::size_t i = 0; i < pixels; ++i) move_pixel(reader, film, i);
  require(is_sound(film), "a checkpoint whose numbers fit together", "more samples than there are");
  return film;
}

}  // namespace sightline
