/// The tool over tables that are known, as a user runs it.

#include "tests/stability/command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/io/temporary_folder.h"
#include "tests/stability/json.h"
#include "tests/stability/names.h"
#include "tests/stability/page.h"
#include "tests/stability_tool/fake_table.h"

namespace sightline::stability {
namespace {

struct Outcome {
  int status = -1;
  std::string out, messages;
};

Outcome run_over(std::span<const HardCase> cases, std::vector<std::string> words) {
  words.insert(words.begin(), "sightline-stability");
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  std::ostringstream out, messages;
  const int status = run(cases, static_cast<int>(argv.size()), argv.data(), out, messages);
  return {status, out.str(), messages.str()};
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

Report report_of(std::span<const HardCase> cases) {
  Progress progress;
  return ask(select(cases, {}, {}), 1, progress);
}

TEST(Command, EndsWellWherePromisesAreKept) {
  const Outcome outcome = run_over(good_table(), {});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.messages, "");
  EXPECT_NE(outcome.out.find("is wrong nowhere: 3 cases"), std::string::npos);
  EXPECT_NE(outcome.out.find("WRONG 10/200"), std::string::npos) << "at fast";
}

TEST(Command, FailsWhereOneIsBroken) {
  EXPECT_EQ(run_over(bad_table(), {}).status, 1);
  EXPECT_EQ(run_over(bad_table(), {"--case", "box-wrong"}).status, 1);
  EXPECT_EQ(run_over(bad_table(), {"--case", "box-throws"}).status, 1);
  EXPECT_EQ(run_over(bad_table(), {"--group", "ball"}).status, 0);
  EXPECT_EQ(run_over(bad_table(), {"--case", "box-wrong", "--accel", "kd-tree"}).status, 0);
}

TEST(Command, PrintsTheMatrix) {
  const std::string out = run_over(bad_table(), {}).out;
  constexpr std::string_view expected = R"(case          fast          watertight  precise  exact  always  naive
ball
  ball-right  exact         exact       exact    exact  –       75%
  ball-fast   WRONG 10/200  bound       exact    exact  –       –
box
  box-tie     –             –           –        –      exact   –      policy
  box-wrong   –             WRONG 1/13  –        –      –       –      grid watertight: WRONG 1/5
)";
  EXPECT_EQ(out.substr(0, expected.size()), expected);
}

TEST(Command, PrintsOneColumnOfALevel) {
  const std::string out = run_over(good_table(), {"--level", "precise"}).out;
  EXPECT_EQ(out.find("watertight"), std::string::npos);
  EXPECT_EQ(out.find("box-tie"), std::string::npos);
  EXPECT_NE(out.find("ball-fast   exact"), std::string::npos);
}

TEST(Command, ExplainsACase) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.svg").string();
  const Outcome outcome = run_over(bad_table(), {"--explain", "box-wrong", "--out", file});
  EXPECT_EQ(outcome.status, 1);
  for (const char* text : {"box-wrong (box)", "0 * infinity", "brute force", "  grid      WRONG 1/5   5",
                           "t = 2 (kd-tree, bsp-tree at watertight)", "  WRONG     nothing (grid at watertight)",
                           "--explain box-wrong"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
  EXPECT_TRUE(contents(file).starts_with("<svg "));
}

TEST(Command, RefusesBeforeItAsks) {
  static int asked;
  asked = 0;
  HardCase counted = right_case();
  counted.run = [](Trial&) { ++asked; };
  const std::span<const HardCase> table(&counted, 1);
  EXPECT_THROW(run_over(table, {"--case", "x"}), std::invalid_argument);
  EXPECT_THROW(run_over(table, {"--level", "x"}), std::invalid_argument);
  EXPECT_THROW(run_over(table, {"--accel", "x"}), std::invalid_argument);
  EXPECT_THROW(run_over(table, {"--json", "/dev/null/x"}), std::runtime_error);
  EXPECT_THROW(run_over(table, {"--html=/dev/null/x"}), std::runtime_error);
  EXPECT_THROW(run_over(table, {"--explain", "ball-right", "--out", "/dev/null/x.svg"}), std::runtime_error);
  EXPECT_EQ(run_over(table, {"--list"}).status, 0);
  EXPECT_EQ(asked, 0);
}

TEST(Command, WritesJson) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.json").string();
  EXPECT_EQ(run_over(bad_table(), {"--quick", "--json", file}).status, 1);
  const auto json = nlohmann::json::parse(contents(file));
  EXPECT_EQ(json.at("share"), 0.1);
  EXPECT_EQ(json.at("keeps_promises"), false);
  ASSERT_EQ(json.at("cases").size(), 5u);
  const auto& wrong = json.at("cases").at(3);
  EXPECT_EQ(wrong.at("verdicts").at("watertight"), "wrong");
  EXPECT_EQ(wrong.at("verdicts").at("exact"), nullptr);
  EXPECT_EQ(wrong.at("answers").at(1).at("who"), "grid");
  EXPECT_EQ(wrong.at("answers").at(1).at("wrong"), 1);
  EXPECT_EQ(wrong.at("answers").at(1).at("first_wrong").at("got"), "nothing");
  EXPECT_EQ(json.at("cases").at(4).at("failed"), "out of rays");
}

TEST(Json, HasNoNumberThatIsNone) {
  Report report{1, {CaseReport{&good_table()[0], {{"a", Level::fast, {}}, {"b", Level::fast, {}}}, {}, {}, 0}}, 0};
  add(report.cases[0].answers[0].tally, Verdict::exact, 1, HUGE_VAL);
  add(report.cases[0].answers[1].tally, Verdict::exact, 1, std::nan(""));
  const auto json = nlohmann::json::parse(json_text(report, {}));
  EXPECT_EQ(json.at("cases").at(0).at("answers").at(0).at("worst_error"), "inf");
  EXPECT_EQ(json.at("cases").at(0).at("answers").at(1).at("worst_error"), "nan");
}

TEST(Page, EscapesTexts) {
  HardCase hostile = right_case();
  hostile.inputs = "</script><b onclick='x'>";
  const std::string page = page_of(report_of(std::span(&hostile, 1)), {});
  EXPECT_EQ(page.find("<b onclick"), std::string::npos);
  EXPECT_EQ(page.find("r = 1 & \"far\""), std::string::npos);
  EXPECT_NE(page.find("&lt;b onclick"), std::string::npos);
}

TEST(Page, AsksForNothingOutside) {
  const std::string page = page_of(report_of(bad_table()), {});
  for (const char* text : {"src=", "@import", "url(", "https:"}) EXPECT_EQ(page.find(text), std::string::npos) << text;
  for (std::size_t at = page.find("http:"); at != std::string::npos; at = page.find("http:", at + 1)) {
    EXPECT_EQ(page.substr(at, 26), "http://www.w3.org/2000/svg");
  }
}

TEST(Page, HasARowACase) {
  const std::string page = page_of(report_of(bad_table()), {});
  for (const HardCase& one : bad_table()) {
    EXPECT_NE(page.find("<tr class=row id=\"" + std::string(one.id) + "\""), std::string::npos) << one.id;
  }
  EXPECT_NE(page.find("WRONG<small>1/13</small>"), std::string::npos);
  EXPECT_NE(page.find("box-wrong, box-throws"), std::string::npos);
}

}  // namespace
}  // namespace sightline::stability
