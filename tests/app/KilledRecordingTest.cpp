// SPDX-License-Identifier: GPL-3.0-or-later
// A program that records a simulated robot is killed at random times: at most a second is lost, frames are
// whole.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <sstream>
#include <thread>

#include "logplayer/file/LogFile.h"
#include "tests/app/robotctl/RobotctlRun.h"
#include "tests/logplayer/RecordedMessages.h"

using logplayer::tests::TestFolder;

namespace {

constexpr double kLongest = 4;  // s, that a killed program has recorded

/// What a frame told: paths and bytes, in order.
using Frame = std::vector<std::pair<std::string, std::string>>;
/// Keyed by process and number.
using Frames = std::map<std::pair<std::string, std::uint64_t>, Frame>;

/// A robotctl that records in real time and says how far it is.
class RecordingProgram {
 public:
  explicit RecordingProgram(const std::filesystem::path& file) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) std::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDERR_FILENO);
      ::execl(ROBOTCTL, ROBOTCTL, "sim", kScene.c_str(), "--seconds", "60", "--speed", "1", "--progress",
              "--record", file.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(ends[1]);
    stderr_ = ::fdopen(ends[0], "r");
  }
  ~RecordingProgram() {
    if (pid_ > 0) kill();
    std::fclose(stderr_);
  }
  RecordingProgram(const RecordingProgram&) = delete;
  RecordingProgram& operator=(const RecordingProgram&) = delete;

  /// Waits until it has said that it is at least so far; how far it is then, or -1 if it has ended.
  double waitFor(double seconds) {
    while (progress_ < seconds) {
      if (!readProgress()) return -1;
    }
    return progress_;
  }
  /// How far it said that it was before it ended.
  double kill() {
    ::kill(pid_, SIGKILL);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = 0;
    EXPECT_TRUE(WIFSIGNALED(status));
    while (readProgress()) {
    }
    return progress_;
  }

 private:
  bool readProgress() {
    char line[200];
    if (std::fgets(line, sizeof line, stderr_) == nullptr) return false;
    progress_ = std::max(progress_, std::atof(line));
    return true;
  }
  pid_t pid_ = 0;
  FILE* stderr_ = nullptr;
  double progress_ = 0;
};

struct Recorded {
  Frames whole;
  std::vector<std::string> torn;  // frames without their end
  double end = 0;                 // s, of the last whole frame
};

Recorded framesOf(const std::shared_ptr<logplayer::LogFile>& log) {
  Recorded recorded;
  logplayer::LogFile::Cursor cursor(log, {});
  Frames open;
  while (const auto message = cursor.next()) {
    if (message->frame == 0) continue;
    const std::pair key(message->process, message->frame);
    open[key].emplace_back(message->path, message->value->SerializeAsString());
    if (dynamic_cast<const robotcontrol::FrameInfo*>(message->value.get()) == nullptr) continue;
    recorded.end = std::max(recorded.end, robotlink::seconds(message->time));
  }
  for (auto& [key, frame] : open) {
    const bool ends = std::any_of(frame.begin(), frame.end(), [](const auto& m) {
      return m.first.find("/frames/") != std::string::npos;
    });
    if (!ends) recorded.torn.push_back(key.first + " " + std::to_string(key.second));
    recorded.whole.insert_or_assign(key, std::move(frame));
  }
  return recorded;
}

/// The same game, not killed.
Frames reference(const TestFolder& folder) {
  const std::filesystem::path file = folder / "reference.mcap";
  std::ostringstream command;
  command << ROBOTCTL << " sim " << kScene << " --seconds " << kLongest + 3 << " --record " << file
          << " >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.str().c_str()), 0);
  auto log = logplayer::LogFile::open(file, {});
  if (!log) ADD_FAILURE() << log.error().describe();
  return log ? framesOf(*log).whole : Frames();
}

void killAtRandom(const std::filesystem::path& file, double after, const Frames& expected) {
  SCOPED_TRACE("killed after " + std::to_string(after) + " s");
  double killedAt = 0;
  {
    RecordingProgram program(file);
    const double progress = program.waitFor(std::floor(10 * after) / 10);
    ASSERT_GE(progress, 0) << "the program has ended by itself";
    std::this_thread::sleep_for(std::chrono::duration<double>(std::max(0.0, after - progress)));
    killedAt = program.kill();
  }
  auto log = logplayer::LogFile::open(file, {});
  ASSERT_TRUE(log.has_value()) << log.error().describe();
  const Recorded recorded = framesOf(*log);
  EXPECT_LE(killedAt - recorded.end, 1.0);
  EXPECT_TRUE(recorded.torn.empty()) << recorded.torn.front();
  for (const auto& [key, frame] : recorded.whole) {
    const auto found = expected.find(key);
    ASSERT_NE(found, expected.end()) << key.first << " " << key.second;
    ASSERT_TRUE(frame == found->second) << key.first << " " << key.second;
  }
}

void killOften(int runs, double longest, unsigned seed) {
  const TestFolder folder;
  const Frames expected = reference(folder);
  ASSERT_GT(expected.size(), 500U);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> time(0.15, longest);
  for (int i = 0; i < runs && !::testing::Test::HasFailure(); ++i) {
    const std::filesystem::path file = folder / "killed.mcap";
    killAtRandom(file, time(random), expected);
    std::filesystem::remove(file);
  }
}

}  // namespace

TEST(KilledRecording, losesAtMostASecondAndNoHalfFrames) {
  killOften(2, 1.5, 7);
}

TEST(SlowKilledRecording, losesAtMostASecondAndNoHalfFramesAHundredTimes) {
  killOften(100, kLongest, 1);
}
