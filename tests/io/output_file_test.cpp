#include "sightline/io/output_file.h"

#include <gtest/gtest.h>

#include <sstream>

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

TEST(FileError, IsOneLineOfPlainText) {
  EXPECT_STREQ(FileError("a.ply", 3, "x", "y").what(), "a.ply:3: expected x, found y");
  EXPECT_STREQ(FileError("a.ply", 0, "x", "y\n\x1b[31m\xff").what(), "a.ply: expected x, found y??[31m?");
}

}  // namespace
}  // namespace sightline
