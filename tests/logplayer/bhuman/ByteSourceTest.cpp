// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/ByteSource.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>

#include "logplayer/mcap/Source.h"
#include "tests/TestFolder.h"
#include "tests/logplayer/bhuman/MemoryBytes.h"

namespace logplayer::bhuman {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string readAt(ByteSource& source, std::uint64_t offset, std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  const std::size_t read = source.read(offset, bytes);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(read)};
}

TEST(ByteSource, aFileIsReadAtAnyPlace) {
  const TestFolder folder;
  auto source = openFile(folder.write("queue.log", "0123456789"));
  ASSERT_TRUE(source) << source.error().describe();
  EXPECT_EQ((*source)->size(), 10U);
  EXPECT_EQ(readAt(**source, 7, 3), "789");
  EXPECT_EQ(readAt(**source, 2, 4), "2345");
  EXPECT_EQ(readAt(**source, 8, 10), "89") << "only to the end";
  EXPECT_EQ(readAt(**source, 10, 1), "");
  EXPECT_EQ(readAt(**source, ~std::uint64_t{0}, 1), "");
}

TEST(ByteSource, aFileThatWasCutOffSinceEndsEarly) {
  const TestFolder folder;
  const auto file = folder.write("queue.log", "0123456789");
  auto source = openFile(file);
  ASSERT_TRUE(source);
  std::filesystem::resize_file(file, 4);
  EXPECT_EQ(readAt(**source, 2, 8), "23");
}

TEST(ByteSource, memoryIsReadLikeAFile) {
  const std::array<std::uint8_t, 4> bytes{'a', 'b', 'c', 'd'};
  const auto source = bytesInMemory(bytes);
  EXPECT_EQ(source->size(), 4U);
  EXPECT_EQ(readAt(*source, 1, 2), "bc");
  EXPECT_EQ(readAt(*source, 3, 5), "d");
  EXPECT_EQ(readAt(*source, 4, 1), "");
}

TEST(ByteSource, whatIsMissingIsNamedWithTheReason) {
  const auto source = openFile("/no/such/folder/queue.log");
  ASSERT_FALSE(source);
  EXPECT_THAT(source.error().describe(), HasSubstr("/no/such/folder/queue.log"));
  EXPECT_THAT(source.error().describe(), HasSubstr("No such file"));
}

TEST(ByteSource, aFolderIsNoLogWhateverFailedBefore) {
  const TestFolder folder;
  errno = ENOSPC;  // left by something else
  const auto source = openFile(folder.path());
  ASSERT_FALSE(source);
  EXPECT_THAT(source.error().describe(), HasSubstr("not a regular file"));
  EXPECT_THAT(source.error().describe(), Not(HasSubstr("space")));
}

TEST(ByteSource, aNamedPipeIsRefusedInsteadOfWaitedFor) {
  const TestFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto queue = openFile(pipe);
  ASSERT_FALSE(queue);
  EXPECT_THAT(queue.error().describe(), HasSubstr("not a regular file"));
  EXPECT_FALSE(mcap::Source::open(pipe));
}

}  // namespace
}  // namespace logplayer::bhuman
