/// Every family of questions, from easy to hard: right at every difficulty at every level that promises it.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

constexpr std::uint64_t count = 8;

class Families : public testing::TestWithParam<Family> {};

[[maybe_unused]] void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

std::string text_of(const Trial::Row& row, int k) {
  std::string text = row.who + (row.level ? " at " + std::string(info_of(*row.level).name) : "") +
                     ", k = " + std::to_string(k) + ": " + std::to_string(row.tally.count(Verdict::wrong)) +
                     " wrong of " + std::to_string(row.tally.asked());
  if (const auto& wrong = row.tally.first_wrong()) {
    text += "\n  inputs   " + wrong->inputs + "\n  expected " + wrong->expected + "\n  got      " + wrong->got;
  }
  return text;
}

TEST_P(Families, AreRightAtEveryDifficulty) {
  const Family& family = GetParam();
  for (int k = family.easiest; k <= family.hardest; ++k) {
    Trial trial;
    family.ask(k, count, 1 + static_cast<std::uint64_t>(k), trial);
    ASSERT_FALSE(trial.rows().empty());
    ASSERT_FALSE(trial.naive_rows().empty());
    for (const Trial::Row& row : trial.rows()) {
      ASSERT_GT(row.tally.asked(), 0u) << row.who;
      if (row.level == Level::fast) continue;  // promises nothing of these
      EXPECT_EQ(row.tally.count(Verdict::wrong), 0u) << text_of(row, k);
      if (row.level == Level::exact) {
        EXPECT_EQ(row.tally.verdict(), Verdict::exact) << text_of(row, k);
      }
    }
    if (k < family.hardest) continue;
    for (const Trial::Row& row : trial.naive_rows()) EXPECT_GT(row.tally.count(Verdict::wrong), 0u) << text_of(row, k);
  }
}
INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(families().begin(), families().end()), [](const auto& one) {
  std::string name(one.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(FamiliesTable, IsWhole) {
  EXPECT_EQ(families().size(), 16u);
  std::set<std::string_view> names;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name << " is there twice";
    EXPECT_EQ(family_named(family.name), &family);
    EXPECT_LT(family.easiest, family.hardest) << family.name;
    for (const std::string_view text : {family.help, family.difficulty, family.unit}) {
      EXPECT_FALSE(text.empty()) << family.name;
    }
  }
  EXPECT_EQ(family_named("no-family"), nullptr);
}

}  // namespace
}  // namespace sightline::hard
