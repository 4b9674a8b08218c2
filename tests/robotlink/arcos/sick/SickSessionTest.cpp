// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/sick/SickSession.h"

#include <gtest/gtest.h>

#include "robotlink/base/Random.h"
#include "tests/robotlink/arcos/sick/SimulatedSick.h"

using namespace robotlink::arcos;
using robotlink::fromSeconds;
using robotlink::Instant;

namespace {

/// A session and a laser with a line between them, in simulated time.
class SickSessionTest : public testing::Test {
 protected:
  /// What happens to the bytes of the laser.
  enum class Line { kGood, kLosesBytes, kFlipsBits };

  void run(double seconds, Line line = Line::kGood) {
    for (const Instant end = now_ + fromSeconds(seconds); now_ < end; now_ += fromSeconds(0.01)) step(line);
  }
  void step(Line line) {
    if (!plugged_ && baud_ != 0) {
      baud_ = 0;
      session_->lineLost({"stream.lost", "the line is gone", {}, {}}, now_);
    }
    if (const auto wanted = session_->wantedLine(); wanted != line_) {
      line_ = wanted;
      baud_ = plugged_ && wanted ? wanted->baud : 0;
      if (baud_ != 0) session_->lineOpened(now_);
      if (wanted && !plugged_) session_->lineLost({"stream.no-device", "it is not there", {}, {}}, now_);
    }
    session_->tick(now_);
    const auto bytes = session_->takeOutgoing();
    if (baud_ == 0) return;
    deliver(laser_.take(bytes, baud_), line);
    if (++steps_ % 10 == 0) deliver(laser_.scan(baud_), line);
    while (auto scan = session_->takeScan()) scans_.push_back(std::move(*scan));
  }
  void deliver(SimulatedSick::Bytes bytes, Line line) {
    if (line == Line::kLosesBytes && !bytes.empty() && random_.uniform() < 0.3)
      bytes.erase(bytes.begin() +
                  static_cast<std::ptrdiff_t>(random_.uniform() * static_cast<double>(bytes.size())));
    if (line == Line::kFlipsBits && !bytes.empty() && random_.uniform() < 0.3)
      bytes[static_cast<std::size_t>(random_.uniform() * static_cast<double>(bytes.size()))] ^= 4U;
    session_->take(bytes, now_);
  }
  void begin(SickSession::Options options) {
    session_.emplace(options);
    line_.reset();
  }

