/// view, bench and mine: what a student has made in the viewer and the benchmark, beside what the library has.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "labs/runner/commands.h"
#include "labs/runner/pictures.h"
#include "labs/runner/session.h"
#include "labs/runner/structure.h"
#include "sightline/io/file_error.h"
#include "viz/child_process.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

constexpr int success = 0, failure = 1;

/// What the compiler says of it, where it does not build.
bool is_told(const Compiled& compiled) {
  if (!compiled.is_built) std::cout << compiled.messages;
  return !compiled.is_built;
}

/// Those of ours that a student's is measured beside.
constexpr const char* ours = "box-tree,grid,bsp-tree,kd-tree,bih";

int bench_structure(const Workshop& workshop, const OwnStructure& structure, std::vector<std::string> words) {
  const Compiled plugin = compile_plugin(workshop, structure);
  if (is_told(plugin)) return failure;
  if (words.empty()) words = {"--scene", "teapot", "--quick", "--peer", "none"};
  words.insert(words.begin(), {"--accel", plugin.program.string() + "," + ours});
  return run_with(workshop, "sightline-bench", std::move(words));  // which verifies every hit first
}

OwnStructure structure_of(const Workshop& workshop, const Lab& lab) {
  return {workshop.work_of(lab) / lab.files.back(), lab.structure};
}

}  // namespace

int view_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  const fs::path source = workshop.work_of(lab);
  if (!request.words.empty() && !lab.structure.empty()) {
    const Compiled plugin = compile_plugin(workshop, structure_of(workshop, lab));
    if (is_told(plugin)) return failure;
    std::vector<std::string> words = request.words;
    words.insert(words.begin() + 1, {"--accel", plugin.program.string()});
    return run_with(workshop, "sightline-view", std::move(words));
  }
  if (!request.words.empty()) {
    throw std::invalid_argument("lab " + lab.folder() +
                                " makes no structure: view takes no more than the lab, found '" +
                                request.words.front() + "'");
  }
  const Compiled compiled = compile_subject(workshop, lab, source, source / ".build");
  if (is_told(compiled)) return failure;
  Subject subject({compiled.program});
  const fs::path picture = source / "pictures" / (lab.name + ".png");
  std::string problem;
  if (!draw_picture(workshop, lab.picture(subject), picture, problem)) throw std::runtime_error(problem);
  std::printf("%s\n", Workshop::shown(picture).c_str());
  return success;
}

int bench_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  if (lab.structure.empty()) {
    throw std::invalid_argument("lab " + lab.folder() + " makes no structure: there is nothing to measure beside ours");
  }
  const fs::path source = workshop.work_of(lab);
  const Compiled compiled = compile_subject(workshop, lab, source, source / ".build");
  if (is_told(compiled)) return failure;
  Subject subject({compiled.program});
  Report report{&lab, true, {}, run_checks(lab, subject, request.seed)};
  if (!report.is_right()) {
    std::printf("Lab %s is %s: what is wrong is not worth measuring. ./sightline lab check %s\n", lab.number.c_str(),
                state_of(report).c_str(), lab.number.c_str());
    return failure;
  }
  return bench_structure(workshop, structure_of(workshop, lab), request.words);
}

int try_mine(const Workshop& workshop, const Request& request) {
  const auto all = dropped_in(workshop);
  if (all.empty()) {
    throw FileError(Workshop::shown(workshop.mine()), 0,
                    "headers with a class of the file's name in namespace student (quad_tree.h: student::QuadTree)",
                    "none");
  }
  std::string known;
  bool is_found = false;
  int status = success;
  for (const OwnStructure& structure : all) {
    known += (known.empty() ? "" : ", ") + structure.name();
    if (!request.lab.empty() && request.lab != structure.name()) continue;
    is_found = true;
    std::printf("%s (%s)\n", structure.type.c_str(), Workshop::shown(structure.header).c_str());
    std::fflush(stdout);
    const Compiled laws = compile_laws(workshop, structure);
    if (is_told(laws) || viz::run_program(laws.program, {"--gtest_brief=1"}) != 0) {
      std::printf("It breaks a law of structures (tests/accel/laws.h), so it is neither measured nor drawn.\n");
      status = failure;
      continue;
    }
    status = std::max(status, bench_structure(workshop, structure, request.words));
    const Compiled plugin = compile_plugin(workshop, structure);
    const fs::path picture = structure.header.parent_path() / ".build" / structure.name() / "partitions.png";
    status =
        std::max(status, run_with(workshop, "sightline-view",
                                  {"partitions", "--accel", plugin.program, "--scene", "teapot", "--out", picture}));
  }
  if (!is_found) {
    throw std::invalid_argument("no structure '" + request.lab + "' in " + Workshop::shown(workshop.mine()) +
                                "; there are " + known);
  }
  return status;
}

}  // namespace sightline::labs
