#pragma once
/// The laws that every structure keeps, asked of a student's (tests/accel/laws.h asks them of ours).

#include <span>
#include <vector>

#include "labs/check/check.h"
#include "labs/kit/structure_questions.h"
#include "sightline/math/ray.h"
#include "sightline/shape/triangle.h"

namespace sightline::labs {

/// Where the handout tells of what the checks are about, and what the structure may cost.
struct StructureTopics {
  std::string walk, construction, budget;  ///< Sections.
  // A ray on the lab's scene (labs/check/structure_scene.h) may take at most so many, on average.
  double most_nodes = 0, most_candidates = 0;
};

std::vector<Check> structure_checks(const StructureTopics& topics);

/// The structure's picture when it works: its leaves about a few hundred triangles, and a ray's way through them.
Drawing picture_of_structure(Subject& subject);

// ---- For checks of one's own

/// Triangles and a ray as numbers of a case: the head's first six are half the ray's origin, and where it goes
/// from there by t = 1; each item is a triangle's first corner and the way to its others, which is held below `extent`.
/// All times `scale`.
struct SmallScene {
  std::vector<Triangle> triangles;
  Ray<float> ray;
};
SmallScene small_scene(const Case& at, int extent, float scale);
std::string describe(const SmallScene& scene);

/// Builds the structure as the student's options say, or so that even few triangles are divided.
StructureFacts build(Subject& subject, std::span<const Triangle> triangles, bool divides_few = false);

/// What brute force finds. Bit for bit what every structure has to find.
template <class T>
std::vector<Hit<T>> true_hits(std::span<const Triangle> triangles, std::span<const Ray<T>> rays);

/// Cells in the order in which the walk came to them, what it overlooked, the right hit and the wrong one.
Drawing draw_walk(const SmallScene& scene, Subject& subject);

}  // namespace sightline::labs
