#pragma once
/// The integer lattice that noise hangs on: what a lattice point is given, chosen by its coordinates alone, as if all
/// of infinite space had been filled with random numbers beforehand.
///   H1  A lattice coordinate X is a key of 32 bits: X mod 2^32 where X fits into 31 bits and a sign, else that mixed
///       with the bits above. So space does not repeat, but where a period is asked for.
///   H2  All arithmetic on keys is unsigned, modulo 2^32.

#include <array>
#include <cmath>
#include <cstdint>

#include "sightline/math/simd.h"
#include "sightline/noise/byte_table.h"
#include "sightline/noise/directions.h"

namespace sightline {

/// Whether a coordinate is nearer than this, so that its key is quickly found, and one more than it is exact.
template <class T>
inline constexpr T near_limit = sizeof(T) == 4 ? T(0x1p22) : T(0x1p30);

/// H1, of any finite X without a fraction; X mod 2^32 where there is a period, which divides that.
inline std::uint32_t far_key(double x, bool is_periodic) {
  // |x| < 2^63 fits; of larger ones the lowest 63 bits tell, exactly.
  const double part = std::fabs(x) < 0x1p63 ? x : std::fmod(x, 0x1p63);
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(part));
  const auto low = static_cast<std::uint32_t>(bits), high = static_cast<std::uint32_t>(bits >> 32);
  return is_periodic ? low : low + (high + (low >> 31)) * 0x9e3779b9u;
}

template <class D>
using KeyTag = hn::Rebind<std::uint32_t, D>;
template <class D>
using Keys = hn::Vec<KeyTag<D>>;

/// What must be added to near_bits for a key.
template <class T>
inline constexpr std::uint32_t near_bias = sizeof(T) == 4 ? 0u - 0x4b400000u : 0u;

/// H1, of coordinates that are near, but for near_bias: the lower bits of their sum with 1.5 times as much as numbers
/// without a fraction begin at.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Keys<D> near_bits(D d, V x) {
  const hn::RebindToUnsigned<D> du;
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return hn::BitCast(du, hn::Add(x, hn::Set(d, 0x1.8p23f)));
  } else {
    return hn::TruncateTo(KeyTag<D>(), hn::BitCast(du, hn::Add(x, hn::Set(d, 0x1.8p52))));
  }
}

/// A hash's bits as the highest of lanes as wide as D's.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> lifted(D, Keys<D> hash) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return hash;
  } else {
    return hn::ShiftLeft<32>(hn::PromoteTo(hn::RebindToUnsigned<D>(), hash));
  }
}

/// Axes from the first on, each in a lane.
struct AxisLanes {
  std::size_t first;
};

/// Keys of a lattice point's coordinates, joined to a hash whose upper bits all of them decide about. Lattices are
/// asked
///   lead(axis)         what is added to keys beforehand,
///   spread(axis, key)  what a key so increased gives to the hash,
///   joined(...)        of what all axes give, the hash,
///   columns(x, y)      the same for both sides of a cell along x and y, which at(i, j) or at(i, j, z) tells.
class HashedLattice {
 public:
  /// `period` is 0 for none, or a power of two: the lattice repeats after as many points along each axis.
  HashedLattice(std::uint64_t seed, std::uint32_t period);

  bool is_periodic() const { return is_periodic_; }
  std::uint32_t lead(std::size_t axis) const { return is_periodic_ ? 0 : offsets_[axis]; }

  template <class D, class Axis, class V = hn::Vec<D>>
  HWY_INLINE V spread(D d, Axis axis, V key) const {
    if (HWY_UNLIKELY(is_periodic_)) key = hn::Add(hn::And(key, hn::Set(d, mask_)), of_axis(d, offsets_, axis));
    return hn::Mul(key, of_axis(d, multipliers_, axis));
  }
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V joined(D d, V x, V y) const {
    return finished(d, folded(d, hn::Xor(x, y)));
  }
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V joined(D d, V x, V y, V z) const {
    return finished(d, folded(d, hn::Xor3(x, y, z)));
  }

  template <class D, class V = hn::Vec<D>>
  class Columns {
   public:
    HWY_INLINE Columns(const HashedLattice& lattice, const std::array<V, 2>& x, const std::array<V, 2>& y)
        : lattice_(lattice), x_{folded(D(), x[0]), folded(D(), x[1])}, y_{folded(D(), y[0]), folded(D(), y[1])} {}

