#include "sightline/io/progress.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace sightline
