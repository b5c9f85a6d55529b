#include "sightline/io/progress.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sightline {
namespace {

using namespace std::chrono_literals;

/// What is said on a stderr that is no terminal.
template <class Work>
std::string said(Progress::Clock::duration patience, Work work) {
  testing::internal::CaptureStderr();
  {
    Progress progress(patience);
    work(progress);
  }
  return testing::internal::GetCapturedStderr();
}

TEST(Progress, SaysEachLongStepInOneLine) {
  const std::string text = said(1ms, [](Progress& progress) {
    for (const char* step : {"reading", "building"}) {
      progress.say(step, "first");
      std::this_thread::sleep_for(300ms);
      progress.say(step, "second");
      std::this_thread::sleep_for(50ms);
    }
  });
  EXPECT_EQ(text, "reading: first (0 s so far)\nbuilding: first (0 s so far)\n");
}

TEST(Progress, IsSilentAboutShortSteps) {
  const std::string text = said(1h, [](Progress& progress) {
    for (const char* step : {"reading", "building"}) progress.say(step);
    std::this_thread::sleep_for(20ms);
  });
  EXPECT_EQ(text, "");
}

TEST(Progress, IsSilentWhenTheStepIsOver) {
  const std::string text = said(200ms, [](Progress& progress) {
    progress.say("reading");
    progress.clear();
    std::this_thread::sleep_for(400ms);
  });
  EXPECT_EQ(text, "");
}

TEST(Progress, TellsTimeLeftAndMoreAtLongerIntervals) {
  const std::string text = said(1ms, [](Progress& progress) {
    for (int i = 0; i <= 18; ++i) {
      progress.say("rendering", "detail", 0.5 + i / 40.0);
      std::this_thread::sleep_for(100ms);
    }
  });
  EXPECT_EQ(text.rfind("rendering: 50%, detail (0 s so far)\n", 0), 0u) << text;
  EXPECT_NE(text.find(" s so far, "), std::string::npos) << text;
  EXPECT_NE(text.find(" s left)\n"), std::string::npos) << text;
  // Within two seconds: at once, and then each time that it took twice as long, looked at each half second.
  const auto lines = std::count(text.begin(), text.end(), '\n');
  EXPECT_GE(lines, 2);
  EXPECT_LE(lines, 4);
}

}  // namespace
}  // namespace sightline
