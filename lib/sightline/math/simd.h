#pragma once
/// Vectors of Google's Highway library, compiled for the processor that the build names: the widest it has, four lanes
/// of SSE2 where it names none.

#include <hwy/highway.h>

namespace sightline {

namespace hn = hwy::HWY_NAMESPACE;

}  // namespace sightline
