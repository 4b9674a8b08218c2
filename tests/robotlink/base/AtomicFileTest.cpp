// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/AtomicFile.h"

#include <gtest/gtest.h>

using namespace robotlink;
namespace fs = std::filesystem;

TEST(AtomicFile, whatIsWrittenIsReadBack) {
  const fs::path path = fs::path(testing::TempDir()) / "atomic" / "file.txt";
  ASSERT_TRUE(writeFileAtomically(path, "first").has_value());
  ASSERT_TRUE(writeFileAtomically(path, "second").has_value());
  EXPECT_EQ(readFile(path).value(), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), {}), 1);
  fs::remove_all(path.parent_path());
}

TEST(AtomicFile, aSymbolicLinkIsKeptAndItsTargetWritten) {
  const fs::path folder = fs::path(testing::TempDir()) / "atomic-link";
  fs::remove_all(folder);
  ASSERT_TRUE(writeFileAtomically(folder / "target.txt", "first").has_value());
  fs::create_symlink("target.txt", folder / "link.txt");
  fs::create_symlink("new.txt", folder / "dangling.txt");
  ASSERT_TRUE(writeFileAtomically(folder / "link.txt", "second").has_value());
  ASSERT_TRUE(writeFileAtomically(folder / "dangling.txt", "third").has_value());
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_TRUE(fs::is_symlink(folder / "dangling.txt"));
  EXPECT_EQ(readFile(folder / "target.txt").value(), "second");
  EXPECT_EQ(readFile(folder / "new.txt").value(), "third");
  fs::remove_all(folder);
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
