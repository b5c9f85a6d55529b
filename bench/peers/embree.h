#pragma once

#include <memory>
#include <string>

#include "bench/contender.h"

namespace sightline::bench {

/// Intel's Embree 3 as a peer: single rays (rtcIntersect1, rtcOccluded1), the widest instructions that it finds on the
/// machine.
///   standard  its default build quality and a fast float test, which may let a ray through between neighbours;
///   high      RTC_BUILD_QUALITY_HIGH: a slower build that splits triangles between boxes;
///   robust    RTC_SCENE_FLAG_ROBUST, the kind of promise that our queries keep.
/// `threads` build, 0 for all. Denormals are left as they are, because our queries in the same process need them.
enum class EmbreeMode { standard, high, robust };
std::unique_ptr<Contender> make_embree(EmbreeMode mode, int threads);

/// Of the library that is linked, such as "3.13.5".
std::string embree_version();

}  // namespace sightline::bench
