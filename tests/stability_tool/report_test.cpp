#include "tests/stability/report.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "tests/stability/names.h"
#include "tests/stability/text.h"
#include "tests/stability_tool/fake_table.h"

namespace sightline::stability {
namespace {

Report report_of(std::span<const HardCase> cases, double share = 1) {
  Progress progress;
  return ask(select(cases, {}, {}), share, progress);
}

constexpr std::size_t fast = column_of(Level::fast), watertight = column_of(Level::watertight);

TEST(Report, AsksAllInTheirOrder) {
  const Report report = report_of(bad_table());
  ASSERT_EQ(report.cases.size(), bad_table().size());
  for (std::size_t i = 0; i < report.cases.size(); ++i) EXPECT_EQ(report.cases[i].hard_case, &bad_table()[i]);
}

TEST(Report, AsksAShare) {
  EXPECT_EQ(cell_of(report_of(good_table()).cases[1], fast)->asked, 200u);
  EXPECT_EQ(cell_of(report_of(good_table(), 0.1).cases[1], fast)->asked, 20u);
}

TEST(Report, TellsTheWorstOfAColumn) {
  const Report report = report_of(bad_table());
  const auto verdict = [&](std::size_t one, std::size_t column) { return cell_of(report.cases[one], column)->verdict; };
  EXPECT_EQ(verdict(0, fast), Verdict::exact);
  EXPECT_EQ(verdict(1, fast), Verdict::wrong);
  EXPECT_EQ(verdict(1, watertight), Verdict::within_bound);
  EXPECT_EQ(verdict(2, always), Verdict::exact);
  EXPECT_EQ(verdict(3, watertight), Verdict::wrong);
  EXPECT_EQ(cell_of(report.cases[3], watertight)->wrong, 1u);
  EXPECT_EQ(cell_of(report.cases[3], watertight)->asked, 13u);
  EXPECT_FALSE(cell_of(report.cases[2], fast));
  EXPECT_FALSE(cell_of(report.cases[4], always));
}

TEST(Report, PromisesNothingAtFast) {
  EXPECT_TRUE(keeps_promises(report_of(good_table())));
  const Report report = report_of(bad_table());
  EXPECT_TRUE(keeps_promises(report.cases[1]));
  EXPECT_FALSE(keeps_promises(report.cases[3]));
  EXPECT_FALSE(keeps_promises(report.cases[4]));
  EXPECT_FALSE(keeps_promises(report));
}

TEST(Report, PromisesEverywhereElse) {
  for (const std::optional<Level> level : {std::optional(Level::watertight), std::optional(Level::precise),
                                           std::optional(Level::exact), std::optional<Level>()}) {
    CaseReport report{&good_table()[0], {}, {}, {}, 0};
    report.answers.push_back({"one", level, {}});
    add(report.answers[0].tally, Verdict::within_bound, 3);
    EXPECT_TRUE(keeps_promises(report));
    add(report.answers[0].tally, Verdict::wrong, 1);
    EXPECT_FALSE(keeps_promises(report));
  }
}

TEST(Report, TellsOfNaiveCode) {
  const Report report = report_of(good_table());
  EXPECT_EQ(naive_rate(report.cases[0]), 0.75);
  EXPECT_EQ(naive_rate(report.cases[1]), std::nullopt);
  EXPECT_EQ(naive_text(report.cases[0]), "75%");
  EXPECT_EQ(naive_text(report.cases[1]), "–");
}

TEST(Report, NamesWhoIsWorseThanMost) {
  const Report report = report_of(bad_table());
  EXPECT_EQ(remarks_text(report.cases[0]), "");
  EXPECT_EQ(remarks_text(report.cases[1]), "");
  EXPECT_EQ(remarks_text(report.cases[2]), "policy");
  EXPECT_EQ(remarks_text(report.cases[3]), "grid watertight: WRONG 1/5");
  EXPECT_EQ(remarks_text(report.cases[4]), "FAILED: out of rays");
  CaseReport pair{&good_table()[2], {{"a", Level::fast, {}}, {"b", Level::fast, {}}}, {}, {}, 0};
  add(pair.answers[0].tally, Verdict::within_bound, 1);
  add(pair.answers[1].tally, Verdict::exact, 1);
  EXPECT_EQ(remarks_text(pair), "policy; a fast: bound");
  pair.answers.push_back({"c", Level::fast, {}});
  add(pair.answers[2].tally, Verdict::within_bound, 1);
  EXPECT_EQ(remarks_text(pair), "policy") << "most are within bounds, and one is better";
}

TEST(Report, HasALineForEach) {
  const Report report = report_of(bad_table());
  const auto lines = lines_of(report.cases[0].answers);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].who, "kd-tree");
  EXPECT_EQ(lines[1].at[fast]->who, "grid");
  EXPECT_EQ(lines[1].at[fast]->level, Level::fast);
  EXPECT_EQ(lines[1].at[always], nullptr);
}

