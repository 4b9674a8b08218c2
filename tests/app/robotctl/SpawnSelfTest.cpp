// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/SpawnSelf.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

int statusOf(::pid_t process) {
  int status = 0;
  return ::waitpid(process, &status, 0) == process && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SpawnSelf, theSameProgramRunsWithOtherArgumentsAndStreams) {
  const TestFolder folder;
  const std::string output = (folder / "output.txt").string();
  const ::pid_t process = spawnSelf({"--gtest_list_tests", "--gtest_filter=SpawnSelf.*"}, [&] {
    return ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT, 0644), STDOUT_FILENO) >= 0;
  });
  ASSERT_EQ(statusOf(process), 0);
  const auto listed = robotlink::readFile(output);
  ASSERT_TRUE(listed);
  EXPECT_NE(listed->find("theSameProgramRunsWithOtherArgumentsAndStreams"), std::string::npos) << *listed;
}

TEST(SpawnSelf, withoutItsStreamsNothingRuns) {
  EXPECT_EQ(statusOf(spawnSelf({"--gtest_list_tests"}, [] { return false; })), 127);
}

}  // namespace
}  // namespace app
