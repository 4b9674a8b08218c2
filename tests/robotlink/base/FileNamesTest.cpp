// SPDX-License-Identifier: GPL-3.0-or-later
// Suffixes of files, what links point to, and modules that are loaded when they are needed.
#include <gtest/gtest.h>

#include <fstream>

#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/LinkTarget.h"
#include "robotlink/base/OptionalModule.h"
#include "tests/TestFolder.h"

namespace robotlink {
namespace {

namespace fs = std::filesystem;

TEST(FileSuffixTest, capitalsAreNoOtherSuffix) {
  EXPECT_EQ(fileSuffix("HOUSE.MAP"), ".map");
  EXPECT_EQ(fileSuffix("/a.b/game.2002.Log"), ".log");
  EXPECT_EQ(fileSuffix("/a.b/game"), "");
  EXPECT_EQ(fileSuffix(".hidden"), "");
  EXPECT_EQ(fileSuffix("no\xC3\x84me.\xC3\x84"), ".\xC3\x84") << "only letters of ASCII change";
}

class LinkTargetTest : public testing::Test {
 protected:
  fs::path link(const fs::path& to, const char* name) const {
    const fs::path from = folder_.path() / name;
    fs::create_symlink(to, from);
    return from;
  }

  const TestFolder folder_;
};

TEST_F(LinkTargetTest, aFileIsItself) {
  const fs::path file = folder_.path() / "table.c64";
  EXPECT_EQ(linkTarget(file), file) << "also if it does not exist";
  std::ofstream(file) << "x";
  EXPECT_EQ(linkTarget(file), file);
}

TEST_F(LinkTargetTest, linksAreFollowedToWhatTheyPointTo) {
  const fs::path file = folder_.path() / "table.c64";
  const fs::path first = link(file, "absolute");
  link("absolute", "relative");
  EXPECT_EQ(linkTarget(first), file);
  EXPECT_EQ(linkTarget(folder_.path() / "relative"), file);
  fs::create_directory(folder_.path() / "below");
  link("../relative", "below/up");
  EXPECT_EQ(fs::weakly_canonical(linkTarget(folder_.path() / "below/up")), fs::weakly_canonical(file));
}

TEST_F(LinkTargetTest, aCircleOfLinksEnds) {
  link("b", "a");
  link("a", "b");
  const fs::path end = linkTarget(folder_.path() / "a");
  EXPECT_TRUE(end.filename() == "a" || end.filename() == "b");
}

TEST(OptionalModuleTest, aModuleThatIsMissingIsNamed) {
  OptionalModule module("robotcontrol_of_tomorrow.so");
  EXPECT_NE(module.problem().find("robotcontrol_of_tomorrow.so"), std::string::npos) << module.problem();
  EXPECT_EQ(module.function<void (*)()>("anything"), nullptr);
}

TEST(OptionalModuleTest, aFileThatIsNoModuleIsNone) {
  const TestFolder folder;
  const fs::path file = folder.path() / "text.so";
  std::ofstream(file) << "no library";
  OptionalModule module(file.string());
  EXPECT_FALSE(module.problem().empty());
  EXPECT_EQ(module.function<void (*)()>("anything"), nullptr);
}

}  // namespace
}  // namespace robotlink
