#pragma once
/// What the claims about structures share: rays, structures whose hits are the same, and times taken in turns.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/claims/claim.h"
#include "sightline/query/tracer.h"

namespace sightline::bench {

using MeshPtr = std::shared_ptr<const TriangleMesh>;
using TracerPtr = std::shared_ptr<const Tracer>;

/// All that it starts runs on the calling thread, so that its processor time is the time of it all.
void on_one_thread(const std::function<void()>& run);

/// "kd-tree:quality=best", built by one thread.
TracerPtr traced(const std::string& spec, const MeshPtr& mesh);

/// Half of them between random points around the mesh, the other half off what such rays hit. Always the same for the
/// same arguments.
std::vector<Ray<float>> mixed_rays(const MeshPtr& mesh, std::size_t count, std::uint64_t seed);

/// \throws WrongHits where two of them differ, naming the place.
void require_same_hits(const std::string& place, std::span<const TracerPtr> tracers, std::span<const Ray<float>> rays);

/// Mean counts a ray.
struct Work {
  double nodes, leaves, candidates;
};
Work work_of(const Tracer& tracer, std::span<const Ray<float>> rays);

struct Line {
  std::function<double()> pass;  ///< What is timed. Its result depends on all that it does.
  double units = 1;              ///< In a pass.
};

/// Asks a tracer all rays.
Line ray_line(const TracerPtr& tracer, const std::vector<Ray<float>>& rays);

/// NaN, which is on no side of a limit, where nothing was measured.
inline Estimate known(const std::optional<Estimate>& estimate) {
  return estimate.value_or(Estimate{not_asked, not_asked, not_asked, 0});
}

/// By line, in the order they were given: seconds a unit in each round.
class Times {
 public:
  explicit Times(std::vector<std::vector<double>> rounds) : rounds_(std::move(rounds)) {}
  Estimate nanoseconds(std::size_t line) const;
  /// Of the times of two lines in the same rounds.
  Estimate ratio(std::size_t over, std::size_t under) const;
  const std::vector<double>& rounds(std::size_t line) const { return rounds_[line]; }

 private:
  std::vector<std::vector<double>> rounds_;
};

/// In rounds in which all lines take turns, by this thread's processor time, each after one pass that does not count. A
/// line that has taken more than `line_seconds` sits out the rest.
Times time_lines(const Effort& effort, const std::string& what, std::span<const Line> lines, double line_seconds = 60);

/// From 1000 on, two a decade, up to the limit.
std::vector<std::size_t> growing_sizes(const Effort& effort, std::size_t full_limit, std::size_t quick_limit);

/// A landscape or random triangles ("terrain", "soup"), of about as many.
MeshPtr mesh_of(std::string_view family, std::size_t triangles);

/// With its fit.
Growth growth_of(std::string name, std::string x_unit, std::string y_unit, std::vector<double> x, std::vector<double> y,
                 std::string chart = {});

}  // namespace sightline::bench
