// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/UnfinishedFile.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <optional>
#include <thread>

#include "tests/TestFolder.h"

namespace robotlink {
namespace {

/// Ends a program in which `begin` was done; its status.
template <typename Begin>
int statusOf(Begin begin) {
  const pid_t child = ::fork();
  if (child == 0) {
    begin();
    endProgram(7);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(UnfinishedFile, isRemovedWhenTheProgramIsEnded) {
  const TestFolder folder;
  EXPECT_EQ(statusOf([&] {
              folder.write("log.tmp", "half");
              folder.write("folder/inside.txt", "half");
              folder.write("mine.txt", "whole");
              static const UnfinishedFile file(folder / "log.tmp"), directory(folder / "folder");
            }),
            7);
  EXPECT_EQ(folder.contents(), "mine.txt");
}

TEST(UnfinishedFile, oneThatIsFinishedStays) {
  const TestFolder folder;
  EXPECT_EQ(statusOf([&] {
              folder.write("log.mcap", "whole");
              std::optional<UnfinishedFile> file;
              file.emplace(folder / "log.mcap");
              file.reset();
            }),
            7);
  EXPECT_EQ(folder.contents(), "log.mcap");
}

TEST(UnfinishedFile, whoTakesItOverIsItsOwner) {
  const TestFolder folder;
  statusOf([&] {
    folder.write("log.tmp", "half");
    std::optional<UnfinishedFile> first;
    first.emplace(folder / "log.tmp");
    static const UnfinishedFile second(std::move(*first));
    first.reset();
  });
  EXPECT_EQ(folder.contents(), "");
}

TEST(UnfinishedFile, twoOwnersOfAFileBothHaveToFinishIt) {
  const TestFolder folder;
  statusOf([&] {
    folder.write("log.tmp", "half");
    static const UnfinishedFile one(folder / "log.tmp");
    { const UnfinishedFile other(folder / "log.tmp"); }
  });
  EXPECT_EQ(folder.contents(), "");
}

TEST(UnfinishedFile, oneThatWasNeverMadeDoesNoHarm) {
  EXPECT_EQ(statusOf([] { static const UnfinishedFile file("/no/such/folder/file.txt"); }), 7);
}

TEST(UnfinishedFile, theEndOfTheProgramWaitsForAChangeInPlace) {
  const TestFolder folder;
  std::atomic<bool> begun{false};
  std::thread change;
  EXPECT_EQ(statusOf([&] {
              change = std::thread([&] {
                const ChangeInPlace whole;
                begun = true;
                for (int i = 0; i < 100; ++i) folder.write(std::to_string(i), "half");
                folder.write("log.mcap", "whole");
              });
              while (!begun) std::this_thread::yield();
            }),
            7);
  EXPECT_TRUE(std::filesystem::exists(folder / "log.mcap"));
}

}  // namespace
}  // namespace robotlink
