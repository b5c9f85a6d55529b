#pragma once
/// Pictures that need no scene: noise whose mean and scatter are known.

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "sightline/math/random.h"
#include "sightline/render/picture_source.h"

namespace sightline {

/// Gray, brighter to the right. The left half does not scatter; in the right half luminances are uniform around the
/// mean, `scatter` to either side.
class FakeSource : public PictureSource {
 public:
  FakeSource(int width, int height, std::uint32_t samples) : width_(width), height_(height), samples_(samples) {}

  double scatter = 0.25;
  std::uint64_t seed = 1;
  mutable std::atomic<std::uint64_t> asked{0};  ///< Samples.

  int width() const override { return width_; }
  int height() const override { return height_; }
  std::uint32_t samples() const override { return samples_; }
  std::uint64_t fingerprint() const override { return Random::hash(seed); }

  double mean(int x) const { return 0.5 + 0.25 * x / width_; }
  bool is_noisy(int x) const { return 2 * x >= width_; }

  virtual Vec3d sample(int x, int y, std::uint32_t number) const {
    const std::uint64_t pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width_) + static_cast<std::uint64_t>(x);
    Random random(seed ^ Random::hash(pixel << 20 ^ number));
    const double noise = is_noisy(x) ? scatter * (2 * random.uniform_double() - 1) : 0;
    return Vec3d(mean(x) + noise) * Vec3d(1, 1, 1);
  }

  void add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range, FactsAsked asks,
                   RenderCounters& counters) const override {
    for (std::uint32_t number = range.first; number < range.last; ++number) {
      for (const std::uint32_t place : pixels) {
        const int x = tile.rect.x + static_cast<int>(place) % tile.rect.width;
        const int y = tile.rect.y + static_cast<int>(place) / tile.rect.width;
        if (x >= width_ || y >= height_ || tile.sums[place].samples != number) throw std::logic_error("a wrong sample");
        tile.sums[place].add(sample(x, y, number));
        if (number == 0 && asks != FactsAsked::none) {
          const auto object = static_cast<std::uint32_t>(x);
          tile.facts[place] = {static_cast<float>(1 + y), Vec3f(0, 0, 1), object,
                               asks == FactsAsked::with_work ? object + 1 : 0};
        }
        ++counters.camera_rays;
        ++counters[Effect::meshes];
        ++asked;
      }
    }
  }

 private:
  int width_, height_;
  std::uint32_t samples_;
};

}  // namespace sightline
