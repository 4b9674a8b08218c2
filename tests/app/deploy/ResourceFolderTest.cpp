// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/ResourceFolder.h"

#include <gmock/gmock.h>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;

class ResourceFolderTest : public testing::Test {
 protected:
  std::string contents(const std::string& path) {
    return robotlink::readFile(files_ / path).value_or("none");
  }

  const TestFolder files_;
  const ResourceFolder folder_{files_ / "robot"};
};

TEST_F(ResourceFolderTest, filesAreWrittenAndListedWithTheirChecksums) {
  EXPECT_TRUE(folder_.list().value().empty());
  ASSERT_TRUE(folder_.put("motions/sit.mof", "abc"));
  ASSERT_TRUE(folder_.put("layouts/own.yaml", ""));
  ASSERT_TRUE(folder_.put("parameters/ers210/motion.x.textproto", "x"));
  ASSERT_TRUE(folder_.put("colortables/red1.c64", "table"));
  ASSERT_TRUE(folder_.put("motions/sit.mof", "abc"));
  EXPECT_EQ(contents("robot/motions/sit.mof"), "abc");
  const auto list = folder_.list().value();
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[2].path, "motions/sit.mof");
  EXPECT_EQ(list[2].bytes, 3U);
  EXPECT_EQ(list[2].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(ResourceFolderTest, noPathLeadsOutOfTheFolderOrToOtherFiles) {
  for (const std::string path : {"",
                                 ".",
                                 "..",
                                 "/etc/passwd",
                                 "../layouts/a.yaml",
                                 "layouts/../../a.yaml",
                                 "layouts/../layouts/a.yaml",
                                 "layouts//a.yaml",
                                 "layouts/./a.yaml",
                                 "layouts/.a.yaml",
                                 "layouts/a.yaml/",
                                 "layouts/a.sh",
                                 "layouts/a",
                                 "layouts/sub/a.yaml",
                                 "parameters/a.textproto",
                                 "robots/ers210.yaml",
                                 "scenes/field.sdf",
                                 "motions/a\\b.mof",
                                 "motions/a\n.mof",
                                 "colortables/.c64"}) {
    EXPECT_FALSE(folder_.put(path, "x")) << path;
    EXPECT_FALSE(ResourceFolder::check(path)) << path;
  }
  EXPECT_FALSE(folder_.put(std::string("layouts/a\0.yaml", 15), "x"));
  EXPECT_FALSE(folder_.put("layouts/" + std::string(300, 'a') + ".yaml", "x"));
  EXPECT_TRUE(files_.files().empty());
  EXPECT_THAT(folder_.put("robots/ers210.yaml", "x").error().text, HasSubstr("layouts/NAME.yaml"));
}

TEST_F(ResourceFolderTest, symbolicLinksAreNotFollowed) {
  files_.write("mine.yaml", "mine");
  std::filesystem::create_directories(files_ / "robot/layouts");
  std::filesystem::create_symlink(files_ / "mine.yaml", files_ / "robot/layouts/link.yaml");
  std::filesystem::create_directories(files_ / "elsewhere");
  std::filesystem::create_symlink(files_ / "elsewhere", files_ / "robot/motions");
  EXPECT_FALSE(folder_.put("layouts/link.yaml", "theirs"));
  EXPECT_FALSE(folder_.put("motions/sit.mof", "theirs"));
  EXPECT_EQ(contents("mine.yaml"), "mine");
  EXPECT_TRUE(std::filesystem::is_empty(files_ / "elsewhere"));
  EXPECT_TRUE(folder_.list().value().empty());
}

TEST_F(ResourceFolderTest, whatIsTooMuchIsRefused) {
  const std::string large(ResourceFolder::kMaxFileBytes, 'x');
  EXPECT_THAT(folder_.put("layouts/a.yaml", large + "x").error().text, HasSubstr("longer than 2 MiB"));
  for (std::uint64_t i = 0; i < ResourceFolder::kMaxBytes / large.size(); ++i)
    ASSERT_TRUE(folder_.put("layouts/" + std::to_string(i) + ".yaml", large));
  EXPECT_THAT(folder_.put("layouts/more.yaml", "x").error().text, HasSubstr("full"));
  // What replaces a file needs no more room.
  EXPECT_TRUE(folder_.put("layouts/0.yaml", large));
}

}  // namespace
}  // namespace app
