#pragma once
/// Ours, at the work that POV-Ray is given.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "bench/solids/picture.h"
#include "bench/solids/scene.h"
#include "sightline/csg/evaluator.h"
#include "sightline/csg/solid_set.h"

namespace sightline::bench {

/// Per pass.
struct PaintStats {
  SolidStats solids;
  std::uint64_t rays = 0;  ///< One a pixel, and one to the light where it could shine.
};

/// A scene made ready. Const, and safe to use from many threads.
class Painter {
 public:
  virtual ~Painter() = default;

  /// For each pixel the closest hit of a ray of doubles, its normal, and whether the light reaches it. Of the rows
  /// every `row_step`-th.
  virtual void paint(const SolidScene& scene, Picture& picture, int row_step) const = 0;
  virtual PaintStats count(const SolidScene& scene, Picture& picture) const = 0;
};

/// Names of the registry: what holds the solids, and what the operands of each large one. Rays go in packets
/// (packets.h) or one by one. \throws std::invalid_argument
std::unique_ptr<Painter> make_painter(const SolidScene& scene, Level level, const SolidOptions& options,
                                      std::string_view over_solids, std::string_view over_operands, bool in_packets);

}  // namespace sightline::bench
