#pragma once
/// What was exposed so far, and what is to be exposed next.
///
/// Samples come in passes, each of which brings the pixels that it wants to one number of samples; first all pixels to
/// one, so that there is a picture soon. Which pixels a pass wants is decided before it begins, from the film alone:
///   F1  What is on the film after a pass depends on the source, the number of samples and the error bound: not on
///       tiles, their order, threads, or whether another run was gone on with.
///   F2  A pixel that a pass wants and that has fewer samples than its end is open. No other is touched.

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "sightline/render/picture_source.h"

namespace sightline {

struct FilmState {
  int width = 0, height = 0;
  std::uint32_t samples = 1;  ///< The most of a pixel; at least 1.
  double error_bound = 0;     ///< As RenderSettings has it; a share of luminances above 1. 0: none.
  FactsAsked asks = FactsAsked::none;
  std::uint32_t end_of_pass = 0;  ///< Samples of pixels that the pass under way wants, once it is over.
  std::vector<PixelSum> sums;     ///< Row by row from the top.
  std::vector<PixelFacts> facts;
  std::vector<std::uint8_t> is_wanted;
  RenderCounters counters;

  bool is_open(std::size_t pixel) const { return is_wanted[pixel] && sums[pixel].samples < end_of_pass; }
  friend bool operator==(const FilmState&, const FilmState&) = default;
};

/// One that nothing was exposed on. \throws std::invalid_argument unless all are positive and the bound not negative.
FilmState blank_film(int width, int height, std::uint32_t samples, double error_bound,
                     FactsAsked asks = FactsAsked::none);

/// Where the pass after one that ends with so many samples ends: powers of two, and from 4 on also half way between.
std::uint32_t next_end_of_pass(std::uint32_t end, std::uint32_t samples);

/// The square of the standard error of a pixel's luminance. The scatter of its samples is taken for no less than that
/// of the 3 x 3 pixels around it, all samples together: few samples that agree by luck do not end a pixel whose
/// neighbours tell better. Infinite where a pixel has fewer than two samples.
double squared_error(const FilmState& film, int x, int y);

/// A tile, and its pixels that are open, by their place in it.
struct TileTask {
  TileBuffer tile;
  std::vector<std::uint32_t> open;
  std::uint32_t end_of_pass = 0;
  FactsAsked asks = FactsAsked::none;
};

/// Brings the open pixels of a tile to the end of the pass.
void expose_tile(TileTask& task, const PictureSource& source, RenderCounters& counters);

/// Samples, of all pixels together.
struct FilmProgress {
  std::uint64_t done = 0;
  std::uint64_t expected = 0;  ///< At the end; an upper limit where there is an error bound.
  std::uint32_t end_of_pass = 0;
  RenderCounters counters;
};

/// Safe to use from several threads, as long as the tiles under way share no pixel.
class Film {
 public:
  explicit Film(FilmState state);

  /// At any time.
  FilmState copy() const;
  /// No pass may be under way.
  const FilmState& state() const { return state_; }
  FilmProgress progress() const;

  /// Tiles of at most side x side pixels with open ones: from the middle of the picture outward, in rings.
  std::vector<TileRect> open_tiles(int side) const;
  TileTask task(const TileRect& rect) const;
  void put(const TileTask& task, const RenderCounters& counters);

  /// Decides what the next pass wants; no pixel may be open. False where none is wanted: the picture is done.
  bool begin_pass();

 private:
  void count_expected();

  mutable std::mutex mutex_;  ///< Guards all that is written.
  FilmState state_;
  std::uint64_t done_ = 0, expected_ = 0;
};

}  // namespace sightline
