#pragma once
/// What a student asks of the runner. Each returns the status to exit with.

#include <cstdint>
#include <string>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// What the flags of the command line say, the same for all commands.
struct Request {
  std::string lab;         ///< Number or name.
  std::string check;       ///< Only this one.
  std::string at;          ///< A case: "lattice:0,0,1/...".
  std::string json;        ///< A file for the report.
  std::uint64_t seed = 1;  ///< Of all that is drawn by chance.
  bool has_pictures = true;
  bool replaces = false;  ///< start: what is there already.
};

int list_labs(const Workshop& workshop);
int start_lab(const Workshop& workshop, const Request& request);
int check_lab(const Workshop& workshop, const Request& request);
int hint_lab(const Workshop& workshop, const Request& request);
int replay_case(const Workshop& workshop, const Request& request);
int view_lab(const Workshop& workshop, const Request& request);

}  // namespace sightline::labs
