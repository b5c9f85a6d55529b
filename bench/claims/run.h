#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/claims/claim.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

struct ClaimsPlan {
  std::vector<const Claim*> claims;  ///< In the order they are shown.
  int rounds = 9;
  std::uint64_t seed = 1;
  bool is_quick = false;
  double share = 1;  ///< Of all counts; see Effort.
  std::string data_dir;
  std::string json, html;  ///< Files to be written; empty for none.
};

struct ClaimReport {
  const Claim* claim;
  Finding finding;
};

struct ClaimsReport {
  Machine machine;
  ClaimsPlan plan;
  std::vector<ClaimReport> claims;
};

/// One after the other; see(report, claim) is told of each when it is complete. \throws WrongHits
ClaimsReport run_claims(const ClaimsPlan& plan, Progress& progress,
                        const std::function<void(const ClaimsReport&, const ClaimReport&)>& see);

std::string head_text(const ClaimsReport& report);
std::string claim_text(const ClaimReport& report);
/// All of them, a line each.
std::string verdicts_text(const ClaimsReport& report);
std::string json_text(const ClaimsReport& report);
/// One page that needs nothing else.
std::string page_text(const ClaimsReport& report);

/// `sightline-bench claims ...`; throws what bench/main.cpp handles.
int run_claims_command(int argc, const char* const* argv);

}  // namespace sightline::bench
