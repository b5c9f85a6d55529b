#include "sightline/io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <sstream>
#include <thread>

#include "sightline/io/file_error.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(OutputFile, AppearsWhole) {
  const TemporaryFolder folder;
  write_text(folder.path() / "new" / "a.txt", "one\n");
  write_text(folder.path() / "new" / "a.txt", "two\n");
  EXPECT_EQ(contents(folder.path() / "new" / "a.txt"), "two\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "new"), {}), 1);
}

TEST(OutputFile, KeepsTheExtensionWhileTemporary) {
  const TemporaryFolder folder;
  const OutputFile output(folder.path() / "a.tar.png");
  EXPECT_EQ(output.temporary().extension(), ".png");
  EXPECT_EQ(output.temporary().parent_path(), folder.path());
  EXPECT_TRUE(std::filesystem::exists(output.temporary()));
}

TEST(OutputFile, LeavesNothingWhenNotCommitted) {
  const TemporaryFolder folder;
  folder.write("a.txt", "before");
  { const OutputFile output(folder.path() / "a.txt"); }
  EXPECT_EQ(folder.count(), 1);
  EXPECT_EQ(contents(folder.path() / "a.txt"), "before");
}

TEST(OutputFile, RefusesFoldersAndWhatIsBelowAFile) {
  const TemporaryFolder folder;
  folder.write("file", "x");
  EXPECT_THROW(write_text(folder.path(), "x"), FileError);
  EXPECT_THROW(write_text(folder.path() / "file" / "a.txt", "x"), FileError);
  EXPECT_THROW(write_text("", "x"), FileError);
  EXPECT_THROW(write_text("/proc/none.txt", "x"), FileError);
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, LeavesNoFolderWhenNotCommitted) {
  const TemporaryFolder folder;
  { const OutputFile output(folder.path() / "new" / "newer" / "a.txt"); }
  EXPECT_EQ(folder.count(), 0);
  EXPECT_THROW(write_text(folder.path() / "new" / std::string(NAME_MAX + 1, 'x'), "x"), FileError);
  EXPECT_EQ(folder.count(), 0);
  std::filesystem::create_directory(folder.path() / "old");
  { const OutputFile output(folder.path() / "old" / "new" / "a.txt"); }
  EXPECT_EQ(folder.count(), 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "old"));
  {
    const OutputFile output(folder.path() / "new" / "a.txt");
    write_text(folder.path() / "new" / "b.txt", "b");
  }
  EXPECT_EQ(contents(folder.path() / "new" / "b.txt"), "b");
}

TEST(OutputFile, FollowsLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "far");
  const auto target = folder.write("far/target.dat", "before");
  std::filesystem::create_symlink("far/target.dat", folder.path() / "first.txt");
  std::filesystem::create_symlink("first.txt", folder.path() / "second.txt");
  {
    const OutputFile output(folder.path() / "second.txt");
    EXPECT_EQ(output.temporary().parent_path(), folder.path() / "far");
    EXPECT_EQ(output.temporary().extension(), ".txt");
  }
  write_text(folder.path() / "second.txt", "after");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "first.txt"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "second.txt"));
  EXPECT_EQ(contents(target), "after");

  std::filesystem::create_symlink("new/target.txt", folder.path() / "dangling");
  write_text(folder.path() / "dangling", "there");
  EXPECT_EQ(contents(folder.path() / "new" / "target.txt"), "there");
  std::filesystem::create_symlink("circle", folder.path() / "circle");
  EXPECT_THROW(write_text(folder.path() / "circle", "x"), FileError);
}

