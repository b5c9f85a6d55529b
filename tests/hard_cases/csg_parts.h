#pragma once
/// The rows of the group of solids made of others, each where its like are, and what they have in common.

#include "sightline/csg/solid_tree.h"
#include "tests/hard_cases/hard_case.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {

// csg_faces.cpp: faces in one plane
HardCase csg_two_ways();
HardCase csg_pov();
HardCase csg_edge_share();
HardCase csg_deep();

// csg_gaps.cpp: spans and gaps that are short, and those of no length
HardCase csg_self();
HardCase csg_gap();
HardCase csg_ulp_seam();
HardCase csg_zero_length();

// csg_round.cpp: spheres that touch, coincide and are cut where they are met
HardCase csg_tangent();
HardCase csg_frames();
HardCase csg_pythagoras();

// csg_ends.cpp: spans that have no end, and those that one stands in
HardCase csg_infinite();
HardCase csg_camera_inside();

inline SolidTree half_space(const Vec3d& normal, double offset) { return solid::HalfSpace{normal, offset}; }
inline SolidTree box_of(const Vec3d& lo, const Vec3d& hi) { return solid::Box{lo, hi}; }
inline SolidTree ball_of(const Vec3d& center, double radius) { return solid::Sphere{center, radius}; }
/// Between two planes across x.
inline SolidTree slab_of(double lo, double hi) { return box_of({lo, -100, -100}, {hi, 100, 100}); }

/// Spans, the first boundary, and that in a packet.
inline void ask_all_ways(Trial& trial, const SolidQuestion& question) {
  question.ask_spans(trial, "list");
  question.ask_first(trial, "first");
  question.ask_packet(trial, "packet");
}

}  // namespace sightline::hard
