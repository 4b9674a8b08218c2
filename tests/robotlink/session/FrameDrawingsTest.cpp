// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/FrameDrawings.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"

using namespace robotlink;
using robotcontrol::DebugQueue;
using robotcontrol::KeyMode;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Instant instantAt(double time) {
  return Instant(fromSeconds(time));
}

class FrameDrawingsTest : public testing::Test {
 protected:
  using Names = std::vector<std::string>;

  // A frame of a process in which these drawings were sent; its number grows with each.
  void frame(const std::string& process, double time, const Names& drawings) {
    const auto queue = std::make_shared<DebugQueue>();
    queue->set_process(process);
    for (const std::string& name : drawings) {
      add(*queue, "drawings/image/" + name, time).mutable_image_drawing();
    }
    auto& info = *add(*queue, "frames/" + process, time).mutable_frame();
    info.set_process(process);
    info.set_number(++number_);
    session_.pushQueue("red1", robotlink::fromWire(*queue));
    session_.tick();
  }
  void mode(double time, const std::string& key, KeyMode::Kind kind, std::uint32_t n = 0) {
    const auto queue = std::make_shared<DebugQueue>();
    auto& entry = *add(*queue, "tables/keys", time).mutable_keys()->add_keys();
    entry.set_name(key);
    entry.mutable_mode()->set_kind(kind);
    entry.mutable_mode()->set_n(n);
    session_.pushQueue("red1", robotlink::fromWire(*queue));
    session_.tick();
  }
  static robotcontrol::DebugMessage& add(DebugQueue& queue, const std::string& path, double time) {
    auto& message = *queue.add_messages();
    message.set_path(path);
    assign(*message.mutable_timestamp(), instantAt(time));
    return message;
  }
  Names shown(double time) {
    Names names;
    const std::string prefix = drawingPrefix("red1", DrawingKind::kImage);
    for (const auto* drawing :
         currentDrawings(session_.store(), "red1", DrawingKind::kImage, instantAt(time))) {
      names.push_back(drawing->path.substr(prefix.size()));
    }
    return names;
  }

  Session session_;
  std::uint64_t number_ = 0;
};

}  // namespace

TEST_F(FrameDrawingsTest, aFramesDrawingsAppearAndDisappearTogether) {
  frame("cognition", 1, {"a", "b"});
  frame("cognition", 2, {"b", "c"});
  EXPECT_THAT(shown(0.9), IsEmpty());
  EXPECT_THAT(shown(1.5), ElementsAre("a", "b"));
  EXPECT_THAT(shown(2), ElementsAre("b", "c"));
  frame("cognition", 3, {});
  EXPECT_THAT(shown(3), IsEmpty());
  EXPECT_THAT(shown(2.9), ElementsAre("b", "c")) << "looking back shows what was shown then";
}

TEST_F(FrameDrawingsTest, processesDoNotHideEachOthersDrawings) {
  frame("cognition", 1, {"a"});
  frame("motion", 1.1, {"m"});
  frame("motion", 1.2, {"m"});
  EXPECT_THAT(shown(1.2), ElementsAre("a", "m"));
  frame("cognition", 1.2, {});
  EXPECT_THAT(shown(1.2), ElementsAre("m"));
}

TEST_F(FrameDrawingsTest, whatIsNotDrawnInEveryFrameStaysUntilTheNext) {
  mode(0, "a", KeyMode::EVERY_N, 10);
  frame("cognition", 1, {"a"});
  frame("cognition", 2, {});
  EXPECT_THAT(shown(2), ElementsAre("a"));
  mode(2.5, "a", KeyMode::ALWAYS);
  EXPECT_THAT(shown(2), ElementsAre("a"));
  EXPECT_THAT(shown(2.5), IsEmpty());
}

TEST_F(FrameDrawingsTest, whatStaysIsNotOfTheLatestFrame) {
  mode(0, "a", KeyMode::EVERY_N, 10);
  frame("cognition", 1, {"a", "b"});
  const auto isOld = [&](double time) {
    const auto drawings = currentDrawings(session_.store(), "red1", DrawingKind::kImage, instantAt(time));
    return drawings.empty() || !isOfLatestFrame(session_.store(), "red1", *drawings.front(), instantAt(time));
  };
  EXPECT_FALSE(isOld(1));
  frame("motion", 1.5, {});
  EXPECT_FALSE(isOld(1.5)) << "another process has frames of its own";
  frame("cognition", 2, {});
  EXPECT_TRUE(isOld(2));
  EXPECT_FALSE(isOld(1.9)) << "looking back shows what was new then";
}

TEST_F(FrameDrawingsTest, theLastOfNTimesStaysButWhatIsSwitchedOffGoes) {
  mode(0, "a", KeyMode::N_TIMES, 1);
  frame("cognition", 1, {"a"});
  mode(1, "a", KeyMode::OFF, 1);  // its one time is over
  frame("cognition", 2, {});
  EXPECT_THAT(shown(2), ElementsAre("a"));
  mode(3, "a", KeyMode::OFF);
  EXPECT_THAT(shown(3), IsEmpty());
}

TEST_F(FrameDrawingsTest, messagesThatDoNotKnowTheirFrameAreMatchedByTime) {
  const auto plain = [](const std::string& path, double time, const PackagePtr& value) {
    return StreamMessage{path, instantAt(time), value};
  };
  StreamStore store({});
  const auto drawing = std::make_shared<robotcontrol::FrameInfo>();  // of any type
  store.add(plain("red1/drawings/image/a", 1, drawing));
  EXPECT_EQ(currentDrawings(store, "red1", DrawingKind::kImage, instantAt(9)).size(), 1U)
      << "nobody says when frames end";
  store.add(plain("red1/frames/cognition", 1, std::make_shared<robotcontrol::FrameInfo>()));
  EXPECT_EQ(currentDrawings(store, "red1", DrawingKind::kImage, instantAt(1)).size(), 1U);
  store.add(plain("red1/frames/cognition", 2, std::make_shared<robotcontrol::FrameInfo>()));
  EXPECT_EQ(currentDrawings(store, "red1", DrawingKind::kImage, instantAt(2)).size(), 0U);
}

TEST_F(FrameDrawingsTest, kindsAndRobotsAreDistinguished) {
  frame("cognition", 1, {"ball-percept/circle", "lines"});
  const auto drawn = [&](const std::string& robot, DrawingKind kind) {
    return currentDrawings(session_.store(), robot, kind, Instant::max()).size();
  };
  EXPECT_EQ(drawn("red1", DrawingKind::kImage), 2U);
  EXPECT_EQ(drawn("red1", DrawingKind::kField), 0U);
  EXPECT_EQ(drawn("red11", DrawingKind::kImage), 0U);
  EXPECT_EQ(drawingPrefix("red1", DrawingKind::kField), "red1/drawings/field/");
  EXPECT_EQ(drawingPrefix("red1", DrawingKind::kRobot), "red1/drawings/robot/");
}
