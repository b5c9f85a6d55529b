/// Every hard case, by its id: right at every level that promises it, and hard for code that does not know better.

#include "tests/hard_cases/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sightline::hard {
namespace {

class HardCases : public testing::TestWithParam<HardCase> {};

std::string text_of(const Trial::Row& row) {
  std::string text = row.who;
  if (row.level) text += " at " + std::string(info_of(*row.level).name);
  text += ": " + std::to_string(row.tally.count(Verdict::wrong)) + " wrong of " + std::to_string(row.tally.asked());
  if (const auto& wrong = row.tally.first_wrong()) {
    text += "\n  inputs   " + wrong->inputs + "\n  expected " + wrong->expected + "\n  got      " + wrong->got;
  }
  return text;
}

TEST_P(HardCases, AreRight) {
  Trial trial(0.1);
  GetParam().run(trial);
  ASSERT_FALSE(trial.rows().empty());
  for (const Trial::Row& row : trial.rows()) {
    ASSERT_GT(row.tally.asked(), 0u) << row.who;
    if (row.level == Level::fast) continue;  // promises nothing of these
    EXPECT_EQ(row.tally.count(Verdict::wrong), 0u) << text_of(row);
    if (row.level == Level::exact) {
      EXPECT_EQ(row.tally.verdict(), Verdict::exact) << text_of(row);
    }
  }
  for (const Trial::Row& row : trial.naive_rows()) EXPECT_GT(row.tally.count(Verdict::wrong), 0u) << text_of(row);
}
INSTANTIATE_TEST_SUITE_P(Catalogue, HardCases, testing::ValuesIn(hard_cases().begin(), hard_cases().end()),
                         [](const auto& one) {
                           std::string name(one.param.id);
                           std::ranges::replace_if(
                               name, [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

TEST(HardCasesTable, IsWhole) {
  EXPECT_EQ(hard_cases().size(), 128u);
  std::set<std::string_view> ids;
  for (const HardCase& one : hard_cases()) {
    EXPECT_TRUE(ids.insert(one.id).second) << one.id << " is there twice";
    for (const std::string_view text : {one.group, one.inputs, one.expected, one.why})
      EXPECT_FALSE(text.empty()) << one.id;
    EXPECT_NE(one.run, nullptr) << one.id;
    ASSERT_NE(one.draw, nullptr) << one.id;
    EXPECT_FALSE(one.draw().parts.empty()) << one.id;
  }
}

}  // namespace
}  // namespace sightline::hard
