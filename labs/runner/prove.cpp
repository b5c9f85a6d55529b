#include "labs/runner/prove.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "labs/runner/compile.h"
#include "labs/runner/session.h"
#include "labs/runner/starter.h"
#include "sightline/io/child_process.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw FileError(path, 0, "a file of the lab", "none");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Everything that a lab's program is made of, and how it went.
struct Trial {
  const Lab* lab;
  std::string name;                          ///< "starter", "solution" or a mutant's.
  std::map<std::string, std::string> files;  ///< By name.
  std::string check;                         ///< Of a mutant: which has to notice.
  std::string verdict;                       ///< Empty where all is as it should be.
  std::string note;
};

std::string failures_of(const Report& report) {
  std::string names;
  for (const Outcome& outcome : report.outcomes) {
    if (outcome.state != Outcome::State::passed) names += (names.empty() ? "" : ", ") + outcome.check->name;
  }
  return names.empty() ? "none" : names;
}

void judge(Trial& trial, const Report& report) {
  if (!report.is_built) {
    trial.verdict = "does not build\n" + report.messages.substr(0, 1500);
  } else if (trial.name == "starter") {
    // Something may pass of a starter, but nothing that is asked may work as a whole, nor fail for another reason.
    const auto failed = std::ranges::count(report.outcomes, Outcome::State::failed, &Outcome::state);
    if (report.holes() == 0) trial.verdict = "nothing is left to be written";
    if (failed > 0) trial.verdict = "fails otherwise than by what is not written: " + failures_of(report);
  } else if (trial.check.empty()) {
    if (!report.is_whole()) trial.verdict = "fails: " + failures_of(report);
    for (const Outcome& outcome : report.outcomes) {
      if (outcome.state != Outcome::State::passed) {
        trial.verdict +=
            "\n    " + outcome.id() + ": expected " + outcome.trouble.expected + ", got " + outcome.trouble.got;
      }
    }
  } else {
    const bool is_caught = std::ranges::any_of(report.outcomes, [&](const Outcome& outcome) {
      return outcome.check->name == trial.check && outcome.state != Outcome::State::passed;
    });
    trial.verdict = is_caught ? "" : "is not caught by " + trial.check;
    trial.note = is_caught ? "caught by " + trial.check : "";
  }
}

void run_trial(const Workshop& workshop, Trial& trial, const fs::path& scratch) {
  const fs::path folder = scratch / trial.lab->number / trial.name;
  for (const auto& [name, text] : trial.files) write_text(folder / name, text);
  const Compiled compiled = compile_subject(workshop, *trial.lab, folder, folder / ".build");
  Report report{trial.lab, compiled.is_built, compiled.messages, {}};
  if (compiled.is_built) {
    Subject subject({compiled.program}, {std::chrono::milliseconds(4000), std::uint64_t{4} << 30});
    report.outcomes = run_checks(*trial.lab, subject, 1, trial.check);
  }
  judge(trial, report);
}

/// The file with the mutant in it. \throws FileError where it does not fit
std::string mutated(const fs::path& path, const std::string& text, const Mutant& mutant) {
  const std::size_t at = text.find(mutant.before);
  if (mutant.before.empty() || at == std::string::npos || text.find(mutant.before, at + 1) != std::string::npos) {
    throw FileError(path, 0, "the lines of mutant '" + mutant.name + "' exactly once",
                    at == std::string::npos ? "none" : "several");
  }
  std::string changed = text;
  return changed.replace(at, mutant.before.size(), mutant.after);
}

std::vector<Trial> trials_of(const Workshop& workshop, const Lab& lab, bool has_mutants) {
  const fs::path solution = workshop.folder_of(lab) / "solution";
  Trial starter{&lab, "starter", {}, {}, {}, {}}, whole{&lab, "solution", {}, {}, {}, {}};
  for (const std::string& name : lab.files) {
    whole.files[name] = text_of(solution / name);
    starter.files[name] = starter_of(solution / name, whole.files[name]);
  }
  std::vector<Trial> trials{starter, whole};
  if (!has_mutants) return trials;
  for (const Mutant& mutant : read_mutants(workshop.folder_of(lab) / "mutants.txt")) {
    if (!whole.files.contains(mutant.file)) {
      throw FileError(workshop.folder_of(lab) / "mutants.txt", 0, "a file of the lab", mutant.file);
    }
    Trial trial = whole;
    trial.name = mutant.name;
    trial.check = mutant.check;
    trial.files[mutant.file] = mutated(solution / mutant.file, whole.files[mutant.file], mutant);
    trials.push_back(std::move(trial));
  }
  return trials;
}

}  // namespace

