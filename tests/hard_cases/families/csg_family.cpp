/// Thin shells, and narrow gaps between blocks.

#include <vector>

#include "tests/csg/evaluate.h"
#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

constexpr double usual_tolerance = 0.00001;

/// Of boundaries in order, those that are closer together than the usual constant are taken for one place.
std::size_t merged_count(const std::vector<double>& ends) {
  std::vector<double> kept;
  for (const double t : ends) {
    if (!kept.empty() && t - kept.back() < usual_tolerance)
      kept.pop_back();
    else
      kept.push_back(t);
  }
  return kept.size();
}

void ask(const SolidTree& tree, const std::vector<Ray<double>>& rays, Trial& trial) {
  std::vector<AskedRay> questions;
  for (const Ray<double>& ray : rays) questions.push_back({ray, true_spans(tree, ray)});
  ask_lists(tree, questions, trial);
  ask_structures(tree, questions, trial);
  const Solid solid(tree);
  for (const auto& [ray, truth] : questions) {
    std::vector<double> ends;
    for (const Boundary& boundary : spans_of(solid, ray, Level::exact).boundaries) ends.push_back(boundary.t);
    const std::size_t count = merged_count(ends);
    trial.naive("ends within 1e-5 are one").decide(count == truth.ends.size(), [&, &ray = ray, &truth = truth] {
      return Example{text_of(ray), std::to_string(truth.ends.size()) + " boundaries",
                     std::to_string(count) + " boundaries"};
    });
  }
}

void ask_gaps(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const double gap = std::ldexp(1.0, -difficulty);
  std::vector<Ray<double>> through;
  for (std::uint64_t i = 0; i < (count + 1) / 2; ++i) {
    const AnyFrame frame(random);
    through.push_back({0.5 * any_point(random) - 4.0 * frame.z, frame.z});
  }
  ask(SolidTree(solid::Sphere{Vec3d(0), 1 + gap}) - SolidTree(solid::Sphere{Vec3d(0), 1}), through, trial);
  std::vector<Ray<double>> across;
  for (std::uint64_t i = 0; i < (count + 1) / 2; ++i) {
    across.push_back({Vec3d(-3, 0, 0) + 0.5 * any_point(random), Vec3d(1, 0, 0) + 0.05 * any_point(random)});
  }
  ask(SolidTree(solid::Box{Vec3d(-1), Vec3d(1)}) | SolidTree(solid::Box{{1 + gap, -1, -1}, {2, 1, 1}}), across, trial);
}

}  // namespace

Family csg_gaps() {
  return {"gaps",
          "Rays through a sphere less a smaller one, and through two blocks side by side: all boundaries, in order.",
          "the shell is 2^-k thick, and so wide is the gap between the blocks",
          "k: shell and gap of 2^-k",
          1,
          50,
          Oracle::rationals,
          ask_gaps};
}

}  // namespace sightline::hard