TEST(Report, PutsTheSameQuestionsTogether) {
  const Report report = report_of(bad_table());
  const auto questions = questions_of(report.cases[3].answers);
  ASSERT_EQ(questions.size(), 1u);
  ASSERT_EQ(questions[0].replies.size(), 2u);
  EXPECT_EQ(questions[0].replies[0].got, "t = 2");
  EXPECT_FALSE(questions[0].replies[0].is_wrong);
  EXPECT_EQ(who_text(questions[0].replies[0].by), "kd-tree, bsp-tree at watertight");
  EXPECT_EQ(questions[0].replies[1].got, "nothing");
  EXPECT_TRUE(questions[0].replies[1].is_wrong);
  EXPECT_EQ(who_text(questions[0].replies[1].by), "grid at watertight");
  const auto at_all = questions_of(report.cases[0].answers);
  EXPECT_EQ(who_text(at_all[0].replies[0].by), "kd-tree, grid at fast, watertight, precise, exact");
  EXPECT_EQ(who_text(questions_of(report.cases[2].answers)[0].replies[0].by), "all");
  std::vector<Answers> others{{"a", Level::fast, {}}, {"b", Level::fast, {}}};
  others[0].tally.decide(true, [] { return hard::Example{"x", "1", "1"}; });
  others[1].tally.decide(true, [] { return hard::Example{"y", "1", "1"}; });
  EXPECT_EQ(questions_of(others).size(), 2u);
}

TEST(Tally, KeepsAnErrorThatIsNoNumber) {
  hard::Tally tally;
  add(tally, Verdict::exact, 1, 2);
  add(tally, Verdict::exact, 1, std::numeric_limits<double>::quiet_NaN());
  add(tally, Verdict::exact, 1, 3);
  EXPECT_TRUE(std::isnan(tally.worst_error()));
}

TEST(Report, IsLimited) {
  Report report = report_of(bad_table());
  limit(report, {Level::fast, {}});
  ASSERT_EQ(report.cases.size(), 3u);  // the one that failed stays
  EXPECT_FALSE(cell_of(report.cases[0], watertight));
  report = report_of(bad_table());
  limit(report, {{}, {"grid"}});
  ASSERT_EQ(report.cases.size(), 3u);
  EXPECT_EQ(cell_of(report.cases[1], watertight)->asked, 5u);
  limit(report, {});
  EXPECT_EQ(report.cases.size(), 3u);
}

TEST(Report, IsSummed) {
  const Summary summary = summary_of(report_of(bad_table()));
  EXPECT_EQ(summary.cases, 5u);
  EXPECT_EQ(summary.policies, 1u);
  EXPECT_EQ(summary.failed, 1u);
  EXPECT_EQ(summary.at_default, 5u);
  EXPECT_EQ(summary.wrong_at_default, (std::vector<std::string_view>{"box-wrong", "box-throws"}));
  EXPECT_TRUE(summary.wrong_policies.empty());
  EXPECT_EQ(summary.columns[fast].cases, (std::array<std::size_t, 3>{1, 0, 1}));
  EXPECT_EQ(summary.columns[watertight].cases, (std::array<std::size_t, 3>{1, 1, 1}));
  EXPECT_EQ(summary.columns[watertight].not_applicable, 2u);
  EXPECT_EQ(summary.columns[always].cases, (std::array<std::size_t, 3>{1, 0, 0}));
  EXPECT_TRUE(summary_of(report_of(good_table())).wrong_at_default.empty());
}

