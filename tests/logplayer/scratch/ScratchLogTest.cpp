// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/scratch/ScratchLog.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <semaphore>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"

using namespace logplayer;
using namespace robotlink;
using namespace std::chrono_literals;
using robotcontrol::PlotValue;

namespace {

Instant second(double time) {
  return Instant(fromSeconds(time));
}

StreamMessage scratched(const std::string& path, double time, const std::string& process = "cognition") {
  auto message = std::make_shared<PlotValue>();
  message->set_value(time);
  message->set_unit(std::string(2'000, 'm'));
  StreamMessage result{path, second(time), message};
  result.process = process;
  result.frame = static_cast<std::uint64_t>(time * 10);
  return result;
}

/// Streams of a robot over time: one of ten messages a second, one of one in seven seconds.
class ScratchLogTest : public testing::Test {
 protected:
  void archive(ScratchLog::Options options) {
    auto log = std::make_unique<ScratchLog>(options);
    log_ = log.get();
    session_.history().setArchive(std::move(log));
  }
  void runUntil(double end) {
    for (; count_ < end * 10; ++count_) {
      if (count_ % 250 == 0) session_.tick();
      session_.push(scratched("red1/a", 0.1 * count_));
      if (count_ % 70 == 0) session_.push(scratched("red1/slow", 0.1 * count_));
    }
    session_.tick();
    log_->finish();
  }
  double shown(const std::string& path) {
    const auto* value = session_.store().latestAs<PlotValue>(path, session_.timeline().shown());
    return value ? value->value() : -1;
  }
  void show(double time) {
    session_.history().show(second(time));
    log_->finish();
    session_.tick();
  }
  static inline const ScratchLog::Options kRoomy{.bytes = 100U << 20U, .reserve = 0};

  /// Lets files be written, in tests of a slow disk.
  std::counting_semaphore<> written_{0};
  Session session_{StreamStore::Limits{.bytes = 200'000}};
  ScratchLog* log_ = nullptr;
  int count_ = 0;
};

}  // namespace

TEST_F(ScratchLogTest, whatNoLongerFitsIntoMemoryIsReadFromDisk) {
  archive(kRoomy);
  runUntil(100);
  EXPECT_FALSE(session_.store().has(second(30)));
  EXPECT_GT(log_->bytes(), 0U);
  for (const double time : {30.05, 3.05, 69.95, 0.0, 55.05}) {
    show(time);
    EXPECT_EQ(session_.timeline().shown(), second(time));
    EXPECT_NEAR(shown("red1/a"), std::floor(time * 10) / 10, 0.001) << time;
    EXPECT_NEAR(shown("red1/slow"), std::floor(time / 7) * 7, 0.001) << time;
  }
  const auto* message = session_.store().latest("red1/a", second(55.05));
  EXPECT_EQ(message->process, "cognition");
  EXPECT_EQ(message->frame, 550U);
}

TEST_F(ScratchLogTest, whatWaitsToBeWrittenIsReadFromMemory) {
  archive(kRoomy);
  log_->add({scratched("red1/a", 1), scratched("red1/a", 2), scratched("red1/b", 1.5)},
            {second(0), second(3)});
  log_->request(second(2));
  log_->finish();
  const auto part = log_->take();
  ASSERT_TRUE(part);
  EXPECT_EQ(part->stretch, (Stretch{second(1), second(3)}));
  ASSERT_EQ(part->messages.size(), 3U);
  EXPECT_EQ(part->messages[1].path, "red1/b") << "in order of time";
}

TEST_F(ScratchLogTest, theOldestFilesGoBeyondTheBound) {
  archive({.bytes = 20'000, .reserve = 0});
  runUntil(300);
  EXPECT_LE(log_->bytes(), 20'000U);
  EXPECT_GT(log_->bytes(), 5'000U);
  const Stretch kept = *log_->stretch();
  EXPECT_GT(kept.from, second(30));
  show(0);
  EXPECT_EQ(session_.timeline().shown(), kept.from) << "the oldest that is left";
  const double from = seconds(kept.from.time_since_epoch());
  EXPECT_NEAR(shown("red1/slow"), std::floor(from / 7 + 1e-6) * 7, 0.001) << "the state there is complete";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(log_->folder()))
    files += entry.is_regular_file();
  EXPECT_LT(files, 100U);
}

TEST_F(ScratchLogTest, aFullDiskIsReportedOnceAndWhatIsThereStaysReadable) {
  archive({.bytes = 100U << 20U, .reserve = ~std::uint64_t{0}});
  runUntil(100);
  const auto problem = log_->takeProblem();
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->text.find("disk is full"), std::string::npos);
  runUntil(200);
  EXPECT_FALSE(log_->takeProblem());
  EXPECT_FALSE(log_->stretch());
  show(0);
  EXPECT_EQ(session_.timeline().shown(), session_.store().horizon()) << "memory has what it can hold";
}

TEST_F(ScratchLogTest, whatADiskIsTooSlowForIsAHole) {
  archive(
      {.bytes = 100U << 20U, .reserve = 0, .waiting = 2'000, .beforeWrite = [this] { written_.acquire(); }});
  const auto sized = [](const std::string& path, double time) {
    StreamMessage message = scratched(path, time);
    message.bytes = 2'000;
    return message;
  };
  EXPECT_TRUE(log_->hasRoom());
  log_->add({sized("red1/a", 1)}, {second(0), second(2)});
  EXPECT_FALSE(log_->hasRoom());
  EXPECT_FALSE(log_->isLosing());
  log_->add({sized("red1/slow", 0.5), sized("red1/a", 2), sized("red1/a", 3)}, {second(2), second(4)});
  EXPECT_TRUE(log_->isLosing());
  const auto problem = log_->takeProblem();
  EXPECT_TRUE(problem && problem->text.find("too slow") != std::string::npos);
  log_->add({sized("red1/a", 4)}, {second(4), second(5)});
  EXPECT_FALSE(log_->takeProblem()) << "it is reported once";
  written_.release(100);
  log_->finish();
  EXPECT_FALSE(log_->isLosing());
  log_->add({sized("red1/a", 5)}, {second(5), second(6)});
  log_->finish();
  EXPECT_EQ(log_->stretch(), (Stretch{second(1), second(6)}));
  EXPECT_EQ(log_->holes(), (std::vector<Stretch>{{second(2), second(5)}}));
  const auto read = [this](double time) {
    log_->request(second(time));
    log_->finish();
    return log_->take().value_or(ScratchLog::Part{});
  };
  const auto before = read(1.9), behind = read(5.5);
  EXPECT_EQ(before.stretch, (Stretch{second(1), second(2)}));
  ASSERT_EQ(before.messages.size(), 3U) << "what held at the begin of the hole is there";
  EXPECT_EQ(before.messages[0].path, "red1/slow");
  EXPECT_EQ(before.messages[2].time, second(2));
  EXPECT_EQ(behind.stretch, (Stretch{second(5), second(6)}));
  EXPECT_EQ(behind.messages.back().time, second(5));
}

TEST_F(ScratchLogTest, allThatMemoryNoLongerHoldsIsOnDiskAfterItWasLowered) {
  constexpr std::size_t kMib = std::size_t{1} << 20U;
  archive({.bytes = 100U << 20U, .reserve = 0, .waiting = 20 * kMib, .beforeWrite = [this] {
             written_.acquire();
           }});
  session_.store().setBytes(200 * kMib);
  for (int i = 0; i < 100; ++i) {
    StreamMessage message = scratched("red1/a", 0.1 * i);
    message.bytes = kMib;
    session_.push(message);
    session_.tick();
  }
  session_.store().setBytes(20 * kMib);
  for (int i = 0; i < 10; ++i) session_.tick();
  EXPECT_EQ(session_.store().bytes(), 84 * kMib) << "until the disk has written that";
  written_.release(100);
  for (int i = 0; i < 10; ++i) {
    session_.tick();
    log_->finish();
  }
  EXPECT_EQ(session_.store().bytes(), 20 * kMib);
  EXPECT_FALSE(log_->takeProblem());
  EXPECT_TRUE(log_->holes().empty());
  EXPECT_EQ(session_.history().kept().size(), 1U);
  show(3.05);
  EXPECT_NEAR(shown("red1/a"), 3.0, 0.001);
}

TEST_F(ScratchLogTest, theLimitCanBeChanged) {
  archive(kRoomy);
  runUntil(100);
  const std::uint64_t before = log_->bytes();
  log_->setLimit(before / 2);
  EXPECT_LE(log_->bytes(), before / 2);
  log_->setLimit(0);
  EXPECT_FALSE(log_->stretch());
  runUntil(120);
  EXPECT_FALSE(log_->stretch());
  log_->setLimit(before);
  runUntil(200);
  EXPECT_GT(log_->bytes(), 0U);
}

TEST_F(ScratchLogTest, aResetForgetsAll) {
  archive(kRoomy);
  runUntil(100);
  const auto folder = log_->folder();
  session_.push(scratched("red1/a", 0.5));
  session_.tick();
  log_->finish();
  EXPECT_FALSE(log_->stretch());
  EXPECT_EQ(log_->bytes(), 0U);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_EQ(entry.path().extension(), ".lock");
}

TEST_F(ScratchLogTest, sharesOfTheStreamsAreKnown) {
  archive(kRoomy);
  runUntil(100);
  const auto shares = log_->shares();
  EXPECT_GT(shares.at("red1/a"), 50 * shares.at("red1/slow"));
}

TEST_F(ScratchLogTest, theFolderIsRemovedAtTheEnd) {
  archive(kRoomy);
  runUntil(100);
  const auto folder = log_->folder();
  ASSERT_TRUE(std::filesystem::exists(folder));
  session_.history().setArchive(nullptr);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(ScratchFolder, foldersOfProgramsThatWereKilledAreRemovedByTheNext) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto folder = ScratchFolder::make();
    const std::string path = folder ? folder->path().string() : "";
    std::ofstream(folder->path() / "1.mcap") << "content";
    if (::write(ends[1], path.data(), path.size()) < 0) ::_exit(1);
    ::close(ends[1]);
    ::pause();
    ::_exit(0);
  }
  ::close(ends[1]);
  char path[4096] = {};
  ASSERT_GT(::read(ends[0], path, sizeof path - 1), 0);
  ::close(ends[0]);
  const auto other = ScratchFolder::make();
  ASSERT_TRUE(other);
  EXPECT_TRUE(std::filesystem::exists(path)) << "its program runs";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(path));
  const auto next = ScratchFolder::make();
  ASSERT_TRUE(next);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(std::filesystem::exists(other->path()));
}
