// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugContext.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"

using namespace robotlink;
using robotcontrol::KeyMode;
using namespace std::chrono_literals;

namespace {

const ImageDrawingKey kShapeKey{"context-test/shape", "A key of this test"};
const ImageDrawingKey kOtherKey{"context-test/other", "Another key of this test"};
const FieldDrawingKey kPlaceKey{"context-test/place", "A place in the field"};
const RobotDrawingKey kAroundKey{"context-test/around", "Something around the robot"};
const ImageKey kPictureKey{"context-test/picture", "An image"};
const PlotKey kCurveKey{"context-test/curve", "A curve"};

KeyMode mode(KeyMode::Kind kind, std::uint32_t n = 0) {
  KeyMode result;
  result.set_kind(kind);
  result.set_n(n);
  return result;
}

class DebugContextTest : public testing::Test {
 protected:
  void frame(const std::function<void()>& body = [] {}) {
    debug_.beginFrame(clock_.now(), ++number_);
    body();
    debug_.endFrame();
    clock_.advance(40ms);
  }
  /// How often the key was on in so many calls, as a row of 0 and 1.
  std::string calls(int count) {
    std::string row;
    for (int i = 0; i < count; ++i) row += debug_.on(kShapeKey) ? '1' : '0';
    return row;
  }
  /// What the context published since the last call, in the form that leaves the program.
  static robotcontrol::DebugQueue take(DebugContext& debug) { return toWire(*debug.takeQueue()); }
  static std::vector<std::string> paths(const robotcontrol::DebugQueue& queue) {
    std::vector<std::string> result;
    for (const auto& message : queue.messages()) result.push_back(message.path());
    return result;
  }

  ManualClock clock_;
  DebugContext debug_{"cognition", clock_, {}};
  std::uint64_t number_ = 0;
};

using Paths = std::vector<std::string>;

}  // namespace

TEST_F(DebugContextTest, aKeyIsOffUntilItIsSwitchedOn) {
  EXPECT_EQ(calls(3), "000");
  debug_.setMode(kShapeKey.index(), mode(KeyMode::ALWAYS));
  EXPECT_EQ(calls(3), "111");
  EXPECT_FALSE(debug_.on(kOtherKey));
  debug_.setMode(kShapeKey.index(), mode(KeyMode::OFF, 5));
  EXPECT_EQ(calls(3), "000");
  EXPECT_EQ(debug_.mode(kShapeKey.index()).n(), 0U);
}

TEST_F(DebugContextTest, nTimesIsTrueNTimesAndThenOff) {
  debug_.setMode(kShapeKey.index(), mode(KeyMode::N_TIMES, 3));
  EXPECT_EQ(calls(5), "11100");
  EXPECT_EQ(debug_.mode(kShapeKey.index()).kind(), KeyMode::OFF);
  EXPECT_EQ(debug_.mode(kShapeKey.index()).n(), 3U)
      << "so that it can be distinguished from one that was switched off";
  debug_.setMode(kShapeKey.index(), mode(KeyMode::N_TIMES, 1));
  EXPECT_EQ(calls(3), "100");
  debug_.setMode(kShapeKey.index(), mode(KeyMode::N_TIMES, 0));
  EXPECT_EQ(calls(2), "00");
}

TEST_F(DebugContextTest, everyNIsTrueAtEachNthCall) {
  debug_.setMode(kShapeKey.index(), mode(KeyMode::EVERY_N, 3));
  EXPECT_EQ(calls(7), "0010010");
  debug_.setMode(kShapeKey.index(), mode(KeyMode::EVERY_N, 3));
  EXPECT_EQ(calls(3), "001") << "a new request counts from zero";
  debug_.setMode(kShapeKey.index(), mode(KeyMode::EVERY_N, 0));
  EXPECT_EQ(calls(2), "11");
}

TEST_F(DebugContextTest, everyMsIsTrueAtFirstAndThenAtLeastThatFarApart) {
  debug_.setMode(kShapeKey.index(), mode(KeyMode::EVERY_MS, 100));
  std::string row;
  for (int i = 0; i < 7; ++i) frame([&] { row += calls(1); });  // 40 ms apart
  EXPECT_EQ(row, "1001001");
  clock_.set(Instant{});  // the simulation was reset
  frame([&] { EXPECT_EQ(calls(2), "10"); });
}

