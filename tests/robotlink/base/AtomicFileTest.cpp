// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/AtomicFile.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

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

TEST(AtomicFile, aPipeIsReadToItsEndAndIsNotWaitedForForEver) {
  const TestFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(readFile(pipe, 100, std::chrono::milliseconds(1)).error().id, "file.io") << "nobody writes";
  std::jthread writer([&pipe] {
    const int file = ::open(pipe.c_str(), O_WRONLY);
    EXPECT_EQ(::write(file, "first ", 6), 6);
    EXPECT_EQ(::write(file, "second", 6), 6);
    ::close(file);
  });
  EXPECT_EQ(readFile(pipe, 100).value(), "first second");
}
