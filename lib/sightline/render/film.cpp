#include "sightline/render/film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace sightline {
namespace {

std::size_t index(const FilmState& film, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) + static_cast<std::size_t>(x);
}

/// No pixel stops before: the scatter of fewer samples says too little.
constexpr std::uint32_t fewest_samples = 8;

/// The sum of the squared distances of a pixel's luminances from their mean.
double scatter(const PixelSum& sum) {
  const double luminance = PixelSum::luminance(sum.color);
  const double squares = sum.luminance_squares - luminance * luminance / sum.samples;
  return squares < 0 ? 0 : squares;  // by rounding; NaN stays
}

/// Above 1 the bound is a share of the luminance: pictures show no more there.
bool is_within_bound(const FilmState& film, int x, int y) {
  const PixelSum& sum = film.sums[index(film, x, y)];
  const double allowed = film.error_bound * std::max(1.0, PixelSum::luminance(sum.color) / sum.samples);
  return squared_error(film, x, y) <= allowed * allowed;  // NaN never is
}

}  // namespace

FilmState blank_film(int width, int height, std::uint32_t samples, double error_bound, FactsAsked asks) {
  if (width < 1 || height < 1 || samples < 1 || !(error_bound >= 0)) {
    throw std::invalid_argument("a film has pixels, samples, and an error bound that is not negative");
  }
  FilmState film{width, height, samples, error_bound, asks, 0, {}, {}, {}, {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  film.sums.resize(pixels);
  film.facts.resize(pixels);
  film.is_wanted.resize(pixels);
  return film;
}

std::uint32_t next_end_of_pass(std::uint32_t end, std::uint32_t samples) {
  const std::uint64_t power = std::bit_floor(end);
  const std::uint64_t next = end < 4 ? std::max(2 * power, std::uint64_t{1}) : end + power / 2;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(next, samples));
}

double squared_error(const FilmState& film, int x, int y) {
  const PixelSum& own = film.sums[index(film, x, y)];
  if (own.samples < 2) return std::numeric_limits<double>::infinity();
  double around = 0, freedom = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, film.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, film.width - 1); ++u) {
      const PixelSum& sum = film.sums[index(film, u, v)];
      if (sum.samples < 2) continue;
      around += scatter(sum);
      freedom += sum.samples - 1;
    }
  }
  const double variance = scatter(own) / (own.samples - 1), pooled = around / freedom;
  return (variance > pooled ? variance : pooled) / own.samples;
}

void expose_tile(TileTask& task, const PictureSource& source, RenderCounters& counters) {
  // Pixels that earlier passes did not want have fewer samples than the others.
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_samples;
  for (const std::uint32_t place : task.open) by_samples[task.tile.sums[place].samples].push_back(place);
  for (const auto& [first, places] : by_samples) {
    source.add_samples(task.tile, places, {first, task.end_of_pass}, task.asks, counters);
  }
}

// ---- The film

Film::Film(FilmState state) : state_(std::move(state)) {
  for (const PixelSum& sum : state_.sums) done_ += sum.samples;
  count_expected();
}

FilmState Film::copy() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

FilmProgress Film::progress() const {
  const std::lock_guard lock(mutex_);
  return {done_, expected_, state_.end_of_pass, state_.counters};
}

/// What is wanted is expected to want all samples.
void Film::count_expected() {
  expected_ = 0;
  const bool is_first = state_.end_of_pass == 0;
  for (std::size_t i = 0; i < state_.sums.size(); ++i) {
    expected_ += is_first || state_.is_wanted[i] ? state_.samples : state_.sums[i].samples;
  }
}

std::vector<TileRect> Film::open_tiles(int side) const {
  struct Placed {
    int ring;
    double angle;
    TileRect rect;
  };
  std::vector<Placed> tiles;
  for (int y = 0; y < state_.height; y += side) {
    for (int x = 0; x < state_.width; x += side) {
      const TileRect rect{x, y, std::min(side, state_.width - x), std::min(side, state_.height - y)};
      bool is_open = false;
      for (int v = y; v < y + rect.height && !is_open; ++v) {
        for (int u = x; u < x + rect.width && !is_open; ++u) is_open = state_.is_open(index(state_, u, v));
      }
      if (!is_open) continue;
      const int columns = (state_.width - 1) / side, rows = (state_.height - 1) / side;
      const int right = 2 * (x / side) - columns, down = 2 * (y / side) - rows;
      tiles.push_back({std::max(std::abs(right), std::abs(down)), std::atan2(down, right), rect});
    }
  }
  std::stable_sort(tiles.begin(), tiles.end(), [](const Placed& a, const Placed& b) {
    return a.ring != b.ring ? a.ring < b.ring : a.angle < b.angle;
  });
  std::vector<TileRect> rects;
  for (const Placed& tile : tiles) rects.push_back(tile.rect);
  return rects;
}

TileTask Film::task(const TileRect& rect) const {
  TileTask task{TileBuffer(rect), {}, state_.end_of_pass, state_.asks};
  std::uint32_t place = 0;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x, ++place) {
      const std::size_t pixel = index(state_, x, y);
      task.tile.sums[place] = state_.sums[pixel];
      task.tile.facts[place] = state_.facts[pixel];
      if (state_.is_open(pixel)) task.open.push_back(place);
    }
  }
  return task;
}

void Film::put(const TileTask& task, const RenderCounters& counters) {
  const std::lock_guard lock(mutex_);
  const TileRect& rect = task.tile.rect;
  for (const std::uint32_t place : task.open) {
    const auto width = static_cast<std::uint32_t>(rect.width);
    const int x = rect.x + static_cast<int>(place % width), y = rect.y + static_cast<int>(place / width);
    const std::size_t pixel = index(state_, x, y);
    done_ += task.tile.sums[place].samples - state_.sums[pixel].samples;
    state_.sums[pixel] = task.tile.sums[place];
    state_.facts[pixel] = task.tile.facts[place];
  }
  state_.counters += counters;
}

bool Film::begin_pass() {
  const std::lock_guard lock(mutex_);
  const bool decides = state_.error_bound > 0 && state_.end_of_pass >= fewest_samples;
  bool is_any = false;
  for (int y = 0; y < state_.height; ++y) {
    for (int x = 0; x < state_.width; ++x) {
      const std::size_t pixel = index(state_, x, y);
      const bool is_full = state_.sums[pixel].samples >= state_.samples;
      state_.is_wanted[pixel] = !is_full && !(decides && is_within_bound(state_, x, y));
      is_any = is_any || state_.is_wanted[pixel];
    }
  }
  if (is_any) state_.end_of_pass = next_end_of_pass(state_.end_of_pass, state_.samples);
  count_expected();
  return is_any;
}

}  // namespace sightline