  SimulatedSick laser_;
  std::optional<SickSession> session_{SickSession::Options{}};
  robotlink::Random random_{1, 1};
  Instant now_;
  bool plugged_ = true;
  std::optional<SickSession::Line> line_;
  int baud_ = 0, steps_ = 0;
  std::vector<SickSession::Scan> scans_;
};

TEST_F(SickSessionTest, aLaserThatWasSwitchedOnIsFoundAndSentToItsSpeed) {
  run(5);
  EXPECT_EQ(session_->state(), SickSession::State::kRunning) << session_->describe();
  EXPECT_EQ(laser_.baud(), 38400);
  EXPECT_TRUE(laser_.isContinuous());
  ASSERT_GT(scans_.size(), 5U);
  ASSERT_EQ(scans_.back().readings.ranges.size(), 181U);
  EXPECT_NEAR(robotlink::seconds(now_ - scans_.back().time), 0.15, 0.055)
      << "372 bytes take a tenth of a second";
  for (int i = 0; i < 181; ++i)
    EXPECT_NEAR(scans_.back().readings.ranges[static_cast<std::size_t>(i)], laser_.rangeOf(i), 1e-9);
}

TEST_F(SickSessionTest, everySpeedAndVariantCanBeHad) {
  for (const int baud : {9600, 19200, 38400}) {
    for (const bool half : {false, true}) {
      laser_ = SimulatedSick();
      laser_.setBaud(19200);
      scans_.clear();
      begin({.baud = baud, .halfDegrees = half, .unit = SickSession::Unit::kMillimeters});
      run(6);
      ASSERT_EQ(session_->state(), SickSession::State::kRunning) << baud << session_->describe();
      EXPECT_EQ(laser_.baud(), baud);
      ASSERT_FALSE(scans_.empty());
      EXPECT_EQ(scans_.back().readings.ranges.size(), half ? 361U : 181U);
      EXPECT_NEAR(scans_.back().readings.ranges[77], 1.77, 1e-9);
      EXPECT_EQ(laser_.setup()[5], 6) << "32 m";
    }
  }
}

TEST_F(SickSessionTest, theMemoryOfTheLaserIsWrittenOnlyWhereSomethingChanges) {
  run(5);
  EXPECT_EQ(laser_.written(), 0) << "cm is what it had";
  begin({.unit = SickSession::Unit::kMillimeters});
  run(5);
  EXPECT_EQ(laser_.written(), 1);
  begin({.unit = SickSession::Unit::kMillimeters});
  run(5);
  EXPECT_EQ(session_->state(), SickSession::State::kRunning);
  EXPECT_EQ(laser_.written(), 1);
}

TEST_F(SickSessionTest, lostBytesAndWrongChecksumsCostScansOnly) {
  for (const Line line : {Line::kLosesBytes, Line::kFlipsBits}) {
    run(30, line);
    scans_.clear();
    const std::uint64_t starts = session_->counters().starts;
    run(20, line);
    EXPECT_EQ(session_->state(), SickSession::State::kRunning);
    EXPECT_EQ(session_->counters().starts, starts) << "it was not started again";
    EXPECT_GT(scans_.size(), 80U);
    EXPECT_LT(scans_.size(), 190U);
    for (const auto& scan : scans_) ASSERT_EQ(scan.readings.ranges.size(), 181U);
  }
  EXPECT_GT(session_->counters().bytes.checksumErrors, 10U);
}

TEST_F(SickSessionTest, aLaserThatIsSwitchedOffAndOnIsFoundAgain) {
  run(5);
  laser_.restart();
  run(1);
  EXPECT_EQ(laser_.baud(), 9600);
  run(9);
  EXPECT_EQ(session_->state(), SickSession::State::kRunning) << session_->describe();
  EXPECT_EQ(laser_.baud(), 38400);
  EXPECT_EQ(session_->counters().starts, 2U);
}

TEST_F(SickSessionTest, aLineThatIsPulledOutIsOpenedAgain) {
  run(5);
  plugged_ = false;
  run(5);
  EXPECT_NE(session_->state(), SickSession::State::kRunning);
  EXPECT_EQ(session_->describe(), "it is not there");
  plugged_ = true;
  scans_.clear();
  run(5);
  EXPECT_EQ(session_->state(), SickSession::State::kRunning);
  EXPECT_FALSE(scans_.empty());
}

TEST_F(SickSessionTest, whatIsWrongIsSaid) {
  laser_.setBaud(115200);
  run(20);
  EXPECT_EQ(
      session_->describe(),
      "the laser does not answer at 9600, 19200 or 38400 baud: is it switched on, and is this its line?");
  laser_.setBaud(9600);
  laser_.setRefusing(true);
  run(20);
  EXPECT_EQ(session_->describe(), "the laser refuses to be set up");
  laser_.setRefusing(false);
  run(10);
  EXPECT_EQ(session_->describe(), "the laser sends scans");
}

TEST_F(SickSessionTest, aLineOfAFixedSpeedKeepsIt) {
  begin({.baud = 9600, .fixedSpeed = true});
  run(5);
  EXPECT_EQ(session_->state(), SickSession::State::kRunning);
  EXPECT_EQ(laser_.baud(), 9600);
}

TEST_F(SickSessionTest, atTheEndTheLaserIsQuiet) {
  run(5);
  session_->end();
  laser_.take(session_->takeOutgoing(), baud_);
  EXPECT_FALSE(laser_.isContinuous());
}

}  // namespace
