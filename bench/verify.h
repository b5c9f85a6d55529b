#pragma once
/// No time without right hits: ours are held against the oracle bit for bit, peers within the rounding of their own
/// arithmetic.

#include <stdexcept>
#include <string>

#include "sightline/shape/mesh.h"

namespace sightline::bench {

/// Hits of ours were wrong; the run must end without printing a time.
class WrongHits : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// True when t, u, v have the same bits and prim_id is the same: 0 differs from -0.
bool is_same(const Hit<float>& a, const Hit<float>& b);

/// "t 1.25 on triangle 7 (u 0.5, v 0.25)" with all digits, or "no hit".
std::string hit_text(const Hit<float>& hit);

/// How far t may be from the true one when it is computed in float as dot(normal, a - origin) / dot(normal, direction),
/// from edges that are stored rounded (Moeller and Trumbore 1997) or are differences of corners already moved to the
/// origin (Woop, Benthin and Wald 2013); infinite for a ray so nearly along the triangle that the bound says nothing.
double t_error_bound(const Triangle& triangle, const Ray<float>& ray);

/// Whether a peer found the same as we did: neither hits, or both do, at distances that their rounding explains. The
/// triangles may differ, since neighbours share the points of their edge.
bool agrees(const TriangleMesh& mesh, const Ray<float>& ray, const Hit<float>& ours, const Hit<float>& peer);

}  // namespace sightline::bench
