#pragma once
/// What a run is asked to do.

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/asking.h"
#include "sightline/query/accelerator_spec.h"

namespace sightline::bench {

enum class Workload { build, primary, bounce, shadow };

struct WorkloadInfo {
  Workload workload;
  std::string_view name;
  std::string_view description;
};
inline constexpr std::array<WorkloadInfo, 4> workload_infos{{
    {Workload::build, "build", "from the mesh to a structure that is ready to be asked, with --threads threads"},
    {Workload::primary, "primary", "closest hit of camera rays, pixel by pixel: neighbours take the same way"},
    {Workload::bounce, "bounce", "closest hit of diffuse reflections: cosine-distributed, every ray its own way"},
    {Workload::shadow, "shadow", "any hit of rays from the surface to points on a lamp above the scene"},
}};
inline constexpr std::size_t workload_count = workload_infos.size();
inline constexpr std::size_t index_of(Workload workload) { return static_cast<std::size_t>(workload); }

struct Plan {
  std::vector<std::string> scenes;
  std::vector<AcceleratorSpec> structures;                    ///< Under the labels that the report gives them.
  std::vector<Level> levels{Level::watertight};               ///< Of all structures, each once, the strictest first.
  bool is_stream = false;                                     ///< Those that can are asked in streams as well.
  std::vector<std::string> peers{"embree", "embree-robust"};  ///< Names of this build's peers, each once.
  std::vector<Workload> workloads{Workload::build, Workload::primary, Workload::bounce, Workload::shadow};
  std::size_t rays = 100'000;        ///< Of each workload.
  std::string slow_scene{"sticks"};  ///< Asked a tenth of them, because most structures collapse there; or empty.
  int rounds = 9;
  int threads = 0;  ///< To build with; 0 for as many as there are.
  std::filesystem::path data_dir;
  std::string spoiled;  ///< Name of a contender of ours whose hits are made wrong on purpose; usually empty.

  /// A contender runs its rays as often as fills this in a round, so that the clock's grain does not count.
  double slot_seconds = 0.05;
  /// One that would need longer than this for all its rounds of a workload takes part in fewer.
  double ray_seconds = 4;
  double build_seconds = 6;
  double oracle_tests = 2e8;  ///< Tests of a ray with a triangle that brute force may spend on verifying a workload.
  double few_tests = 2e7;     ///< The same for one pass of those that are asked fewer rays; see Contender.

  std::string growth;  ///< A family of scenes, to be measured at growing sizes instead of `scenes`; or empty.
  std::size_t growth_limit = 300'000;  ///< Triangles of the largest, about.

  /// One that would build the next size for longer is left out from there on. At larger limits that is as long as
  /// building the largest takes at 150,000 triangles a second.
  double growth_build_seconds() const { return std::max(4.0, static_cast<double>(growth_limit) / 150'000); }

  std::size_t rays_of(const std::string& scene) const { return scene == slow_scene ? (rays + 9) / 10 : rays; }

  bool has(Workload workload) const {
    for (const Workload w : workloads) {
      if (w == workload) return true;
    }
    return false;
  }
};

inline constexpr int fewest_ray_rounds = 3;

}  // namespace sightline::bench