    HWY_INLINE V at(std::size_t i, std::size_t j) const { return lattice_.finished(D(), hn::Xor(x_[i], y_[j])); }
    HWY_INLINE V at(std::size_t i, std::size_t j, V z) const {
      return lattice_.finished(D(), hn::Xor3(x_[i], y_[j], z));
    }
    HWY_INLINE V level(V z) const { return folded(D(), z); }

   private:
    const HashedLattice& lattice_;
    std::array<V, 2> x_, y_;
  };

 private:
  template <class D>
  static HWY_INLINE hn::Vec<D> of_axis(D d, const std::array<std::uint32_t, 4>& numbers, std::size_t axis) {
    return hn::Set(d, numbers[axis]);
  }
  template <class D>
  static HWY_INLINE hn::Vec<D> of_axis(D d, const std::array<std::uint32_t, 4>& numbers, AxisLanes axis) {
    return hn::LoadU(d, numbers.data() + axis.first);
  }

  /// Brings upper bits down. Sums modulo 2 may be folded, or what is folded summed up, with the same result.
  template <class D, class V = hn::Vec<D>>
  static HWY_INLINE V folded(D, V x) {
    return hn::Xor(x, hn::ShiftRight<15>(x));
  }
  /// Brings lower bits up.
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V finished(D d, V x) const {
    return hn::Mul(x, hn::Set(d, finisher_));
  }

  /// Odd, and without a small relation to one another. No constants, which compilers bring to vectors the long way.
  std::array<std::uint32_t, 4> multipliers_{0x9e3779b1u, 0xc2b2ae3du, 0x27d4eb2fu, 0};
  std::uint32_t finisher_ = 0x85ebca6bu;
  std::array<std::uint32_t, 4> offsets_{};
  std::uint32_t mask_;
  bool is_periodic_;
};

/// A permutation of 256 numbers, looked up once for each coordinate: the lattice repeats after 256 points. Only the
/// lowest byte of keys and hashes counts. Perlin, "An Image Synthesizer", 1985.
class PermutedLattice {
 public:
  /// Seed 0 is the standard permutation of Perlin, "Improving Noise", 2002; others are shuffled.
  explicit PermutedLattice(std::uint64_t seed);

  bool is_periodic() const { return true; }
  std::uint32_t lead(std::size_t) const { return 0; }

  template <class D, class Axis, class V = hn::Vec<D>>
  HWY_INLINE V spread(D, Axis, V key) const {
    return key;
  }
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V joined(D d, V x, V y, V z) const {
    return permuted(d, hn::Add(permuted(d, hn::Add(permuted(d, x), y)), z));
  }

  template <class D, class V = hn::Vec<D>>
  class Columns {
   public:
    HWY_INLINE Columns(const PermutedLattice& lattice, const std::array<V, 2>& x, const std::array<V, 2>& y)
        : lattice_(lattice) {
      for (std::size_t i = 0; i < 2; ++i) {
        const V along_x = lattice.permuted(D(), x[i]);
        for (std::size_t j = 0; j < 2; ++j) hashes_[i][j] = lattice.permuted(D(), hn::Add(along_x, y[j]));
      }
    }

    HWY_INLINE V at(std::size_t i, std::size_t j, V z) const {
      return lattice_.permuted(D(), hn::Add(hashes_[i][j], z));
    }
    HWY_INLINE V level(V z) const { return z; }

   private:
    const PermutedLattice& lattice_;
    std::array<std::array<V, 2>, 2> hashes_;
  };

 private:
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V permuted([[maybe_unused]] D d, V x) const {
    if constexpr (can_look_up_bytes) {
      return look_up_byte(bytes_.data(), x);
    } else {
      const hn::RebindToSigned<D> di;
      const auto index = hn::BitCast(di, hn::And(x, hn::Set(d, 255u)));
      return hn::BitCast(d, hn::GatherIndex(di, permutation_.data(), index));
    }
  }

  /// The same, for whichever way a processor looks them up.
  alignas(64) std::array<std::uint8_t, 256> bytes_;
  std::array<std::int32_t, 256> permutation_;
};

}  // namespace sightline
