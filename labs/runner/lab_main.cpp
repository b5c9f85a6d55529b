/// sightline-lab: the course's labs, for students and teachers.

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>
#include <random>
#include <thread>

#include "labs/runner/commands.h"
#include "labs/runner/grade.h"
#include "labs/runner/handout.h"
#include "labs/runner/prove.h"
#include "labs/runner/watch.h"
#include "viz/run_tool.h"

namespace sightline::labs {
namespace {

constexpr const char* about =
    R"(Labs: learn how ray tracing divides space by making each part work. You write one part at a time; checks ask it
questions, and show the smallest one that it answers wrongly, in words and as a picture.

A first hour
  ./sightline lab                 the labs, and where you stand
  ./sightline lab start 00        copies what you are to complete into labs/mine/00-first-picture
  ./sightline lab check 00        what holds already, and what does not
  ./sightline lab hint 00         a push in the right direction; ask again for a stronger one
  ./sightline lab view 00         the picture that appears when it works

Exit status: 0 everything passes, 1 something does not, 2 wrong usage.)";

int run_tool_of(int argc, char** argv) {
  CLI::App app(about, "sightline-lab");
  app.require_subcommand(0, 1);
  Request request;
  std::string mine;
  app.add_option("--mine", mine, "Your folder; default labs/mine")->option_text("DIR");
  const auto add = [&](const char* name, const char* help, bool has_lab) {
    CLI::App* command = app.add_subcommand(name, help);
    command->fallthrough();
    if (has_lab) command->add_option("LAB", request.lab, "A number or a name, such as 10 or kd-tree")->required();
    return command;
  };
  const CLI::App* list = add("list", "The labs, and where you stand", false);
  CLI::App* start = add("start", "Copy what you are to complete into your folder", true);
  start->add_flag("--again", request.replaces, "Begin anew; what you have written is kept beside it as FILE.before");
  CLI::App* check = add("check", "Compile what you have written, and ask it", true);
  CLI::App* watch = add("watch", "Check whenever you save; keys: n next, h hint, l list, c check, q quit", true);
  CLI::App* hint = add("hint", "A hint for the first check that fails; ask again for a stronger one", true);
  CLI::App* view = add("view", "The picture that appears when it works", true);
  CLI::App* bench =
      add("bench", "Your structure beside ours: hits verified, then building, memory, rays a second", true);
  CLI::App* own = add("mine", "Structures that you have put into labs/mine: the laws, the benchmark, a picture", false);
  own->add_option("NAME", request.lab, "The file's name without .h; default all");
  view->add_option("WORDS", request.words,
                   "Of a structure: walk, partitions, compare or build, and their options after --");
  bench->add_option("WORDS", request.words, "For sightline-bench, after --; default --scene teapot --quick");
  CLI::App* replay = add("replay", "Ask one case again, and draw it", true);
  replay->add_option("--case", request.at, "As a failure prints it")->required()->option_text("CHECK:NUMBERS");
  check->add_option("--only", request.check, "One check alone")->option_text("CHECK");
  check->add_option("--json", request.json, "The report as a file too")->option_text("FILE");
  for (CLI::App* command : {check, hint}) {
    command->add_option("--seed", request.seed, "Of what is drawn by chance; default 1")->option_text("N");
  }
  bool is_plain = false;
  for (CLI::App* command : {check, replay}) command->add_flag("--no-pictures", is_plain, "Words are enough");
  CLI::App* submit = add("submit", "Pack what you hand in: labs/mine/submissions/NN-name.tar.gz", true);
  CLI::App* grading = add("grade", "For teachers: grade submissions, each where it can harm nothing", false);
  GradeRequest grades;
  std::vector<std::string> submissions;
  std::string grades_folder = "grades";
  std::optional<std::uint64_t> grade_seed;
  grades.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  grading->add_option("DIR", submissions, "Folders or archives, a student each")->required();
  grading->add_option("--lab", grades.labs, "Only these; default all that are handed in")
      ->delimiter(',')
      ->option_text("NN,...");
  grading->add_option("--out", grades_folder, "Where grades go; default grades")->option_text("DIR");
  grading->add_option("--seed", grade_seed, "Of the cases; default one that nobody knows, and that is told")
      ->option_text("N");
  grading->add_option("--threads", grades.threads, "Submissions at a time; default all processors")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  grading->add_flag("--trusted", grades.is_trusted, "Without a sandbox: only for programs that you would run yourself");
  CLI::App* handout = add("handout", "For teachers: the repository as students get it, without solutions", false);
  std::string handout_folder;
  handout->add_option("DIR", handout_folder, "A new folder")->required();
  CLI::App* prove = add("prove", "For who writes labs: try starters, solutions and mutants", false);
  std::vector<std::string> proven;
  bool is_quick = false;
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  prove->add_option("LAB", proven, "Which; default all");
  prove->add_flag("--solutions", is_quick, "Starters and solutions only");
  CLI::Option* many = prove->add_option("--threads", threads, "At a time; default all");
  many->check(CLI::Range(1, 1024))->option_text("N");
  if (const auto status = parse(app, argc, argv)) return *status;
  request.has_pictures = !is_plain;
  const Workshop workshop(mine);
  if (start->parsed()) return start_lab(workshop, request);
  if (check->parsed()) return check_lab(workshop, request);
  if (watch->parsed()) return watch_lab(workshop, request);
  if (handout->parsed()) return write_handout(workshop, handout_folder);
  if (hint->parsed()) return hint_lab(workshop, request);
  if (view->parsed()) return view_lab(workshop, request);
  if (bench->parsed()) return bench_lab(workshop, request);
  if (own->parsed()) return try_mine(workshop, request);
  if (submit->parsed()) return submit_lab(workshop, request);
  if (grading->parsed()) {
    grades.submissions.assign(submissions.begin(), submissions.end());
    grades.out = grades_folder;
    grades.seed = grade_seed ? *grade_seed : std::random_device()();
    std::cout << "seed " << grades.seed << '\n';
    return grade(workshop, grades);
  }
  if (replay->parsed()) return replay_case(workshop, request);
  if (prove->parsed()) return prove_labs(workshop, proven, !is_quick, threads);
  if (list->parsed() || app.get_subcommands().empty()) return list_labs(workshop);
  return wrong_usage;
}

}  // namespace
}  // namespace sightline::labs

int main(int argc, char** argv) {
  return sightline::run_tool("sightline-lab", [&] { return sightline::labs::run_tool_of(argc, argv); });
}
