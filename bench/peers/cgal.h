#pragma once

#include <memory>

#include "bench/contender.h"

namespace sightline::bench {

/// The AABB tree of CGAL, as its manual builds it for triangles: Simple_cartesian<double>, primitives that refer to the
/// triangles. It builds on one thread. Closest hits through first_intersection, which opens boxes nearest first and
/// keeps the point, any hits through do_intersect.
std::unique_ptr<Contender> make_cgal();

}  // namespace sightline::bench
