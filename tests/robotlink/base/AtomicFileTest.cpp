// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/AtomicFile.h"

#include <gtest/gtest.h>

#include "tests/TestFolder.h"

using namespace robotlink;
namespace fs = std::filesystem;

TEST(AtomicFile, whatIsWrittenIsReadBack) {
  const TestFolder folder;
  const fs::path path = folder / "new/file.txt";
  ASSERT_TRUE(writeFileAtomically(path, "first").has_value());
  ASSERT_TRUE(writeFileAtomically(path, "second").has_value());
  EXPECT_EQ(readFile(path).value(), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), {}), 1);
}

TEST(AtomicFile, aSymbolicLinkIsKeptAndItsTargetWritten) {
  const TestFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "target.txt", "first").has_value());
  fs::create_symlink("target.txt", folder / "link.txt");
  fs::create_symlink("new.txt", folder / "dangling.txt");
  ASSERT_TRUE(writeFileAtomically(folder / "link.txt", "second").has_value());
  ASSERT_TRUE(writeFileAtomically(folder / "dangling.txt", "third").has_value());
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_TRUE(fs::is_symlink(folder / "dangling.txt"));
  EXPECT_EQ(readFile(folder / "target.txt").value(), "second");
  EXPECT_EQ(readFile(folder / "new.txt").value(), "third");
}

TEST(AtomicFile, aPlaceThatCannotBeWrittenIsReportedByName) {
  const auto result = writeFileAtomically("/proc/robotcontrol/file.txt", "x");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().id, "file.io");
  EXPECT_NE(result.error().describe().find("/proc/robotcontrol/file.txt"), std::string::npos);
}

TEST(AtomicFile, aDirectoryAMissingAndATooLargeFileAreRefused) {
  EXPECT_EQ(readFile("/").error().id, "file.directory");
  EXPECT_EQ(readFile("/no/such/file").error().id, "file.io");
  EXPECT_EQ(readFile("/proc/self/maps", 10).error().id, "file.too-large");
}
