#pragma once
/// A lab checked: its program compiled, its checks run, what came out kept and told.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "labs/check/check.h"
#include "labs/runner/workshop.h"

namespace sightline::labs {

/// Every check of a lab.
struct Report {
  const Lab* lab = nullptr;
  bool is_built = false;
  std::string messages;  ///< The compiler's.
  std::vector<Outcome> outcomes;

  std::size_t passed() const;
  std::size_t holes() const;
  bool is_whole() const { return is_built && passed() == outcomes.size(); }
  /// Everything but what is asked of its work.
  bool is_right() const;
};

/// Runs the checks of that name, or all, where `only` is empty.
/// \throws std::invalid_argument where none is called so
std::vector<Outcome> run_checks(const Lab& lab, Subject& subject, std::uint64_t seed, const std::string& only = {});

/// "not started", "does not build", "failing 3 of 12", "passes", "passes within cost budget".
std::string state_of(const Report& report);

/// What `list` shows later without running anything.
void keep_state(const Workshop& workshop, const Report& report);
/// The state that was kept, and whether files have changed since.
std::string kept_state(const Workshop& workshop, const Lab& lab);

/// Everything about it, for programs.
nlohmann::json json_of(const Report& report);

}  // namespace sightline::labs
