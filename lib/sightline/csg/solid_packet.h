#pragma once
/// Rays of a packet as the faces of solids see them, a ray in each lane.

#include <array>
#include <cstdint>
#include <type_traits>

#include "sightline/accel/ray_packet.h"
#include "sightline/csg/face_roots.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// QuickRay of each ray, in the level's own precision. Refers to the packet, which is coherent: so no direction has a
/// component 0, and every ray is one that can hit.
template <Level level>
class SolidPacket {
 public:
  static constexpr std::size_t size = RayPacket<double>::size;
  using Real = typename QuickRay<level>::Real;
  struct alignas(64) Row : std::array<Real, size> {};

  explicit SolidPacket(const RayPacket<double>& rays) : rays_(rays), moderate_(find_moderate(rays)) {
    if constexpr (level == Level::fast) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        for (std::size_t ray = 0; ray < size; ++ray) {
          own_.origin[i][ray] = static_cast<Real>(rays.origins(axis)[ray]);
          own_.direction[i][ray] = static_cast<Real>(rays.directions(axis)[ray]);
          own_.inverse[i][ray] = Real(1) / own_.direction[i][ray];
        }
      }
    }
  }

  const RayPacket<double>& rays() const { return rays_; }
  /// A bit for each ray that suits SizedDouble (Q1).
  std::uint32_t moderate() const { return moderate_; }
  bool is_negative(int axis) const { return rays_.is_negative[axis]; }

  const Real* origin(int axis) const {
    if constexpr (level == Level::fast)
      return own_.origin[static_cast<std::size_t>(axis)].data();
    else
      return rays_.origins(axis).data();
  }
  const Real* direction(int axis) const {
    if constexpr (level == Level::fast)
      return own_.direction[static_cast<std::size_t>(axis)].data();
    else
      return rays_.directions(axis).data();
  }
  const Real* inverse(int axis) const {
    if constexpr (level == Level::fast)
      return own_.inverse[static_cast<std::size_t>(axis)].data();
    else
      return rays_.inverses(axis).data();
  }

 private:
  struct Own {
    std::array<Row, 3> origin, direction, inverse;
  };
  struct Nothing {};

  static std::uint32_t find_moderate(const RayPacket<double>& rays) {
    constexpr hn::CappedTag<double, size> d{};
    const auto most = hn::Set(d, SizedDouble::largest), least = hn::Set(d, 1 / SizedDouble::largest);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < size; i += hn::MaxLanes(d)) {
      auto is_moderate = no_lanes(d);
      for (int axis = 0; axis < 3; ++axis) {
        const auto origin = hn::Abs(hn::Load(d, rays.origins(axis).data() + i));
        const auto direction = hn::Abs(hn::Load(d, rays.directions(axis).data() + i));
        const auto is_within =
            hn::And(hn::Le(origin, most), hn::And(hn::Ge(direction, least), hn::Le(direction, most)));
        is_moderate = axis == 0 ? is_within : hn::And(is_moderate, is_within);
      }
      bits |= bits_of(d, is_moderate) << i;
    }
    return bits;
  }

  const RayPacket<double>& rays_;
  std::uint32_t moderate_;
  [[no_unique_address]] std::conditional_t<level == Level::fast, Own, Nothing> own_;
};

}  // namespace sightline
