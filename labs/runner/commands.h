#pragma once
/// What a student asks of the runner. Each returns the status to exit with.

#include <cstdint>
#include <string>
#include <vector>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// What the flags of the command line say, the same for all commands.
struct Request {
  std::string lab;                 ///< Number or name.
  std::string check;               ///< Only this one.
  std::string at;                  ///< A case: "lattice:0,0,1/...".
  std::string json;                ///< A file for the report.
  std::vector<std::string> words;  ///< view and bench: what another program is told.
  std::uint64_t seed = 1;          ///< Of all that is drawn by chance.
  bool has_pictures = true;
  bool replaces = false;  ///< start: what is there already.
};

int list_labs(const Workshop& workshop);
int start_lab(const Workshop& workshop, const Request& request);
int check_lab(const Workshop& workshop, const Request& request);
int hint_lab(const Workshop& workshop, const Request& request);
int replay_case(const Workshop& workshop, const Request& request);
int submit_lab(const Workshop& workshop, const Request& request);
int view_lab(const Workshop& workshop, const Request& request);
int bench_lab(const Workshop& workshop, const Request& request);
/// Structures of one's own in labs/mine: laws, benchmark, picture.
int try_mine(const Workshop& workshop, const Request& request);

}  // namespace sightline::labs