TEST(Report, HoldsPoliciesApart) {
  HardCase broken = policy_case();
  broken.run = [](Trial& trial) { add(trial.of("all"), Verdict::wrong, 1); };
  const Summary summary = summary_of(report_of(std::span(&broken, 1)));
  EXPECT_TRUE(summary.wrong_at_default.empty());
  EXPECT_EQ(summary.wrong_policies, (std::vector<std::string_view>{"box-tie"}));
  EXPECT_FALSE(keeps_promises(report_of(std::span(&broken, 1))));
}

TEST(Report, RefusesACaseThatAsksNothing) {
  HardCase idle = right_case();
  idle.run = [](Trial&) {};
  const Report report = report_of(std::span(&idle, 1));
  EXPECT_EQ(report.cases[0].error, "asks nothing");
  EXPECT_FALSE(keeps_promises(report));
}

TEST(Report, RestoresTheRounding) {
  HardCase careless = right_case();
  careless.run = [](Trial& trial) {
    std::fesetround(FE_UPWARD);
    add(trial.of("one"), Verdict::exact, 1);
  };
  report_of(std::span(&careless, 1));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

// ---- Names

std::vector<std::string_view> ids(std::vector<std::string> patterns, std::vector<std::string> groups = {}) {
  std::vector<std::string_view> found;
  for (const HardCase* one : select(bad_table(), split_at_commas(patterns), split_at_commas(groups))) {
    found.push_back(one->id);
  }
  return found;
}

TEST(Names, SelectByIdPatternAndGroup) {
  using Ids = std::vector<std::string_view>;
  EXPECT_EQ(ids({}).size(), 5u);
  EXPECT_EQ(ids({"box-tie,ball-fast"}), (Ids{"ball-fast", "box-tie"}));
  EXPECT_EQ(ids({"ball-*", "box-t*"}), (Ids{"ball-right", "ball-fast", "box-tie", "box-throws"}));
  EXPECT_EQ(ids({"*-[wr]*"}), (Ids{"ball-right", "box-wrong"}));
  EXPECT_EQ(ids({}, {"box"}).size(), 3u);
  EXPECT_EQ(ids({"*-right"}, {"ball,box"}), (Ids{"ball-right"}));
  EXPECT_TRUE(ids({"ball-fast"}, {"box"}).empty());
}

std::string refusal(std::vector<std::string> patterns, std::vector<std::string> groups = {}) {
  try {
    ids(std::move(patterns), std::move(groups));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Names, ThatAreUnknownNameNearOnes) {
  EXPECT_EQ(refusal({"ball-fats"}),
            "unknown case 'ball-fats'; near are ball-fast, ball-right, box-tie (--list names all)");
  EXPECT_EQ(refusal({"box"}), "unknown case 'box'; near are box-tie, box-wrong, box-throws (--list names all)");
  EXPECT_NE(refusal({"x*"}), "none");
  EXPECT_NE(refusal({""}), "none");
  EXPECT_EQ(refusal({}, {"bal"}), "unknown group 'bal'; near are ball, box (--list names all)");
  EXPECT_THROW(level_named("Fast"), std::invalid_argument);
  EXPECT_EQ(level_named("precise"), Level::precise);
  EXPECT_THROW(check_structures(std::vector<std::string>{"kd-tree", "tree"}), std::invalid_argument);
  EXPECT_NO_THROW(check_structures(std::vector<std::string>{"kd-tree"}));
}

}  // namespace
}  // namespace sightline::stability
