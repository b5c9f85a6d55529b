#include "sightline/math/ball.h"

#include <gtest/gtest.h>

namespace sightline {
namespace {

template <class B>
class Balls : public testing::Test {};
using Both = testing::Types<DoubleBall, WideBall>;
TYPED_TEST_SUITE(Balls, Both);

/// What underflows is not known, neither in the middle nor in the radius.
TYPED_TEST(Balls, AreUncertainOfWhatUnderflows) {
  const TypeParam small(1e-300), large(0x1p600), tiny_radius{TypeParam(0x1p600).mid, 0x1p-600};
  EXPECT_FALSE(sign_of(small * small).is_certain);
  EXPECT_FALSE(sign_of(small * (small * small)).is_certain);
  EXPECT_FALSE(sign_of((small * small) / large).is_certain);
  EXPECT_FALSE(sign_of(TypeParam(0x1p-600) * tiny_radius - TypeParam(1)).is_certain);
  EXPECT_FALSE(sign_of(tiny_radius / large - TypeParam(1)).is_certain);
  EXPECT_FALSE(sign_of(sqrt(tiny_radius) - TypeParam(0x1p300)).is_certain);
  EXPECT_TRUE(sign_of(TypeParam(0) * tiny_radius).is_certain);
}

}  // namespace
}  // namespace sightline
