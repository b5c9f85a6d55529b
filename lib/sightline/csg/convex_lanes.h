#pragma once
/// The convex parts of a solid side by side, a lane each, for all to meet a ray at once.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "sightline/csg/primitive.h"
#include "sightline/math/sized_double.h"

namespace sightline {

/// Faces in lanes. Of the sphere, or of the cylinder along a coordinate axis, in lane i
///   a = sum (weight d)^2,  b = sum (weight d) (weight (o - center)),  c = sum (weight (o - center))^2 - square
/// over the axes, where the weight of a cylinder's own axis is 0: the very operations of form_of (solid_shape.h), but
/// for terms that are 0.
template <class Real>
struct LaneRows {
  static constexpr std::uint32_t lanes = 8;
  /// Where there is no plane: beyond all that moderate rays reach. For doubles so near that nothing overflows, since
  /// what is known of t is a share of it; floats are taken as they are.
  static constexpr Real afar =
      static_cast<Real>(sizeof(Real) == sizeof(float) ? std::numeric_limits<double>::infinity() : 0x1p+900);

  using Row = std::array<Real, lanes>;

  alignas(64) std::array<Row, 3> weight{}, center{};
  alignas(64) Row square{}, is_round{};             ///< 1 where the lane has a quadratic, else 0.
  alignas(64) Row radius_square{};                  ///< Without the weight.
  alignas(64) Row error_a{}, error_b{}, error_c{};  ///< By the sizes of SizedDouble, without its step.
  alignas(64) std::array<Row, 3> lo, hi;            ///< Slabs: of a box all three, of a cylinder that of its caps.
  std::array<Real, 3> lower, upper;                 ///< The planes of what is kept.

  LaneRows() {
    lower.fill(-afar), upper.fill(afar);
    for (Row& row : lo) row.fill(-afar);
    for (Row& row : hi) row.fill(afar);
  }
};

/// Kept boxes and caps are one box; what else is kept and all that is taken away has a lane.
///   C1  No two kept planes on one side of an axis are equal, not even as floats: the inner one is known.
class ConvexLanes {
 public:
  static constexpr std::uint32_t capacity = LaneRows<double>::lanes;

  struct Face {
    std::uint32_t primitive = 0, face = 0;
  };
  struct Lane {
    std::uint32_t primitive = 0;
    bool is_round = false;       ///< A sphere or a cylinder.
    bool is_box = false;         ///< With slabs across all axes.
    bool goes_up = false;        ///< A cylinder's top is above its base along ...
    std::int32_t cap_axis = -1;  ///< ... this axis.
  };

  /// nullptr where some part is of another kind, or there are too many.
  static std::shared_ptr<const ConvexLanes> build(std::span<const Primitive> primitives,
                                                  std::span<const std::uint32_t> kept,
                                                  std::span<const std::uint32_t> taken);

  /// Whose the planes of what is kept are.
  const Face& face_of_plane(int axis, bool is_upper) const {
    return planes_[static_cast<std::size_t>(2 * axis + is_upper)];
  }

  std::uint32_t count() const { return count_; }
  std::uint32_t kept_count() const { return kept_count_; }  ///< Lanes of kept parts come first.
  std::uint32_t taken_bits() const { return ((1u << count_) - 1) & ~((1u << kept_count_) - 1); }
  std::uint32_t round_bits() const { return round_bits_; }
  bool has_slabs() const { return has_slabs_; }
  const Lane& operator[](std::uint32_t lane) const { return lanes_[lane]; }

  template <class Real>
  const LaneRows<Real>& rows() const {
    if constexpr (sizeof(Real) == sizeof(float)) {
      return floats_;
    } else {
      return doubles_;
    }
  }

 private:
  class Builder;

  LaneRows<double> doubles_;
  LaneRows<float> floats_;
  std::array<Face, 6> planes_;
  std::array<Lane, capacity> lanes_;
  std::uint32_t count_ = 0, kept_count_ = 0, round_bits_ = 0;
  bool has_slabs_ = false;
};

}  // namespace sightline