TEST_F(DebugContextTest, twoContextsShareNoCounters) {
  DebugContext other("motion", clock_, {});
  other.setMode(kShapeKey.index(), mode(KeyMode::N_TIMES, 1));
  debug_.setMode(kShapeKey.index(), mode(KeyMode::N_TIMES, 1));
  EXPECT_TRUE(other.on(kShapeKey));
  EXPECT_TRUE(debug_.on(kShapeKey));
  EXPECT_FALSE(debug_.on(kShapeKey));
}

TEST_F(DebugContextTest, modesAndKeysThatDoNotExistAreIgnored) {
  debug_.setMode(-1, mode(KeyMode::ALWAYS));
  debug_.setMode(1 << 20, mode(KeyMode::ALWAYS));
  debug_.setMode(kShapeKey.index(), mode(static_cast<KeyMode::Kind>(77)));
  EXPECT_EQ(calls(2), "00");
  EXPECT_EQ(debug_.mode(-1).kind(), KeyMode::OFF);
}

TEST_F(DebugContextTest, aFrameIsHandedOverWholeAndEndsWithItsNumber) {
  debug_.beginFrame(Instant(3s), 7);
  debug_.text(Level::kWarning, "ball-percept", "no ball");
  EXPECT_FALSE(debug_.hasQueue());
  debug_.endFrame();
  ASSERT_TRUE(debug_.hasQueue());
  const auto queue = take(debug_);
  EXPECT_FALSE(debug_.hasQueue());
  ASSERT_EQ(paths(queue), (Paths{"log", "frames/cognition"}));
  EXPECT_EQ(queue.process(), "cognition");
  const foxglove::Log& log = queue.messages(0).text();
  EXPECT_EQ(log.message(), "no ball");
  EXPECT_EQ(log.name(), "cognition/ball-percept");
  EXPECT_EQ(log.level(), foxglove::Log::WARNING);
  EXPECT_EQ(instant(log.timestamp()), Instant(3s));
  EXPECT_EQ(instant(queue.messages(0).timestamp()), Instant(3s));
  EXPECT_EQ(queue.messages(1).frame().number(), 7U);
  EXPECT_EQ(queue.messages(1).frame().process(), "cognition");
}

TEST_F(DebugContextTest, eachKindGoesToItsStream) {
  debug_.setRobot("red1");
  const Image gray(4, 2, PixelFormat::kMono8);
  frame([&] {
    debug_.imageDrawing(kShapeKey).line({0, 0}, {1, 1}, colors::kRed);
    debug_.fieldDrawing(kPlaceKey).dot({1, 0}, colors::kRed);
    debug_.robotDrawing(kAroundKey).dot({1, 0}, colors::kRed);
    debug_.image(kPictureKey, gray.view());
    debug_.plot(kCurveKey, 4.5, "m");
    debug_.plot(kCurveKey, "x", 2);
    debug_.package("models/ball", std::make_shared<KeyMode>(mode(KeyMode::EVERY_N, 9)));
  });
  const auto queue = take(debug_);
  EXPECT_EQ(paths(queue), (Paths{"drawings/image/context-test/shape", "drawings/field/context-test/place",
                                 "drawings/robot/context-test/around", "images/context-test/picture",
                                 "plots/context-test/curve", "plots/context-test/curve/x", "models/ball",
                                 "frames/cognition"}));
  EXPECT_EQ(queue.messages(1).scene_drawing().entities(0).frame_id(), "field");
  EXPECT_EQ(queue.messages(1).scene_drawing().entities(0).id(), "context-test/place");
  EXPECT_EQ(queue.messages(2).scene_drawing().entities(0).frame_id(), "red1");
  EXPECT_EQ(imageView(queue.messages(3).image()).width, 4);
  EXPECT_EQ(queue.messages(4).plot().value(), 4.5);
  EXPECT_EQ(queue.messages(4).plot().unit(), "m");
  EXPECT_EQ(queue.messages(6).package().type(), "robotcontrol.KeyMode");
  KeyMode copy;
  ASSERT_TRUE(copy.ParseFromString(queue.messages(6).package().data()));
  EXPECT_EQ(copy.n(), 9U);
}

