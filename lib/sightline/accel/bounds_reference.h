#pragma once
/// Primitives while a hierarchy is built: bounds with ids, moved about in place of what they bound.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "sightline/accel/large_pages.h"
#include "sightline/accel/primitives.h"
#include "sightline/math/aabb.h"
#include "sightline/math/simd.h"

namespace sightline {

/// As large as a register, and copied as a whole.
struct alignas(32) BoundsReference {
  Aabb box;
  std::uint32_t id;          ///< Of the primitive.
  std::uint32_t number = 0;  ///< For whoever divides them to tell references apart.
};
static_assert(sizeof(BoundsReference) == 32 && sizeof(Aabb) == 24);

/// A box that grows by one instruction a reference, where registers are wide enough.
class GrowingBox {
 public:
  /// Means nothing until assigned: there are arrays of which few are used.
  GrowingBox() {}
  static GrowingBox empty() {
    GrowingBox box;
    box.lows_.fill(std::numeric_limits<float>::infinity());
    return box;
  }

  void extend(const BoundsReference& item) {
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      const auto old = hn::Load(d, lows_.data() + i);
      const auto added = hn::Load(d, reinterpret_cast<const float*>(&item) + i);
      hn::Store(hn::Min(old, hn::Xor(added, hn::Load(d, signs.data() + i))), d, lows_.data() + i);
    }
  }
  void extend(const GrowingBox& other) {
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      hn::Store(hn::Min(hn::Load(d, lows_.data() + i), hn::Load(d, other.lows_.data() + i)), d, lows_.data() + i);
    }
  }
  Aabb box() const { return {{lows_[0], lows_[1], lows_[2]}, {-lows_[3], -lows_[4], -lows_[5]}}; }

  /// Low ends, high ones negated; the last two mean nothing.
  const float* lows() const { return lows_.data(); }

 private:
  using D = hn::CappedTag<float, 8>;
  static constexpr D d{};
  alignas(32) static constexpr std::array<float, 8> signs{0, 0, 0, -0.0f, -0.0f, -0.0f, 0, 0};

  alignas(32) std::array<float, 8> lows_;
};

/// The middle of a reference's box; the fourth number is 0.
class ReferenceCenter {
 public:
  using D = hn::CappedTag<float, 4>;

  explicit ReferenceCenter(const BoundsReference& item) {
    const auto half = hn::Set(d, 0.5f);
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto is_axis = hn::FirstN(d, i < 3 ? 3 - i : 0);  // ids, as tiny numbers, would slow down some processors
      const auto lo = hn::IfThenElseZero(is_axis, hn::LoadU(d, &item.box.lo.x + i));
      const auto hi = hn::IfThenElseZero(is_axis, hn::LoadU(d, &item.box.hi.x + i));
      hn::Store(hn::Add(hn::Mul(half, lo), hn::Mul(half, hi)), d, at_.data() + i);
    }
  }

  const float* at() const { return at_.data(); }
  static float on(const BoundsReference& item, int axis) { return 0.5f * item.box.lo[axis] + 0.5f * item.box.hi[axis]; }

 private:
  static constexpr D d{};
  alignas(16) std::array<float, 4> at_;
};

/// Bounds of the centers of references.
class CenterBounds {
 public:
  CenterBounds() {
    lo_.fill(std::numeric_limits<float>::infinity());
    hi_.fill(-std::numeric_limits<float>::infinity());
  }

  void extend(const ReferenceCenter& center) { extend_if(true, center); }
  /// Does nothing, but without a branch, unless `is_wanted`.
  void extend_if(bool is_wanted, const ReferenceCenter& center) {
    const auto keeps = hn::MaskFromVec(hn::BitCast(d, hn::Set(to_int, -static_cast<std::int32_t>(is_wanted))));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto at = hn::Load(d, center.at() + i);
      const auto lo = hn::Load(d, lo_.data() + i), hi = hn::Load(d, hi_.data() + i);
      hn::Store(hn::Min(lo, hn::IfThenElse(keeps, at, lo)), d, lo_.data() + i);
      hn::Store(hn::Max(hi, hn::IfThenElse(keeps, at, hi)), d, hi_.data() + i);
    }
  }
  void extend(const CenterBounds& other) {
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      hn::Store(hn::Min(hn::Load(d, lo_.data() + i), hn::Load(d, other.lo_.data() + i)), d, lo_.data() + i);
      hn::Store(hn::Max(hn::Load(d, hi_.data() + i), hn::Load(d, other.hi_.data() + i)), d, hi_.data() + i);
    }
  }

  const std::array<float, 4>& lo() const { return lo_; }
  const std::array<float, 4>& hi() const { return hi_; }
  int longest_axis() const { return Aabb{{lo_[0], lo_[1], lo_[2]}, {hi_[0], hi_[1], hi_[2]}}.longest_axis(); }

 private:
  static constexpr ReferenceCenter::D d{};
  static constexpr hn::RebindToSigned<ReferenceCenter::D> to_int{};

  alignas(16) std::array<float, 4> lo_, hi_;
};

/// What dividing references needs to know of them.
struct ReferenceBounds {
  GrowingBox box = GrowingBox::empty();
  CenterBounds centers;

  void extend(const BoundsReference& item) {
    box.extend(item);
    centers.extend(ReferenceCenter(item));
  }
  void extend(const ReferenceBounds& other) {
    box.extend(other.box);
    centers.extend(other.centers);
  }
};

inline ReferenceBounds bounds_of(std::span<const BoundsReference> items) {
  ReferenceBounds all;
  for (const BoundsReference& item : items) all.extend(item);
  return all;
}

/// References that are divided, and what is known of them.
struct ReferenceSet {
  std::span<BoundsReference> items;
  ReferenceBounds bounds;

  std::uint32_t count() const { return static_cast<std::uint32_t>(items.size()); }
  Aabb box() const { return bounds.box.box(); }
  std::uint32_t id(std::uint32_t i) const { return items[i].id; }
  std::span<const BoundsReference> references() const { return items; }
};

/// Sums over ranges that do not depend on the number of threads, so that neither does the sign of a zero.
template <class Sum, class Add>
Sum reduce_references(std::size_t count, const Sum& none, Add&& add) {
  constexpr std::size_t chunk_size = 8192;
  const auto added = [&](const tbb::blocked_range<std::size_t>& range, Sum sum) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) add(i, sum);
    return sum;
  };
  const auto joined = [](Sum a, const Sum& b) {
    a.extend(b);
    return a;
  };
  return tbb::parallel_deterministic_reduce(tbb::blocked_range<std::size_t>(0, count, chunk_size), none, added, joined);
}

inline ReferenceSet whole_of(std::span<BoundsReference> items) {
  const auto add = [&](std::size_t i, ReferenceBounds& bounds) { bounds.extend(items[i]); };
  return {items, reduce_references(items.size(), ReferenceBounds(), add)};
}

/// One reference for each primitive, in the order of their ids.
inline LargeBuffer<BoundsReference> references_of(const Primitives& primitives) {
  LargeBuffer<BoundsReference> items(primitives.size());
  tbb::parallel_for(std::uint32_t{0}, primitives.size(), [&](std::uint32_t id) {
    items[id] = {primitives.bounds(id), id};
  });
  return items;
}

}  // namespace sightline
