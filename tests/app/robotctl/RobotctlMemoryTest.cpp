// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory robotctl takes for many logs.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "logplayer/mcap/write/Writer.h"
#include "tests/TestFolder.h"

namespace {

using robotlink::Instant;

/// Megabytes that robotctl had at most; 0 if it failed.
long megabytesOf(const std::filesystem::path& folder, std::vector<std::string> arguments) {
  std::vector<char*> words{const_cast<char*>(ROBOTCTL)};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const pid_t pid = ::fork();
  if (pid == 0) {
    // The address sanitizer would keep what is freed.
    ::setenv("ASAN_OPTIONS", "quarantine_size_mb=0:thread_local_quarantine_size_kb=0", 1);
    if (::chdir(folder.c_str()) == 0) ::execv(ROBOTCTL, words.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(pid, &status, 0, &usage);
  return status == 0 ? usage.ru_maxrss / 1024 : 0;
}

void writeLog(const std::filesystem::path& file, int number, std::chrono::milliseconds start) {
  auto writer = logplayer::mcap::Writer::create(file, {});
  ASSERT_TRUE(writer);
  const auto channel = (*writer)->addChannel("robot" + std::to_string(number) + "/data", 0, "text", {});
  ASSERT_TRUE(channel);
  const std::vector<std::uint8_t> data(10'000, 7);
  for (int i = 0; i < 1500; ++i) {
    const Instant time = Instant(start) + i * std::chrono::milliseconds(10);
    ASSERT_TRUE((*writer)->write({*channel, 0, time, time, data}));
  }
  ASSERT_TRUE((*writer)->close());
}

void mergeMany(std::chrono::milliseconds apart) {
#ifdef ROBOTCONTROL_SANITIZED
  GTEST_SKIP() << "sanitizers keep what was freed";
#endif
  const TestFolder folder;
  std::vector<std::string> arguments{"log", "merge"};
  for (int i = 0; i < 12; ++i) {
    const std::string name = std::to_string(i) + ".mcap";
    ASSERT_NO_FATAL_FAILURE(writeLog(folder / name, i, i * apart));
    arguments.push_back(name);
  }
  std::vector<std::string> few(arguments.begin(), arguments.begin() + 4);
  few.push_back("few.mcap");
  arguments.push_back("many.mcap");
  const long forTwo = megabytesOf(folder.path(), few);
  const long forTwelve = megabytesOf(folder.path(), arguments);
  ASSERT_GT(forTwo, 0);
  ASSERT_GT(forTwelve, 0);
  EXPECT_LT(forTwelve, forTwo + 60) << "of 15 MB each, 150 MB more in all";
}

}  // namespace

TEST(RobotctlMemory, ofAMergeIsBoundedForAllLogsAtTheSameTime) {
  mergeMany(std::chrono::milliseconds(0));
}

TEST(RobotctlMemory, ofAMergeIsBoundedForLogsOneBehindTheOther) {
  mergeMany(std::chrono::milliseconds(20'000));
}
