#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/checks.h"
#include "bench/contender.h"
#include "bench/rays.h"
#include "bench/report.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

/// How the plan asks this structure: by level, single rays before streams.
std::vector<Asking> askings_of(const Plan& plan, const AcceleratorSpec& spec);

/// The contenders of a run: the plan's structures in their order, each asked in all its ways, then the peers.
using Contenders = std::vector<std::unique_ptr<Contender>>;
Contenders make_contenders(const Plan& plan);

/// One scene with every contender built, every workload's rays made and every hit verified: all but the times.
///
/// Ours are held against brute force on a sample of the rays, and against one structure of the registry on all of them,
/// bit for bit and at the level that they are asked at; where two differ, brute force tells which is wrong. Peers are
/// held against the same structure at level watertight, within the rounding of their arithmetic, and the
/// number of disagreeing rays is kept.
///
/// A structure that is asked in several ways is built once.
class Stage {
 public:
  /// Refers to `plan` and `contenders`, which must live as long.
  /// \throws WrongHits naming structure, scene, workload and ray.
  Stage(const Plan& plan, const std::string& scene, std::shared_ptr<const TriangleMesh> mesh,
        const Contenders& contenders, Progress& progress);

  SceneReport& report() { return report_; }
  const SceneReport& report() const { return report_; }

  /// How long the first build of each contender's structure took, by the clock on the wall.
  const std::vector<double>& first_build_seconds() const { return first_build_seconds_; }

  /// Builds contender `c` once more.
  std::unique_ptr<Built> build(std::size_t c) const { return contenders_[c]->build(mesh_); }
  /// Asks contender `c` its rays of the workload once. All write their answers to one place, so that none finds it
  /// warmer than another.
  void trace(std::size_t c, Workload workload);

 private:
  void build_all(Progress& progress);
  std::optional<std::size_t> built_as(std::size_t c) const;
  template <class Answer>
  void verify(Workload workload, const Built& reference, const Built& oracle, Progress& progress);
  template <class Answer>
  void verify_one(std::size_t c, Workload workload, const Checks<Answer>& checks);
  bool is_asked_fewer(std::size_t c) const { return contenders_[c]->tests_per_ray(mesh_->size()) > 0; }
  std::span<const Ray<float>> rays_of(std::size_t c, Workload workload) const;

  const Plan& plan_;
  std::shared_ptr<const TriangleMesh> mesh_;
  const Contenders& contenders_;
  std::vector<std::unique_ptr<Built>> built_;
  std::vector<double> first_build_seconds_;
  RaySets rays_;
  std::vector<RaySets> few_rays_;  ///< By contender: those of them that one is asked that is not asked all.
  std::vector<Hit<float>> hits_;
  std::vector<std::uint8_t> is_hit_;
  SceneReport report_;
};

}  // namespace sightline::bench
