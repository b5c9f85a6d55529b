#pragma once
/// How noise goes over from one lattice point to the next.

#include <array>
#include <string_view>

#include "sightline/math/simd.h"

namespace sightline {

enum class Ease {
  cubic,    ///< 3 t^2 - 2 t^3: no slope at lattice points, but its curvature jumps there from -6 to 6.
  quintic,  ///< 6 t^5 - 15 t^4 + 10 t^3: no curvature there either. Perlin, "Improving Noise", 2002.
};

struct EaseInfo {
  Ease ease;
  std::string_view name;
};
inline constexpr std::array<EaseInfo, 2> ease_infos{{{Ease::cubic, "cubic"}, {Ease::quintic, "quintic"}}};

/// 0 to 1 as t goes from 0 to 1; exact at both.
template <Ease ease, class D, class V = hn::Vec<D>>
HWY_INLINE V eased(D d, V t) {
  if constexpr (ease == Ease::cubic) return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(t, hn::Set(d, 2), hn::Set(d, 3)));
  const V inner = hn::MulAdd(t, hn::MulSub(t, hn::Set(d, 6), hn::Set(d, 15)), hn::Set(d, 10));
  return hn::Mul(hn::Mul(hn::Mul(t, t), t), inner);
}

/// Its derivative; `t_less_1` is t - 1, which may be known better than t itself.
template <Ease ease, class D, class V = hn::Vec<D>>
HWY_INLINE V slope_of_eased(D d, V t, V t_less_1) {
  const V product = hn::Mul(t, t_less_1);
  if constexpr (ease == Ease::cubic) return hn::Mul(product, hn::Set(d, -6));
  return hn::Mul(hn::Mul(product, product), hn::Set(d, 30));
}

}  // namespace sightline
