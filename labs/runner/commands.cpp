#include "labs/runner/commands.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/run_program.h"
#include "labs/runner/compile.h"
#include "labs/runner/pictures.h"
#include "labs/runner/session.h"
#include "labs/runner/submission.h"
#include "labs/runner/tell.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

constexpr int success = 0, failure = 1;

bool has_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

/// The student's folder of a lab. \throws FileError where it was not started
fs::path started(const Workshop& workshop, const Lab& lab) {
  const fs::path folder = workshop.work_of(lab);
  if (!fs::is_directory(folder)) {
    throw FileError(Workshop::shown(folder), 0, "the lab's files: ./sightline lab start " + lab.number,
                    "no such folder");
  }
  return folder;
}

Report checked(const Workshop& workshop, const Lab& lab, const Request& request) {
  const fs::path source = started(workshop, lab);
  const Compiled compiled = compile_subject(workshop, lab, source, source / ".build");
  Report report{&lab, compiled.is_built, compiled.messages, {}};
  if (!compiled.is_built) return report;
  Subject subject({compiled.program});
  report.outcomes = run_checks(lab, subject, request.seed, request.check);
  for (const Outcome& outcome : report.outcomes) {
    const fs::path picture = picture_of(workshop, lab, outcome);
    fs::remove(picture);
    if (!request.has_pictures || outcome.state != Outcome::State::failed) continue;
    std::string problem;
    if (const auto drawing = draw(*outcome.check, subject, outcome.at)) {
      if (!draw_picture(workshop, *drawing, picture, problem)) std::cerr << "sightline-lab: " << problem << '\n';
    }
  }
  return report;
}

/// How many hints a student has seen of each check.
fs::path hint_file(const Workshop& workshop, const Lab& lab) { return workshop.work_of(lab) / ".build" / "hints.json"; }

}  // namespace

int list_labs(const Workshop& workshop) {
  for (const Lab& lab : all_labs()) {
    std::printf("  %s  %-28s %s\n", lab.number.c_str(), lab.title.c_str(), kept_state(workshop, lab).c_str());
  }
  std::printf("\nBegin with ./sightline lab start NN and read the handout that it names.\n");
  return success;
}

int start_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  const fs::path folder = workshop.work_of(lab);
  for (const std::string& name : lab.files) {
    if (fs::exists(folder / name) && !request.replaces) {
      throw FileError(Workshop::shown(folder / name), 0, "a lab that is not started, or --again to begin it anew",
                      "what you have written");
    }
  }
  for (const std::string& name : lab.files) {
    const std::string starter = workshop.starter_text(lab, name);
    if (fs::exists(folder / name)) fs::rename(folder / name, folder / (name + ".before"));
    write_text(folder / name, starter);
  }
  const std::string shown = Workshop::shown(folder);
  std::printf("Lab %s, %s\n", lab.number.c_str(), lab.title.c_str());
  std::printf("  read     %s\n", Workshop::shown(workshop.folder_of(lab) / "README.md").c_str());
  for (const std::string& name : lab.files) std::printf("  write    %s/%s\n", shown.c_str(), name.c_str());
  std::printf("  check    ./sightline lab check %s\n  watch    ./sightline lab watch %s\n", lab.number.c_str(),
              lab.number.c_str());
  return success;
}

int check_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  const Report report = checked(workshop, lab, request);
  if (request.check.empty()) keep_state(workshop, report);
  if (!request.json.empty()) write_text(request.json, json_of(report).dump(2) + "\n");
  Teller(std::cout, has_terminal()).tell(workshop, report);
  return report.is_whole() ? success : failure;
}

int hint_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  Request silent = request;
  silent.has_pictures = false;
  const Report report = checked(workshop, lab, silent);
  if (!report.is_built) {
    std::cout << report.messages;
    return failure;
  }
  const auto open =
      std::ranges::find_if(report.outcomes, [](const Outcome& o) { return o.state != Outcome::State::passed; });
  if (open == report.outcomes.end()) {
    std::printf("Every check passes. Going further: see the end of the handout.\n");
    return success;
  }
  const Check& check = *open->check;
  if (open->state == Outcome::State::hole) {
    std::printf("%s: %s\n", check.name.c_str(), open->trouble.got.c_str());
    return success;
  }
  std::ifstream in(hint_file(workshop, lab));
  nlohmann::json seen = nlohmann::json::parse(in, nullptr, false);
  if (!seen.is_object()) seen = nlohmann::json::object();
  const int before = seen.value(check.name, 0);
  const std::size_t count =
      std::min<std::size_t>(static_cast<std::size_t>(std::max(before, 0)) + 1, check.hints.size());
  std::printf("%s  (handout, %s)\n", check.name.c_str(), check.section.c_str());
  for (std::size_t i = 0; i < count; ++i)
    std::printf("  %zu of %zu: %s\n", i + 1, check.hints.size(), check.hints[i].c_str());
  seen[check.name] = count;
  write_text(hint_file(workshop, lab), seen.dump() + "\n");
  return success;
}

int replay_case(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  const std::string name = request.at.substr(0, request.at.find(':'));
  const auto found = std::ranges::find(lab.checks, name, &Check::name);
  if (found == lab.checks.end() || request.at.size() == name.size()) {
    throw std::invalid_argument("--case: expected CHECK:NUMBERS as a failure prints it, found '" + request.at + "'");
  }
  Case at;
  try {
    at = found->recipe.parse(request.at.substr(name.size() + 1));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--case: ") + error.what());
  }
  const fs::path source = started(workshop, lab);
  const Compiled compiled = compile_subject(workshop, lab, source, source / ".build");
  if (!compiled.is_built) {
    std::cout << compiled.messages;
    return failure;
  }
  Subject subject({compiled.program});
  const Outcome outcome = run_case(*found, subject, at);
  const fs::path picture = picture_of(workshop, lab, outcome);
  std::string problem;
  if (const auto drawing = request.has_pictures ? draw(*found, subject, at) : std::nullopt) {
    if (!draw_picture(workshop, *drawing, picture, problem)) std::cerr << "sightline-lab: " << problem << '\n';
  }
  Teller(std::cout, has_terminal()).tell(workshop, lab, outcome);
  return outcome.state == Outcome::State::passed ? success : failure;
}

int submit_lab(const Workshop& workshop, const Request& request) {
  const Lab& lab = lab_called(request.lab);
  Request silent = request;
  silent.has_pictures = false;
  const Report report = checked(workshop, lab, silent);
  const fs::path archive = pack_submission(workshop, lab);
  std::printf("Lab %s %s. To hand in: %s\n", lab.number.c_str(), state_of(report).c_str(),
              Workshop::shown(archive).c_str());
  return success;
}

}  // namespace sightline::labs
