/// The laws over a single structure, the one that SIGHTLINE_STRUCTURE names, under the name that they have over all.

#include "sightline/accel/registry.h"
#include "tests/accel/laws.h"

namespace sightline::laws {

INSTANTIATE_TYPED_TEST_SUITE_P(Registry, Laws, ::testing::Types<SIGHTLINE_STRUCTURE>, NameOf);

}  // namespace sightline::laws
