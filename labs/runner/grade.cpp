#include "labs/runner/grade.h"

#include <algorithm>
#include <atomic>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "bench/run_program.h"
#include "labs/runner/compile.h"
#include "labs/runner/grade_files.h"
#include "labs/runner/sandbox.h"
#include "labs/runner/session.h"
#include "labs/runner/submission.h"
#include "sightline/io/child_process.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A student's program waits no longer for its answers, all together; compiling takes no longer, nor more memory.
constexpr std::chrono::seconds longest_lab{60};
constexpr const char* longest_compilation = "60";
constexpr const char* most_memory = "4294967296";

/// What is compiled is read by the compiler alone, in the sandbox as well: #include may name any file.
Compiled compile_apart(const Workshop& workshop, const Lab& lab, const fs::path& folder, const Sandbox* sandbox) {
  const fs::path build = folder / ".build", log = folder / "messages";
  fs::create_directories(build);
  Compiled compiled{true, build / "subject", {}};
  for (const auto& command : compile_commands(workshop, lab, folder, build)) {
    std::vector<std::string> words{"/usr/bin/prlimit",
                                   std::string("--cpu=") + longest_compilation,
                                   std::string("--as=") + most_memory,
                                   "--fsize=268435456",
                                   "/usr/bin/timeout",
                                   "-sKILL",
                                   longest_compilation};
    const auto apart = sandbox == nullptr ? command : sandbox->wrap(command, workshop.sources(), {build, folder});
    words.insert(words.end(), apart.begin(), apart.end());
    compiled.is_built = bench::run_program(words, log) == 0;
    compiled.messages += bench::text_in(log).substr(0, 20000);
    if (!compiled.is_built) break;
  }
  return compiled;
}

/// One lab of one submission, as json_of a report.
json graded(const Workshop& workshop, const Lab& lab, const LabFiles& files, const fs::path& folder,
            const Sandbox* sandbox, std::uint64_t seed) {
  for (const auto& [name, text] : files) write_text(folder / name, text);
  const Compiled compiled = compile_apart(workshop, lab, folder, sandbox);
  Report report{&lab, compiled.is_built, compiled.messages, {}};
  if (compiled.is_built) {
    const std::vector<std::string> command{compiled.program};
    SubjectLimits limits;
    limits.all = longest_lab;
    Subject subject(sandbox == nullptr ? command : sandbox->wrap_alone(command, {compiled.program.parent_path()}),
                    limits);
    report.outcomes = run_checks(lab, subject, seed);
  }
  return json_of(report);
}

json failed_to_grade(const Lab& lab, const std::string& why) {
  return {{"lab", lab.folder()}, {"state", "not gradable"}, {"built", false}, {"messages", why},
          {"passed", 0},         {"checks", json::array()}};
}

std::string student_of(const fs::path& submission) {
  std::string name = fs::absolute(submission).lexically_normal().filename();
  if (name.empty()) name = fs::absolute(submission).lexically_normal().parent_path().filename();
  for (const char* ending : {".tar.gz", ".tgz"}) {
    if (name.ends_with(ending)) name.resize(name.size() - std::string_view(ending).size());
  }
  return name;
}

std::vector<const Lab*> labs_of(const GradeRequest& request) {
  std::vector<const Lab*> labs;
  for (const std::string& text : request.labs) labs.push_back(&lab_called(text));
  if (labs.empty()) {
    for (const Lab& lab : all_labs()) labs.push_back(&lab);
  }
  return labs;
}

StudentGrades grade_one(const Workshop& workshop, const GradeRequest& request, const fs::path& submission,
                        const fs::path& scratch, const Sandbox* sandbox) {
  StudentGrades grades{student_of(submission), {}};
  const bool has_choice = !request.labs.empty();
  std::optional<fs::path> folder;
  std::string problem;
  try {
    folder = open_submission(submission, scratch);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  for (const Lab* lab : labs_of(request)) {
    try {
      if (!folder) throw std::runtime_error(problem);
      const LabFiles files = files_of(*folder, *lab);
      if (files.empty() && !has_choice) continue;
      if (files.empty()) throw std::runtime_error("not handed in");
      grades.labs.push_back(graded(workshop, *lab, files, scratch / lab->number, sandbox, request.seed));
    } catch (const std::exception& error) {
      grades.labs.push_back(failed_to_grade(*lab, error.what()));
    }
  }
  return grades;
}

}  // namespace

int grade(const Workshop& workshop, const GradeRequest& request) {
  if (request.submissions.empty()) throw std::invalid_argument("expected at least one submission");
  std::set<std::string> students;
  for (const fs::path& submission : request.submissions) {
    if (!students.insert(student_of(submission)).second) {
      throw std::invalid_argument("two submissions of '" + student_of(submission) +
                                  "': folders and archives are called after their students");
    }
  }
  std::optional<Sandbox> sandbox;
  if (!request.is_trusted) sandbox.emplace();
  std::string pattern = (fs::temp_directory_path() / "sightline-grade-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw FileError(pattern, 0, "a folder to work in", "none can be made");
  const fs::path scratch = pattern;
  std::vector<StudentGrades> all(request.submissions.size());
  std::atomic<std::size_t> next = 0;
  std::mutex output;
  const auto work = [&] {
    for (std::size_t i = next++; i < all.size(); i = next++) {
      const fs::path& submission = request.submissions[i];
      try {
        // A process of its own, so that whatever happens in it costs one grade only.
        const std::string answer = run_in_child(
            [&] {
              const auto grades =
                  grade_one(workshop, request, submission, scratch / std::to_string(i), sandbox ? &*sandbox : nullptr);
              return json{{"student", grades.student}, {"labs", grades.labs}}.dump(-1, ' ', false,
                                                                                   json::error_handler_t::replace);
            },
            {std::chrono::seconds(3600)});
        const json read = json::parse(answer);
        all[i] = {read.at("student").get<std::string>(), read.at("labs").get<std::vector<json>>()};
      } catch (const std::exception& error) {
        all[i] = {student_of(submission), {}};
        for (const Lab* lab : labs_of(request)) all[i].labs.push_back(failed_to_grade(*lab, error.what()));
      }
      const std::scoped_lock lock(output);
      std::cout << all[i].student << ": " << summary_of(all[i]) << std::endl;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < request.threads; ++i) workers.emplace_back(work);
  }
  fs::remove_all(scratch);
  write_grades(request.out, all, request.seed);
  return 0;
}

}  // namespace sightline::labs
