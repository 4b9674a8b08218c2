// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/OutputFile.h"

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

TEST(OutputFile, aFolderThatIsNotThereAndADirectoryAreRefused) {
  const TestFolder folder;
  EXPECT_FALSE(OutputFile::create(folder / "no/out.txt", false));
  EXPECT_FALSE(OutputFile::create(folder.path(), true));
}

}  // namespace
}  // namespace logplayer
