// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/OutputFile.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

void fill(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(OutputFile, hasItsNameOnlyWhenItIsComplete) {
  const TestFolder folder;
  auto output = OutputFile::create(folder / "out.txt", false);
  ASSERT_TRUE(output);
  fill(output->temporary(), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "out.txt"));
  ASSERT_TRUE(output->commit());
  EXPECT_EQ(textOf(folder / "out.txt"), "new");
  EXPECT_EQ(folder.contents(), "out.txt");
}

TEST(OutputFile, leavesNothingUnlessItIsCommitted) {
  const TestFolder folder;
  {
    auto output = OutputFile::create(folder / "out.txt", false);
    ASSERT_TRUE(output);
    fill(output->temporary(), "half");
  }
  EXPECT_EQ(folder.contents(), "");
}

TEST(OutputFile, overwritesOnlyIfItMay) {
  const TestFolder folder;
  fill(folder / "out.txt", "old");
  const auto refused = OutputFile::create(folder / "out.txt", false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "file.exists");
  auto output = OutputFile::create(folder / "out.txt", true);
  ASSERT_TRUE(output);
  fill(output->temporary(), "new");
  EXPECT_EQ(textOf(folder / "out.txt"), "old");
  ASSERT_TRUE(output->commit());
  EXPECT_EQ(textOf(folder / "out.txt"), "new");
}

TEST(OutputFile, aFileThatGotTheNameMeanwhileIsKept) {
  const TestFolder folder;
  auto output = OutputFile::create(folder / "out.txt", false);
  ASSERT_TRUE(output);
  fill(output->temporary(), "new");
  fill(folder / "out.txt", "somebody else's");
  const auto named = output->commit();
  ASSERT_FALSE(named);
  EXPECT_EQ(named.error().id, "file.exists");
  EXPECT_EQ(textOf(folder / "out.txt"), "somebody else's");
}

TEST(OutputFile, aSymbolicLinkIsKeptAndItsTargetOverwritten) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "other");
  fill(folder / "other/target.txt", "old");
  std::filesystem::create_symlink("other/target.txt", folder / "out.txt");
  std::filesystem::create_symlink("out.txt", folder / "again.txt");
  EXPECT_FALSE(OutputFile::create(folder / "again.txt", false));
  auto output = OutputFile::create(folder / "again.txt", true);
  ASSERT_TRUE(output);
  fill(output->temporary(), "new");
  ASSERT_TRUE(output->commit());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "out.txt"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "again.txt"));
  EXPECT_EQ(textOf(folder / "other/target.txt"), "new");
}

TEST(OutputFile, aSymbolicLinkToNothingGetsItsTarget) {
  const TestFolder folder;
  std::filesystem::create_symlink("target.txt", folder / "out.txt");
  auto output = OutputFile::create(folder / "out.txt", true);
  ASSERT_TRUE(output);
  fill(output->temporary(), "new");
  ASSERT_TRUE(output->commit());
  EXPECT_EQ(textOf(folder / "target.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "out.txt"));
}

TEST(OutputFile, errorsOfItsWriterNameTheFileThatPeopleKnow) {
  const TestFolder folder;
  const auto output = OutputFile::create(folder / "out.txt", false);
  ASSERT_TRUE(output);
  const robotlink::Error error{
      "mcap.write",
      "cannot write the log file at byte 7: no space; what was written before can be read",
      {},
      {output->temporary().string(), 0, 0}};
  EXPECT_EQ(
      output->named(error).describe(),
      (folder / "out.txt").string() + ": cannot write the log file at byte 7: no space; it was deleted");
  const robotlink::Error other{"x", "y", {}, {"in.txt", 0, 0}};
  EXPECT_EQ(output->named(other), other);
}

TEST(OutputFile, aFolderThatIsNotThereAndADirectoryAreRefused) {
  const TestFolder folder;
  EXPECT_FALSE(OutputFile::create(folder / "no/out.txt", false));
  EXPECT_FALSE(OutputFile::create(folder.path(), true));
}

}  // namespace
}  // namespace logplayer
