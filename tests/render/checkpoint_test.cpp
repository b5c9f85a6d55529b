#include "sightline/render/checkpoint.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "sightline/io/file_error.h"
#include "sightline/render/exposure.h"
#include "tests/io/temporary_folder.h"
#include "tests/render/fake_source.h"

namespace sightline {
namespace {

constexpr std::uint64_t fingerprint = 0x0123'4567'89ab'cdefu;

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Half way through a pass: every other tile of it.
FilmState half_done(int width, int height, std::uint32_t samples, double bound, FactsAsked asks = FactsAsked::none) {
  const FakeSource source(width, height, samples);
  Film film(blank_film(width, height, samples, bound, asks));
  for (std::uint32_t end = 0; end < std::min(samples, 12u); end = film.state().end_of_pass) {
    EXPECT_TRUE(film.begin_pass());
    const bool is_last = film.state().end_of_pass >= std::min(samples, 12u);
    const auto tiles = film.open_tiles(8);
    for (std::size_t i = 0; i < tiles.size(); i += is_last ? 2 : 1) {
      TileTask task = film.task(tiles[i]);
      RenderCounters counters;
      expose_tile(task, source, counters);
      film.put(task, counters);
    }
  }
  return film.copy();
}

std::string refusal(const std::filesystem::path& path, const FilmState& blank, std::uint64_t its_fingerprint) {
  try {
    read_checkpoint(path, blank, its_fingerprint);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST(Checkpoint, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.checkpoint";
  const FilmState film = half_done(33, 17, 64, 0.03);
  write_checkpoint(path, film, fingerprint);
  EXPECT_EQ(read_checkpoint(path, blank_film(33, 17, 64, 0.03), fingerprint), film);
  EXPECT_EQ(folder.count(), 1);
}

TEST(Checkpoint, GoesOnToTheSamePicture) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.checkpoint";
  const FakeSource source(33, 17, 64);
  const FilmState blank = blank_film(33, 17, 64, 0.03, FactsAsked::with_work);
  const std::atomic<bool> never{false};
  Film whole(blank);
  expose(whole, source, {}, never);

  write_checkpoint(path, half_done(33, 17, 64, 0.03, FactsAsked::with_work), source.fingerprint());
  Film resumed(read_checkpoint(path, blank, source.fingerprint()));
  EXPECT_GT(resumed.progress().done, 0u);
  expose(resumed, source, {.tile_side = 5}, never);
  EXPECT_EQ(resumed.state(), whole.state());
}

TEST(Checkpoint, OfAnotherPictureIsRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.checkpoint";
  write_checkpoint(path, half_done(16, 16, 32, 0.01), fingerprint);
  const auto says = [&](const FilmState& blank, std::uint64_t its_fingerprint, const std::string& text) {
    EXPECT_NE(refusal(path, blank, its_fingerprint).find(text), std::string::npos)
        << refusal(path, blank, its_fingerprint);
  };
  says(blank_film(16, 16, 32, 0.01), fingerprint + 1, "found that of another picture");
  says(blank_film(17, 16, 32, 0.01), fingerprint, "expected a checkpoint of 17 x 16 pixels, found 16 x 16");
  says(blank_film(16, 32, 32, 0.01), fingerprint, "expected a checkpoint of 16 x 32 pixels");
  says(blank_film(16, 16, 64, 0.01), fingerprint, "expected a checkpoint of 64 samples a pixel, found 32");
  says(blank_film(16, 16, 32, 0.01, FactsAsked::seen), fingerprint, "the same --aov");
  says(blank_film(16, 16, 32, 0.25), fingerprint, "error bound 0.25");
  EXPECT_EQ(refusal(path, blank_film(16, 16, 32, 0.01), fingerprint), "");

  folder.write("text", "no checkpoint at all\n");
  EXPECT_NE(refusal(folder.path() / "text", blank_film(1, 1, 1, 0), 0).find("this version"), std::string::npos);
  EXPECT_NE(refusal(folder.path() / "none", blank_film(1, 1, 1, 0), 0).find("none: expected"), std::string::npos);
  EXPECT_NE(refusal(folder.path(), blank_film(1, 1, 1, 0), 0), "");
}

TEST(Checkpoint, CutOffOrChangedIsRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.checkpoint";
  const FilmState blank = blank_film(5, 3, 32, 0.01);
  write_checkpoint(path, half_done(5, 3, 32, 0.01), fingerprint);
  const std::string bytes = contents(path);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) {
    EXPECT_NE(refusal(folder.write("cut", bytes.substr(0, size)), blank, fingerprint), "") << size;
  }
  EXPECT_NE(refusal(folder.write("longer", bytes + '\0'), blank, fingerprint), "");
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (1 << at % 8));
    EXPECT_NE(refusal(folder.write("changed", changed), blank, fingerprint), "") << at;
  }
}

/// The sum of the format, written once more: with it, what is broken inside gets as far as it can.
std::string with_sum(std::string bytes) {
  std::uint64_t sum = Random::hash(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    sum = Random::hash(sum ^ word) + word;
  }
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return bytes;
}

TEST(Checkpoint, MutantsAreRefusedOrSound) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.checkpoint";
  const FilmState blank = blank_film(6, 4, 32, 0.01);
  write_checkpoint(path, half_done(6, 4, 32, 0.01), fingerprint);
  const std::string seed = contents(path);
  const std::string body = seed.substr(0, seed.size() - 8);
  ASSERT_EQ(with_sum(body), seed);
  Random random(7);
  int read = 0;
  const auto anywhere = [&](const std::string& text) { return random.below(static_cast<std::uint32_t>(text.size())); };
  for (int i = 0; i < 1000; ++i) {
    std::string bytes = body;
    for (std::uint32_t changes = 1 + random.below(3); changes > 0 && !bytes.empty(); --changes) {
      const std::uint32_t at = random.below(2) ? anywhere(bytes) : random.below(64) % bytes.size();
      switch (random.below(5)) {
        case 0:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
          break;
        case 1:
          bytes[at] = static_cast<char>(random.next());
          break;
        case 2:
          for (std::size_t j = at; j < std::min<std::size_t>(at + 4, bytes.size()); ++j) bytes[j] = '\xff';
          break;
        case 3:
          bytes.resize(at);
          break;
        default:
          bytes.insert(at, bytes.substr(anywhere(bytes), 61));
      }
    }
    folder.write("mutant", with_sum(bytes));
    try {
      const FilmState film = read_checkpoint(folder.path() / "mutant", blank, fingerprint);
      ++read;
      // Whatever its pixels say, going on with it comes to an end.
      Film going_on(film);
      const FakeSource source(6, 4, 32);
      const std::atomic<bool> never{false};
      EXPECT_TRUE(expose(going_on, source, {}, never));
      for (const PixelSum& sum : going_on.state().sums) EXPECT_LE(sum.samples, 32u);
    } catch (const FileError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find('\n'), std::string::npos);
      EXPECT_NE(what.find(": expected "), std::string::npos) << what;
      EXPECT_NE(what.find(", found "), std::string::npos) << what;
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_LT(read, 950);
}

TEST(Checkpoint, ThatCannotBeWrittenIsToldOf) {
  EXPECT_THROW(write_checkpoint("/dev/full", blank_film(64, 64, 1, 0), 0), FileError);
  EXPECT_THROW(write_checkpoint("/proc/a.checkpoint", blank_film(1, 1, 1, 0), 0), FileError);
}

}  // namespace
}  // namespace sightline