TEST_F(DebugContextTest, allShapesOfAKeyInAFrameAreOneDrawing) {
  frame([&] {
    debug_.imageDrawing(kShapeKey).circle({0, 0}, 1, colors::kRed);
    debug_.imageDrawing(kOtherKey).circle({0, 0}, 1, colors::kRed);
    debug_.imageDrawing(kShapeKey).circle({5, 5}, 1, colors::kRed);
  });
  frame([&] { debug_.imageDrawing(kShapeKey).circle({0, 0}, 1, colors::kRed); });
  const auto queue = take(debug_);
  ASSERT_EQ(queue.messages_size(), 5);
  EXPECT_EQ(queue.messages(0).image_drawing().circles_size(), 2);
  EXPECT_EQ(queue.messages(1).image_drawing().circles_size(), 1);
  EXPECT_EQ(queue.messages(3).image_drawing().circles_size(), 1);
}

TEST_F(DebugContextTest, aDrawingThatIsBegunIsSentEvenIfItIsEmpty) {
  frame([&] {
    debug_.imageDrawing(kShapeKey);
    debug_.fieldDrawing(kPlaceKey);
  });
  const auto queue = take(debug_);
  ASSERT_EQ(queue.messages_size(), 3);
  EXPECT_TRUE(queue.messages(0).has_image_drawing());
  EXPECT_EQ(queue.messages(1).scene_drawing().entities_size(), 1);
}

TEST_F(DebugContextTest, ofAnImageOnlyTheLastOfAFrameIsSent) {
  const Image small(2, 2, PixelFormat::kMono8), large(8, 2, PixelFormat::kMono8);
  frame([&] {
    debug_.image(kPictureKey, small.view());
    debug_.image(kPictureKey, large.view());
    debug_.image(kPictureKey, ImageView{});
  });
  const auto queue = take(debug_);
  ASSERT_EQ(queue.messages_size(), 2);
  EXPECT_EQ(imageView(queue.messages(0).image()).width, 8);
}

TEST_F(DebugContextTest, whatDoesNotFitIsDroppedByWholeFramesOldestFirst) {
  DebugContext debug("motion", clock_, {.maxQueueBytes = 1000});
  for (std::uint64_t i = 1; i <= 5; ++i) {
    debug.beginFrame(clock_.now(), i);
    debug.text(Level::kInfo, "walk", std::string(300, 'x'));
    debug.endFrame();
  }
  EXPECT_EQ(debug.dropped(), 6U) << "three frames of a text and an end";
  const auto queue = take(debug);
  ASSERT_EQ(queue.messages_size(), 4);
  EXPECT_EQ(queue.messages(1).frame().number(), 4U);
  EXPECT_EQ(queue.messages(3).frame().number(), 5U);
  EXPECT_EQ(queue.dropped(), 6U);
}

TEST_F(DebugContextTest, aFrameThatIsTooLargeAloneIsDroppedAndTheNextOneIsNot) {
  DebugContext debug("motion", clock_, {.maxQueueBytes = 1000});
  debug.beginFrame(clock_.now(), 1);
  debug.text(Level::kInfo, "walk", std::string(3000, 'x'));
  debug.endFrame();
  EXPECT_FALSE(debug.hasQueue());
  debug.beginFrame(clock_.now(), 2);
  debug.endFrame();
  EXPECT_EQ(take(debug).messages_size(), 1);
  EXPECT_EQ(debug.dropped(), 2U);
}

TEST_F(DebugContextTest, whatIsPublishedOutsideAFrameBelongsToTheNext) {
  debug_.text(Level::kError, "solutions", "refused");
  EXPECT_FALSE(debug_.hasQueue());
  frame();
  EXPECT_EQ(paths(take(debug_)), (Paths{"log", "frames/cognition"}));
}

TEST_F(DebugContextTest, aTextThatIsNotUtf8IsMadeSo) {
  frame([&] { debug_.text(Level::kInfo, "files", "caf\xe9 \xc3\xa9 \xed\xa0\x80."); });
  const auto queue = take(debug_);
  EXPECT_EQ(queue.messages(0).text().message(), "caf? \xc3\xa9 ???.");
  robotcontrol::DebugQueue copy;
  EXPECT_TRUE(copy.ParseFromString(queue.SerializeAsString()));
}
