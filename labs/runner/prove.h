#pragma once
/// The labs, tested: every starter builds and does nothing yet, every solution passes, every mutant is caught.

#include <string>
#include <vector>

#include "labs/runner/workshop.h"

namespace sightline::labs {

/// A fault that students make, in the solution.
struct Mutant {
  std::string name;       ///< "strict-far-limit".
  std::string file, bug;  ///< What is changed; what a student would have got wrong.
  std::string check;      ///< Which has to notice.
  std::string before, after;
};

/// What a lab's mutants.txt tells:
///     == NAME
///     file kd_tree.h
///     bug A sentence.
///     check lattice
///     -lines that are replaced
///     +by these
/// Lines that begin with a blank are in both. Together they occur in the file exactly once.
/// \throws FileError
std::vector<Mutant> read_mutants(const std::filesystem::path& file);

/// A line each; 1 where anything is not as it should be. `labs` are numbers or names; all where there are none.
int prove_labs(const Workshop& workshop, const std::vector<std::string>& labs, bool has_mutants, int threads);

}  // namespace sightline::labs