TEST(OutputFile, WritesToDevicesAndPipesAsTheyAre) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/null", folder.path() / "nothing");
  for (const std::filesystem::path& path : {std::filesystem::path("/dev/null"), folder.path() / "nothing"}) {
    { EXPECT_EQ(OutputFile(path).temporary(), "/dev/null"); }
    write_text(path, "x");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  }
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "nothing"));
  EXPECT_THROW(write_text("/dev/full", "x"), FileError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));

  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  { const OutputFile probe(pipe); }  // does not wait for a reader
  std::string heard;
  std::thread reader([&] { heard = contents(pipe); });
  write_text(pipe, "said");
  reader.join();
  EXPECT_EQ(heard, "said");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(folder.count(), 2);
}

TEST(OutputFile, AppendsToAnOpenFileNamedByItsDescriptor) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", "before ");
  const int file = open(path.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(file, 0);
  write_text("/dev/fd/" + std::to_string(file), "named ");
  EXPECT_EQ(write(file, "after", 5), 5);
  close(file);
  EXPECT_EQ(contents(path), "before named after");
}

TEST(OutputFile, KeepsTheModeOfWhatItReplaces) {
  const TemporaryFolder folder;
  for (const mode_t mode : {0600, 0444, 0666, 0750}) {
    const auto path = folder.write(std::to_string(mode), "before");
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    write_text(path, "after");
    struct stat status {};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, mode);
    EXPECT_EQ(contents(path), "after");
  }
}

TEST(OutputFile, TakesTheLongestNames) {
  const TemporaryFolder folder;
  std::string umlauts;
  while (umlauts.size() + 6 <= NAME_MAX) umlauts += "\u00e4";
  for (const std::string& name : {std::string(NAME_MAX - 4, 'x') + ".txt", std::string(NAME_MAX, 'x'), umlauts + ".png",
                                  "x." + std::string(NAME_MAX - 2, 'y')}) {
    write_text(folder.path() / name, name);
    EXPECT_EQ(contents(folder.path() / name), name);
  }
  EXPECT_EQ(folder.count(), 4);
}

/// How a child ends that signals itself while it writes below `folder`. `wish` is made known before the first file.
int status_of_signalled(const std::filesystem::path& folder, int signal_number, sighandler_t wish) {
  const pid_t child = fork();
  if (child == 0) {
    signal(signal_number, wish);
    const OutputFile plain(folder / "a.txt");
    const OutputFile deep(folder / "new" / "newer" / "b.txt");
    raise(signal_number);
    _exit(std::filesystem::exists(deep.temporary()) ? 0 : 1);
  }
  int status = -1;
  if (child > 0) waitpid(child, &status, 0);
  return status;
}

TEST(OutputFile, LeavesNothingWhenASignalEndsTheProgram) {
  for (const int signal_number : {SIGHUP, SIGINT, SIGTERM, SIGPIPE}) {
    const TemporaryFolder folder;
    const auto kept = folder.write("a.txt", "before");
    const int status = status_of_signalled(folder.path(), signal_number, SIG_DFL);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal_number);
    EXPECT_EQ(folder.count(), 1);
    EXPECT_EQ(contents(kept), "before");
  }
}

TEST(OutputFile, LeavesSignalsAloneThatTheProgramHandles) {
  const TemporaryFolder folder;
  for (const sighandler_t wish : {sighandler_t{SIG_IGN}, sighandler_t{[](int) {}}}) {
    const int status = status_of_signalled(folder.path(), SIGHUP, wish);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
}

TEST(OutputFile, OutlivesTheSignalOfAFork) {
  const TemporaryFolder folder;
  const OutputFile output(folder.path() / "new" / "a.txt");
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGTERM, SIG_DFL);
    { const OutputFile own(folder.path() / "b.txt"); }
    raise(SIGTERM);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(std::filesystem::exists(output.temporary()));
}

TEST(FileError, IsOneLineOfPlainText) {
  EXPECT_STREQ(FileError("a.ply", 3, "x", "y").what(), "a.ply:3: expected x, found y");
  EXPECT_STREQ(FileError("a.ply", 0, "x", "y\n\x1b[31m\xff").what(), "a.ply: expected x, found y??[31m?");
}

}  // namespace
}  // namespace sightline
