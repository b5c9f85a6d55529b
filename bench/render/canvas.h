#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "bench/solids/picture.h"
#include "sightline/render/picture_source.h"

namespace sightline::bench {

/// A picture in tiles, kept between rounds so that only rendering is timed.
class Canvas {
 public:
  Canvas(int width, int height) : width_(width), height_(height) {
    for (int y = 0; y < height; y += tile_side) {
      for (int x = 0; x < width; x += tile_side) {
        tiles_.emplace_back(TileRect{x, y, std::min(tile_side, width - x), std::min(tile_side, height - y)});
      }
    }
    for (std::uint32_t i = 0; i < tile_side * tile_side; ++i) pixels_.push_back(i);
  }

  /// paint(tile, pixels) adds samples to black.
  template <class Paint>
  void paint(const Paint& paint) {
    for (TileBuffer& tile : tiles_) {
      std::fill(tile.sums.begin(), tile.sums.end(), PixelSum{});
      paint(tile, std::span<const std::uint32_t>(pixels_).first(tile.rect.pixels()));
    }
  }

  /// Of what is gray: a sample a pixel.
  Picture gray() const {
    Picture picture(width_, height_);
    for (const TileBuffer& tile : tiles_) {
      for (std::size_t i = 0; i < tile.sums.size(); ++i) {
        const std::size_t x = static_cast<std::size_t>(tile.rect.x) + i % static_cast<std::size_t>(tile.rect.width);
        const std::size_t y = static_cast<std::size_t>(tile.rect.y) + i / static_cast<std::size_t>(tile.rect.width);
        picture.shades[y * static_cast<std::size_t>(width_) + x] = static_cast<float>(tile.sums[i].color.x);
      }
    }
    return picture;
  }

  std::vector<TileBuffer>& tiles() { return tiles_; }
  /// Pixels that are not the same to the last bit.
  std::size_t differing(const Canvas& other) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < tiles_.size(); ++k) {
      for (std::size_t i = 0; i < tiles_[k].sums.size(); ++i) count += !(tiles_[k].sums[i] == other.tiles_[k].sums[i]);
    }
    return count;
  }

 private:
  static constexpr int tile_side = 32;

  int width_, height_;
  std::vector<TileBuffer> tiles_;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace sightline::bench
