// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/LatencyTrace.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {
namespace {

using robotcontrol::StopwatchTimes;

robotlink::Instant at(double time) {
  return robotlink::Instant(robotlink::fromSeconds(time));
}

/// A frame, as a process reports it.
class MeasuredFrame {
 public:
  explicit MeasuredFrame(double time, bool clockStands = true) {
    robotlink::assign(*times_.mutable_timestamp(), at(time));
    times_.set_clock_stands(clockStands);
  }
  MeasuredFrame& had(const char* package, double stamp, bool ofPlatform = false) {
    add(*times_.add_received(), package, stamp, ofPlatform);
    return *this;
  }
  MeasuredFrame& sent(const char* package, double stamp, double seconds, bool ofPlatform = false) {
    auto& added = *times_.add_sent();
    add(added, package, stamp, ofPlatform);
    added.set_seconds(seconds);
    return *this;
  }
  operator const StopwatchTimes&() const { return times_; }

 private:
  static void add(StopwatchTimes::Package& to, const char* package, double stamp, bool ofPlatform) {
    to.set_name(package);
    robotlink::assign(*to.mutable_timestamp(), at(stamp));
    to.set_of_platform(ofPlatform);
  }
  StopwatchTimes times_;
};

/// Cognition sees an image and sends what is wanted after 5 ms; motion obeys 8 ms later, within 1 ms.
void seeAndMove(LatencyTrace& trace, double time, bool clockStands = true) {
  trace.add(MeasuredFrame(time + 0.008, clockStands)
                .had("behavior/motion", time)
                .had("joints/states", time + 0.008, true)
                .sent("joints/request", time + 0.008, 0.001, true));
  trace.add(
      MeasuredFrame(time, clockStands).had("camera/image", time, true).sent("behavior/motion", time, 0.005));
}

std::vector<Latency> ofImages(std::vector<Latency> all) {
  std::erase_if(all, [](const Latency& latency) { return latency.reading != "camera/image"; });
  return all;
}

TEST(LatencyTraceTest, anImageIsFollowedThroughProcessesToTheCommand) {
  LatencyTrace trace;
  seeAndMove(trace, 1);
  EXPECT_TRUE(trace.take().empty()) << "another process may still report what it did";
  seeAndMove(trace, 2);
  const auto known = trace.take();
  const auto images = ofImages(known);
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].command, "joints/request");
  EXPECT_NEAR(images[0].waiting, 0.008, 1e-9);
  EXPECT_NEAR(images[0].computing, 0.006, 1e-9) << "in lockstep, that of both processes";
  EXPECT_EQ(known.size(), 2U) << "joint states became a command, too";
}

TEST(LatencyTraceTest, whereTheClockGoesOnOnlyTheLastProcessComputesBeyondIt) {
  LatencyTrace trace;
  seeAndMove(trace, 1, false);
  seeAndMove(trace, 2, false);
  const auto images = ofImages(trace.take());
  ASSERT_EQ(images.size(), 1U);
  EXPECT_NEAR(images[0].total(), 0.009, 1e-9);
}

TEST(LatencyTraceTest, onlyTheFirstCommandThatIsBasedOnAnImageCounts) {
  LatencyTrace trace;
  seeAndMove(trace, 1);
  for (const double later : {1.016, 1.024}) {
    trace.add(MeasuredFrame(later).had("behavior/motion", 1).sent("joints/request", later, 0.001, true));
  }
  seeAndMove(trace, 2);
  EXPECT_EQ(ofImages(trace.take()).size(), 1U);
}

TEST(LatencyTraceTest, processesThatExchangePackagesBothWaysAreNoEndlessLoop) {
  LatencyTrace trace;
  trace.add(MeasuredFrame(1).had("a", 1).sent("b", 1, 0.001, true));
  trace.add(MeasuredFrame(1).had("b", 1).had("camera/image", 1, true).sent("a", 1, 0.001));
  trace.add(MeasuredFrame(3));
  EXPECT_EQ(ofImages(trace.take()).size(), 1U);
}

TEST(LatencyTraceTest, commandsThatNoImageLedToAreNotMeasured) {
  LatencyTrace trace;
  trace.add(MeasuredFrame(1).had("remote/motion", 0.5).sent("joints/request", 1, 0.001, true));
  trace.add(MeasuredFrame(3));
  EXPECT_TRUE(trace.take().empty());
}

TEST(LatencyTraceTest, afterTheClockWentBackItBeginsAnew) {
  LatencyTrace trace;
  seeAndMove(trace, 100);
  seeAndMove(trace, 101);
  EXPECT_EQ(ofImages(trace.take()).size(), 1U);
  seeAndMove(trace, 1);
  seeAndMove(trace, 2);
  EXPECT_EQ(ofImages(trace.take()).size(), 1U);
}

}  // namespace
}  // namespace widgets
