#pragma once
/// What a film is exposed to: samples of pixels, on demand, in any order.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sightline/math/vec.h"
#include "sightline/render/render_counters.h"

namespace sightline {

/// What the samples of a pixel add up to.
struct PixelSum {
  Vec3d color{0};
  double luminance_squares = 0;  ///< Of each sample's luminance: with their sum it tells how they scatter.
  std::uint32_t samples = 0;
  std::uint32_t lamps_seen = 0;  ///< Bits of LampsSeen, by the first samples: what they found spares later ones rays.

  /// Rec. 709, linear.
  static double luminance(const Vec3d& color) { return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z; }

  void add(const Vec3d& sample) {
    color += sample;
    luminance_squares += luminance(sample) * luminance(sample);
    ++samples;
  }
  friend bool operator==(const PixelSum&, const PixelSum&) = default;
};

/// What the first sample of a pixel saw.
struct PixelFacts {
  float depth = std::numeric_limits<float>::infinity();  ///< From the camera along its ray, in units of length.
  Vec3f normal{0};                   ///< In the world, of unit length, toward the camera; 0 for nothing.
  std::uint32_t object = no_object;  ///< Number of the element in the scene (NodeId).
  std::uint32_t work = 0;            ///< Nodes, leaves and candidates that the camera's ray examined.

  static constexpr std::uint32_t no_object = 0xffff'ffff;
  friend bool operator==(const PixelFacts&, const PixelFacts&) = default;
};

/// Pixels of a picture, from (x, y) on; (0, 0) is the top left one.
struct TileRect {
  int x = 0, y = 0, width = 0, height = 0;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  friend bool operator==(const TileRect&, const TileRect&) = default;
};

/// A tile under way, its pixels row by row.
struct TileBuffer {
  TileRect rect;
  std::vector<PixelSum> sums;
  std::vector<PixelFacts> facts;

  explicit TileBuffer(const TileRect& its_rect = {}) : rect(its_rect), sums(rect.pixels()), facts(rect.pixels()) {}
};

struct SampleRange {
  std::uint32_t first = 0, last = 0;  ///< Without `last`.
};

/// What is wanted of facts; they take time.
enum class FactsAsked : std::uint8_t { none, seen, with_work };

/// Const, and safe to ask from many threads. A sample is a function of its pixel, its number, and what PixelSum has of
/// the pixel's samples before it: so a picture is the same bits whatever the tiles, their order, and the number of
/// threads.
class PictureSource {
 public:
  virtual ~PictureSource() = default;

  virtual int width() const = 0;
  virtual int height() const = 0;
  /// The most that a pixel is asked for.
  virtual std::uint32_t samples() const = 0;
  /// Of all that the picture depends on: what is half done is gone on with only where this is the same.
  virtual std::uint64_t fingerprint() const = 0;

  /// Adds the samples `range` of pixels of the tile, by their place in it, in increasing order. Facts that are
  /// asked for are set with sample 0, the work among them only `with_work`.
  virtual void add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range, FactsAsked facts,
                           RenderCounters& counters) const = 0;
};

}  // namespace sightline
