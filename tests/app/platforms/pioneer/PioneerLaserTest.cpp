// SPDX-License-Identifier: GPL-3.0-or-later
// A laser at the other end of a pseudo-terminal.
#include "app/platforms/pioneer/PioneerLaser.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "robotlink/base/Clock.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/arcos/PseudoTerminal.h"
#include "tests/robotlink/arcos/sick/SimulatedSick.h"

using namespace app;
using robotlink::arcos::SickSession;

namespace {

int baudOf(int terminal) {
  termios settings{};
  if (::tcgetattr(terminal, &settings) != 0) return 0;
  switch (::cfgetospeed(&settings)) {
    case B9600:
      return 9600;
    case B19200:
      return 19200;
    case B38400:
      return 38400;
    default:
      return 0;
  }
}

/// A simulated laser that serves a pseudo-terminal, in a thread of its own.
class LaserAtTerminal {
 public:
  LaserAtTerminal() : thread_([this] { run(); }) {}
  ~LaserAtTerminal() {
    quit_ = true;
    thread_.join();
  }
  std::string device() const { return terminal_.path().string(); }
  void unplug() {
    const std::lock_guard lock(mutex_);
    terminal_.unplug();
  }
  void plugIn() {
    const std::lock_guard lock(mutex_);
    terminal_.plugIn();
  }
  void restart() {
    const std::lock_guard lock(mutex_);
    laser_.restart();
  }
  int baud() {
    const std::lock_guard lock(mutex_);
    return laser_.baud();
  }
  bool isContinuous() {
    const std::lock_guard lock(mutex_);
    return laser_.isContinuous();
  }
  /// From now on every third scan lacks a byte.
  void loseBytes() { losing_ = true; }

 private:
  void run() {
    for (int turn = 0; !quit_; ++turn) {
      {
        const std::lock_guard lock(mutex_);
        serve(turn % 5 == 0);
      }
      ::poll(nullptr, 0, 2);
    }
  }
  void serve(bool scan) {
    if (terminal_.master() < 0) return;
    std::array<std::uint8_t, 256> buffer{};
    pollfd polled{terminal_.master(), POLLIN, 0};
    const int baud = baudOf(terminal_.master());
    if (::poll(&polled, 1, 0) > 0 && (polled.revents & POLLIN) != 0) {
      const ssize_t got = ::read(terminal_.master(), buffer.data(), buffer.size());
      if (got > 0) write(laser_.take(std::span(buffer).first(static_cast<std::size_t>(got)), baud));
    }
    if (!scan) return;
    auto bytes = laser_.scan(baud);
    if (losing_ && !bytes.empty() && ++scans_ % 3 == 0)
      bytes.erase(bytes.begin() + scans_ % static_cast<int>(bytes.size()));
    write(bytes);
  }
  void write(const SimulatedSick::Bytes& bytes) const {
    // A terminal that nobody reads is full some time, and what it does not take is lost, as on a line.
    pollfd polled{terminal_.master(), POLLOUT, 0};
    if (bytes.empty() || ::poll(&polled, 1, 0) <= 0 || (polled.revents & POLLOUT) == 0) return;
    EXPECT_NE(0, ::write(terminal_.master(), bytes.data(), bytes.size()));
  }

  const TestFolder folder_;
  /// Protects what follows.
  std::mutex mutex_;
  PseudoTerminal terminal_{folder_ / "ttyLASER"};
  SimulatedSick laser_;
  int scans_ = 0;
  std::atomic<bool> losing_{false}, quit_{false};
  std::thread thread_;
};

class PioneerLaserTest : public testing::Test {
 protected:
  /// Steps the laser until scans come at the speed that they should; counts them.
  bool scansCome(int count = 3) {
    int seen = 0;
    return eventually([&] {
      laser_->step();
      const auto scan = laser_->takeScan();
      if (!scan) return false;
      EXPECT_EQ(scan->ranges.size(), 181U);
      EXPECT_NEAR(scan->ranges[90], 1.9, 1e-9);
      return ++seen >= count;
    });
  }
  bool runs() const { return laser_->session().state() == SickSession::State::kRunning; }
  bool stops() {
    return eventually([this] {
      laser_->step();
      return !runs();
    });
  }

  robotlink::SteadyClock clock_;
  LaserAtTerminal device_;
  std::optional<PioneerLaser> laser_{std::in_place, robotlink::arcos::SerialAddress{device_.device(), 38400},
                                     SickSession::Options{}, clock_};
};

TEST_F(PioneerLaserTest, scansComeAtTheSpeedThatWasAskedFor) {
  ASSERT_TRUE(scansCome()) << laser_->session().describe();
  EXPECT_EQ(device_.baud(), 38400);
  laser_.reset();
  EXPECT_TRUE(eventually([&] { return !device_.isContinuous(); })) << "at the end it is quiet";
}

TEST_F(PioneerLaserTest, lostBytesCostSingleScans) {
  device_.loseBytes();
  ASSERT_TRUE(scansCome(30)) << laser_->session().describe();
  EXPECT_GT(laser_->session().counters().bytes.checksumErrors, 0U);
  EXPECT_EQ(laser_->session().counters().starts, 1U);
}

TEST_F(PioneerLaserTest, anAdapterThatIsPulledOutAndPutInAgainIsFound) {
  ASSERT_TRUE(scansCome());
  device_.unplug();
  EXPECT_TRUE(stops());
  EXPECT_NE(laser_->session().describe(), "the laser sends scans");
  device_.plugIn();
  EXPECT_TRUE(scansCome()) << laser_->session().describe();
}

TEST_F(PioneerLaserTest, aLaserThatWasSwitchedOffAndOnIsSetUpAgain) {
  ASSERT_TRUE(scansCome());
  device_.restart();
  EXPECT_TRUE(stops());
  EXPECT_TRUE(scansCome()) << laser_->session().describe();
  EXPECT_EQ(device_.baud(), 38400);
}

}  // namespace
