#include "tests/stability/text.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/stability_tool/fake_table.h"

namespace sightline::stability {
namespace {

TEST(Text, EscapesMarkup) {
  EXPECT_EQ(escaped("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(escaped("√3\t\n"), "√3\t\n");
  EXPECT_EQ(escaped(std::string("a\0b\x1b\x7f", 5)), "a?b??");
  EXPECT_EQ(escaped("&lt;"), "&amp;lt;");
}

TEST(Text, CountsCodePoints) {
  EXPECT_EQ(width_of(""), 0u);
  EXPECT_EQ(width_of("–√3²"), 4u);
}

TEST(Text, WrapsAtBlanks) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("", 5), Lines{});
  EXPECT_EQ(wrapped("one two three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("  one\n two ", 80), (Lines{"one two"}));
  EXPECT_EQ(wrapped("a-very-long-word b", 5), (Lines{"a-very-long-word", "b"}));
  EXPECT_EQ(wrapped("√√√ √√√", 7), (Lines{"√√√ √√√"}));
}

TEST(Text, NeverRoundsAFailureAway) {
  EXPECT_EQ(percent_text(0), "0%");
  EXPECT_EQ(percent_text(1), "100%");
  EXPECT_EQ(percent_text(0.9999), "99%");
  EXPECT_EQ(percent_text(0.084), "8.4%");
  EXPECT_EQ(percent_text(0.33333), "33%");
  EXPECT_EQ(percent_text(0.00001), "0.001%");
}

TEST(Text, TellsOfCells) {
  EXPECT_EQ(cell_text(std::nullopt), "–");
  EXPECT_EQ(cell_text(Cell{Verdict::exact, 0, 7}), "exact");
  EXPECT_EQ(cell_text(Cell{Verdict::within_bound, 0, 7}), "bound");
  EXPECT_EQ(cell_text(Cell{Verdict::wrong, 12, 20000}), "WRONG 12/20000");
}

TEST(Text, TellsOfErrors) {
  EXPECT_EQ(error_text(0), "0");
  EXPECT_EQ(error_text(0x1p-53), "1.1e-16");
  EXPECT_EQ(error_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(error_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Text, TellsOfOneAnswerer) {
  Answers one{"kd-tree", Level::fast, {}};
  add(one.tally, Verdict::exact, 2);
  EXPECT_EQ(answers_text(one), "exact");
  add(one.tally, Verdict::within_bound, 1, 0x1p-53);
  EXPECT_EQ(answers_text(one), "bound 1.1e-16");
  add(one.tally, Verdict::wrong, 1, 7);
  EXPECT_EQ(answers_text(one), "WRONG 1/4");
}

TEST(Text, TellsOfTheDefault) {
  Summary summary;
  EXPECT_EQ(default_text(summary), "The default, watertight, is asked nothing.");
  summary.at_default = 1;
  EXPECT_EQ(default_text(summary), "The default, watertight, is wrong nowhere: 1 case.");
  summary.at_default = 9;
  summary.wrong_policies = {"p"};
  EXPECT_EQ(default_text(summary), "The default, watertight, is wrong nowhere: 9 cases. It breaks 1 policy: p.");
  summary.wrong_policies.clear();
  summary.wrong_at_default = {"a", "b"};
  EXPECT_EQ(default_text(summary), "The default, watertight, is wrong in 2 cases of 9: a, b.");
}

TEST(Text, MakesPlurals) {
  EXPECT_EQ(plural(1, "policy"), "1 policy");
  EXPECT_EQ(plural(0, "policy"), "0 policies");
  EXPECT_EQ(plural(2, "case"), "2 cases");
}

}  // namespace
}  // namespace sightline::stability