std::vector<Mutant> read_mutants(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw FileError(file, 0, "mutants of the lab", "no such file");
  std::vector<Mutant> mutants;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto rest = [&](std::string_view key) { return line.substr(key.size()); };
    if (line.starts_with("== ")) {
      mutants.push_back({rest("== "), "", "", "", "", ""});
    } else if (line.empty() || line[0] == '#') {
    } else if (mutants.empty()) {
      throw FileError(file, number, "== NAME", line);
    } else if (line.starts_with("file ")) {
      mutants.back().file = rest("file ");
    } else if (line.starts_with("bug ")) {
      mutants.back().bug = rest("bug ");
    } else if (line.starts_with("check ")) {
      mutants.back().check = rest("check ");
    } else if (line[0] == '-' || line[0] == '+' || line[0] == ' ') {
      if (line[0] != '+') mutants.back().before += line.substr(1) + "\n";
      if (line[0] != '-') mutants.back().after += line.substr(1) + "\n";
    } else {
      throw FileError(file, number, "file, bug, check, or a line that begins with -, + or a blank", line);
    }
  }
  for (const Mutant& mutant : mutants) {
    if (mutant.file.empty() || mutant.bug.empty() || mutant.check.empty() || mutant.before == mutant.after) {
      throw FileError(file, 0, "file, bug, check and a change of mutant '" + mutant.name + "'", "less");
    }
  }
  return mutants;
}

int prove_labs(const Workshop& workshop, const std::vector<std::string>& labs, bool has_mutants, int threads) {
  std::vector<Trial> trials;
  for (const Lab& lab : all_labs()) {
    const bool is_asked =
        labs.empty() || std::ranges::any_of(labs, [&](const std::string& text) { return &lab_called(text) == &lab; });
    if (!is_asked) continue;
    auto more = trials_of(workshop, lab, has_mutants);
    std::ranges::move(more, std::back_inserter(trials));
  }
  std::string pattern = (fs::temp_directory_path() / "sightline-labs-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw FileError(pattern, 0, "a folder to work in", "none can be made");
  const fs::path scratch = pattern;
  std::atomic<std::size_t> next = 0, wrong = 0;
  std::mutex output;
  const auto work = [&] {
    for (std::size_t i = next++; i < trials.size(); i = next++) {
      Trial& trial = trials[i];
      try {
        // A process of its own: RapidCheck is not made for several threads.
        const std::string answer = run_in_child(
            [&] {
              run_trial(workshop, trial, scratch);
              return trial.verdict + '\0' + trial.note;
            },
            {std::chrono::seconds(300)});
        trial.verdict = answer.substr(0, answer.find('\0'));
        trial.note = answer.substr(answer.find('\0') + 1);
      } catch (const std::exception& error) {
        trial.verdict = error.what();
      }
      const std::scoped_lock lock(output);
      wrong += !trial.verdict.empty();
      std::cout << trial.lab->number << ' ' << trial.name << ": "
                << (trial.verdict.empty() ? (trial.note.empty() ? "as it should be" : trial.note)
                                          : "WRONG, " + trial.verdict)
                << std::endl;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < threads; ++i) workers.emplace_back(work);
  }
  fs::remove_all(scratch);
  const auto mutants =
      static_cast<std::size_t>(std::ranges::count_if(trials, [](const Trial& t) { return !t.check.empty(); }));
  const auto caught = static_cast<std::size_t>(
      std::ranges::count_if(trials, [](const Trial& t) { return !t.check.empty() && t.verdict.empty(); }));
  std::cout << trials.size() - wrong << " of " << trials.size() << " as they should be";
  if (mutants > 0) std::cout << ", " << caught << " of " << mutants << " mutants caught";
  std::cout << '\n';
  return wrong == 0 ? 0 : 1;
}

}  // namespace sightline::labs
