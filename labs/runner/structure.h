#pragma once
/// A student's structure beside ours: under the same laws, in the same benchmark, in the same viewer.

#include <string>
#include <vector>

#include "labs/runner/compile.h"
#include "labs/runner/workshop.h"

namespace sightline::labs {

/// A class that satisfies the contract, and where it is.
struct OwnStructure {
  std::filesystem::path header;
  std::string type;  ///< "student::KdTree".

  std::string name() const { return header.stem().string(); }
};

/// labs/mine/*.h: each file holds the class of its own name in namespace student, quad_tree.h student::QuadTree.
std::vector<OwnStructure> dropped_in(const Workshop& workshop);

/// Compiles it into a file that --accel takes in every program (structure_plugin.h).
Compiled compile_plugin(const Workshop& workshop, const OwnStructure& structure);

/// Compiles the laws that all structures keep (tests/accel/laws.h) for this one: a program that runs them.
Compiled compile_laws(const Workshop& workshop, const OwnStructure& structure);

/// Runs a program of ours with the structure as --accel, and its output to the terminal. Its exit status.
int run_with(const Workshop& workshop, const std::string& program, std::vector<std::string> words);

}  // namespace sightline::labs
