#include "labs/runner/session.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

fs::path state_file(const Workshop& workshop, const Lab& lab) {
  return workshop.work_of(lab) / ".build" / "state.json";
}

/// Changes with every byte of the student's files.
std::string fingerprint(const fs::path& folder, const Lab& lab) {
  std::size_t hash = 0;
  for (const std::string& name : lab.files) {
    std::ifstream in(folder / name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    hash = hash * 0x9e3779b97f4a7c15u + std::hash<std::string>()(bytes);
  }
  return std::to_string(hash);
}

const char* word_of(Outcome::State state) {
  switch (state) {
    case Outcome::State::passed:
      return "passed";
    case Outcome::State::failed:
      return "failed";
    case Outcome::State::hole:
      break;
  }
  return "not yet implemented";
}

}  // namespace

std::size_t Report::passed() const {
  return static_cast<std::size_t>(
      std::ranges::count(outcomes, Outcome::State::passed, [](const Outcome& o) { return o.state; }));
}

std::size_t Report::holes() const {
  return static_cast<std::size_t>(
      std::ranges::count(outcomes, Outcome::State::hole, [](const Outcome& o) { return o.state; }));
}

bool Report::is_right() const {
  return is_built && std::ranges::all_of(outcomes, [](const Outcome& o) {
           return o.state == Outcome::State::passed || o.check->is_budget;
         });
}

std::vector<Outcome> run_checks(const Lab& lab, Subject& subject, std::uint64_t seed, const std::string& only) {
  std::vector<Outcome> outcomes;
  std::string known;
  for (const Check& check : lab.checks) {
    known += (known.empty() ? "" : ", ") + check.name;
    if (only.empty() || only == check.name) outcomes.push_back(run(check, subject, seed));
  }
  if (outcomes.empty()) throw std::invalid_argument("unknown check '" + only + "'; expected one of " + known);
  return outcomes;
}

std::string state_of(const Report& report) {
  if (!report.is_built) return "does not build";
  const std::size_t all = report.outcomes.size(), failing = all - report.passed();
  if (report.is_whole()) {
    const bool has_budget = std::ranges::any_of(report.lab->checks, &Check::is_budget);
    return has_budget ? "passes within cost budget" : "passes";
  }
  if (report.is_right()) return "passes";
  return "failing " + std::to_string(failing) + " of " + std::to_string(all);
}

void keep_state(const Workshop& workshop, const Report& report) {
  const nlohmann::json json{{"state", state_of(report)},
                            {"fingerprint", fingerprint(workshop.work_of(*report.lab), *report.lab)}};
  write_text(state_file(workshop, *report.lab), json.dump(2) + "\n");
}

std::string kept_state(const Workshop& workshop, const Lab& lab) {
  if (!fs::exists(workshop.work_of(lab))) return "not started";
  std::ifstream in(state_file(workshop, lab));
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("state") || !json["state"].is_string()) return "started, not checked yet";
  const bool is_same = json.value("fingerprint", "") == fingerprint(workshop.work_of(lab), lab);
  return json["state"].get<std::string>() + (is_same ? "" : ", changed since");
}

nlohmann::json json_of(const Report& report) {
  nlohmann::json checks = nlohmann::json::array();
  for (const Outcome& outcome : report.outcomes) {
    nlohmann::json entry{{"name", outcome.check->name},
                         {"section", outcome.check->section},
                         {"state", word_of(outcome.state)},
                         {"budget", outcome.check->is_budget},
                         {"cases", outcome.cases}};
    if (outcome.state != Outcome::State::passed) {
      entry["case"] = outcome.id();
      entry["input"] = outcome.check->describe ? outcome.check->describe(outcome.at) : "";
      entry["expected"] = outcome.trouble.expected;
      entry["got"] = outcome.trouble.got;
      entry["why"] = outcome.check->why;
    }
    checks.push_back(std::move(entry));
  }
  return {{"lab", report.lab->folder()}, {"state", state_of(report)}, {"built", report.is_built},
          {"messages", report.messages}, {"passed", report.passed()}, {"checks", std::move(checks)}};
}

}  // namespace sightline::labs
