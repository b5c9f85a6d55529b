#include "sightline/io/interruption.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sightline/io/output_file.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

TEST(Interruption, FirstSignalIsAWishAndTheNextEndsTheProgram) {
  for (const int number : {SIGINT, SIGTERM}) {
    for (const int next : {SIGINT, SIGTERM}) {
      const TemporaryFolder folder;
      const pid_t child = fork();
      if (child == 0) {
        const Interruption interruption;
        const OutputFile file(folder.path() / "a.txt");
        if (Interruption::is_wished()) _exit(1);
        raise(number);
        if (!Interruption::is_wished() || Interruption::signal() != number) _exit(2);
        if (!std::filesystem::exists(file.temporary())) _exit(3);
        raise(next);  // at once: the same wish
        usleep(250'000);
        if (!std::filesystem::exists(file.temporary())) _exit(4);
        raise(next);
        _exit(5);
      }
      int status = 0;
      ASSERT_EQ(waitpid(child, &status, 0), child);
      ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
      EXPECT_EQ(WTERMSIG(status), next);
      EXPECT_EQ(folder.count(), 0);
    }
  }
}

TEST(Interruption, LeavesWhatIsIgnoredIgnored) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGINT, SIG_IGN);
    const Interruption interruption;
    raise(SIGINT);
    _exit(Interruption::is_wished() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace sightline
