#include "bench/claims/run.h"

#include "bench/claims/course.h"

namespace sightline::bench {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{bsp_cost_claim,   kd_build_claim,         kd_search_claim,
                                      lazy_bih_claim,   bounding_spheres_claim, unordered_hierarchies_claim,
                                      grid_cells_claim, matrices_claim,         csg_claim,
                                      noise_claim};
  return all;
}

ClaimsReport run_claims(const ClaimsPlan& plan, Progress& progress,
                        const std::function<void(const ClaimsReport&, const ClaimReport&)>& see) {
  ClaimsReport report{this_machine(), plan, {}};
  for (const Claim* claim : plan.claims) {
    const std::string name(claim->name);
    progress.say(name);
    const Effort effort{plan.is_quick, plan.seed,
                        plan.data_dir, [&](const std::string& what) { progress.say(name, what); },
                        plan.rounds,   plan.share};
    Finding finding = claim->measure(effort);
    progress.clear();
    report.claims.push_back({claim, std::move(finding)});
    see(report, report.claims.back());
  }
  return report;
}

}  // namespace sightline::bench
