#include <algorithm>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/axes/root_choice.h"
#include "bench/peers/ferrari.h"
#include "bench/torus/rays.h"
#include "sightline/shape/torus.h"

namespace sightline::bench {
namespace {

FewRoots ferraris(const Torus& torus, const Ray<double>& ray) {
  std::array<double, 4> found{};
  const int count = ferrari_roots(torus, ray, found);
  FewRoots roots;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (i == 0 || found[i] != found[i - 1]) roots.at[static_cast<std::size_t>(roots.count++)] = found[i];
  }
  return roots;
}

/// The rays of `bench torus`, which are the same for every seed.
std::vector<Panel> panels(const Effort& effort) {
  constexpr double minor = 0.25;
  const Torus torus{Vec3d(0), Vec3d(0, 0, 1), 1, minor};
  std::vector<Panel> all;
  std::vector<TorusRays> sets = torus_rays(torus, effort.count(5'000, 2'000));
  // Failures of grazing rays are counted, which takes many of them: a tenth of all that are asked for.
  sets.back() = std::move(torus_rays(torus, effort.count(500'000, 50'000)).back());
  for (TorusRays& set : sets) {
    if (set.name == "mixed") continue;
    effort.say("roots of " + std::string(set.name) + " rays by Sturm's theorem");
    const auto questions = std::make_shared<const std::vector<Ray<double>>>(std::move(set.rays));
    std::vector<std::vector<True>> truths;
    for (const Ray<double>& ray : *questions) truths.push_back(true_torus_roots(minor, ray));
    const bool is_grazing = set.name == "grazing";
    Panel panel{std::string(set.name),
                "a tube of a quarter of the ring's radius: " + std::string(set.description),
                "ray",
                "of a point, in radii of the ring",
                is_grazing ? ErrorKind::wrong : ErrorKind::maximum,
                static_cast<double>(questions->size())};
    const auto add = [&]<class Solve>(const std::string& name, Solve solve) {
      panel.choices.push_back(root_choice(name, questions, truths, solve, [](const Ray<double>& ray, const True&) {
        return 1 / glm::length(ray.direction);
      }));
    };
    add("Ferrari double", [torus](const Ray<double>& ray) { return ferraris(torus, ray); });
    for (const LevelInfo& info : level_infos) {
      add("ours " + std::string(info.name),
          [torus, level = info.level](const Ray<double>& ray) { return few_of(torus_roots(torus, ray, level)); });
    }
    all.push_back(std::move(panel));
  }
  return all;
}

}  // namespace

Axis torus_axis() { return {"torus", "how the crossings of a line and a torus are found", panels}; }

}  // namespace sightline::bench
