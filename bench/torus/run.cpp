#include "bench/torus/run.h"

#include <cmath>

#include "bench/processor_time.h"
#include "bench/torus/rays.h"
#include "bench/torus/solver.h"
#include "bench/verify.h"

namespace sightline::bench {
namespace {

class Stage {
 public:
  Stage(const TorusPlan& plan, double minor, const TorusRays& set)
      : plan_(plan), torus_{Vec3d(0), Vec3d(0, 0, 1), 1, minor}, rays_(set.rays) {
    part_ = {minor, std::string(set.name), std::string(set.description), rays_.size(), 0, {}};
    add(std::nullopt);
    for (const Level level : plan.levels) add(level);
  }

  /// Level exact is an algebraic decision, which the tests hold against Sturm's theorem in rational numbers.
  void verify() {
    const auto reference = make_torus_solver(Level::exact);
    for (const Ray<double>& ray : rays_) {
      const RootList truth = reference->solve(torus_, ray);
      part_.roots += static_cast<std::size_t>(truth.count);
      for (std::size_t k = 0; k < solvers_.size(); ++k) check(k, ray, truth);
    }
  }

  void measure() {
    const auto count = solvers_.size(), rounds = static_cast<std::size_t>(plan_.rounds);
    for (TorusRow& row : part_.rows) row.round_seconds.assign(rounds, 0);
    for (std::size_t round = 0; round < rounds; ++round) {
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t line = (k + round) % count;
        const double begin = processor_seconds();
        solvers_[line]->count_all(torus_, rays_);
        part_.rows[line].round_seconds[round] = processor_seconds() - begin;
      }
    }
    for (TorusRow& row : part_.rows) {
      row.seconds = estimate(row.round_seconds);
      std::vector<double> ratios(rounds);
      for (std::size_t i = 0; i < rounds; ++i) ratios[i] = row.round_seconds[i] / part_.rows[0].round_seconds[i];
      row.ratio = estimate(ratios);
    }
  }

  TorusReportPart& part() { return part_; }

 private:
  void add(std::optional<Level> level) {
    solvers_.push_back(make_torus_solver(level));
    proves_.push_back(level == Level::precise || level == Level::exact);
    part_.rows.push_back({std::string(level ? info_of(*level).name : ferrari_name), 0, 0, {}, {}, {}});
  }

  void check(std::size_t k, const Ray<double>& ray, const RootList& truth) {
    TorusRow& row = part_.rows[k];
    RootList list = solvers_[k]->solve(torus_, ray);
    if (row.name == plan_.spoiled && list.count > 0 && row.wrong_counts == 0) --list.count;
    double error = 0;
    for (std::size_t i = 0; list.count == truth.count && i < static_cast<std::size_t>(truth.count); ++i) {
      const double off = std::fabs(list.roots[i].t - truth.roots[i].t);
      error = std::max(error, off * glm::length(ray.direction) / torus_.major);
      if (proves_[k] && list.is_certain && !(off <= list.roots[i].radius + truth.roots[i].radius)) refuse(row, ray);
    }
    row.wrong_counts += list.count != truth.count;
    row.worst_error = std::max(row.worst_error, error);
    if (proves_[k] && list.is_certain && list.count != truth.count) refuse(row, ray);
  }

  [[noreturn]] void refuse(const TorusRow& row, const Ray<double>& ray) const {
    const auto text = [](const Vec3d& v) {
      return '(' + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ')';
    };
    throw WrongHits(row.name + " is wrong, so no times are shown: r/R = " + std::to_string(torus_.minor) + ", " +
                    part_.name + ": expected the roots of exact numbers on the ray from " + text(ray.origin) +
                    " along " + text(ray.direction));
  }

  const TorusPlan& plan_;
  Torus torus_;
  const std::vector<Ray<double>>& rays_;
  TorusReportPart part_;
  std::vector<std::unique_ptr<TorusSolver>> solvers_;
  std::vector<bool> proves_;
};

}  // namespace

TorusReport run_torus(const TorusPlan& plan, Progress& progress,
                      const std::function<void(const TorusReport&, const TorusReportPart&)>& see) {
  TorusReport report{this_machine(), plan, {}};
  for (const double minor : plan.minors) {
    for (const TorusRays& set : torus_rays({Vec3d(0), Vec3d(0, 0, 1), 1, minor}, plan.rays)) {
      progress.say("torus " + number_text(minor), std::string(set.name));
      Stage stage(plan, minor, set);
      stage.verify();
      stage.measure();
      progress.clear();
      report.parts.push_back(std::move(stage.part()));
      see(report, report.parts.back());
    }
  }
  return report;
}

}  // namespace sightline::bench
