// SPDX-License-Identifier: GPL-3.0-or-later
// Which drawings belong to the present frame, of a hosted robot and of the same one at the end of a link.
#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/FrameDrawings.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::DebugQueue;
using robotcontrol::KeyMode;

Instant instantAt(double time) {
  return Instant(fromSeconds(time));
}

/// Everything that comes into one session goes to the other one, as over a link.
class RemoteDrawingsTest : public testing::Test {
 protected:
  RemoteDrawingsTest() {
    hosted_.setRobots({"red1"});
    remote_.onConnected({"", {}, {}, {{kSessionKey, "1"}}, "1", {}, {}});
    remote_.robots.add("red1", "red1");
    hosted_.addListener(
        {[this](const StreamMessage& message) {
           const std::string type = message.value->GetDescriptor()->full_name();
           const Channel channel{1, message.path, "protobuf", type, "", "protobuf"};
           remote_.onMessage({std::make_shared<RemoteChannel>(channel), message.time, message.value, 0, {}});
         },
         {}});
  }
  /// The keys of a process, or with an empty name of all of them together.
  void keys(const std::string& process, const std::vector<std::string>& names) {
    DebugQueue queue;
    auto& table = *add(queue, "tables/keys" + (process.empty() ? "" : "/" + process), 0).mutable_keys();
    for (const std::string& name : names) {
      auto& key = *table.add_keys();
      key.set_name(name);
      key.set_stream("drawings/image/" + name);
      key.mutable_mode()->set_kind(KeyMode::EVERY_N);
      key.mutable_mode()->set_n(10);
    }
    push(queue);
  }
  /// A frame of a process in which these drawings were made.
  void frame(const std::string& process, double time, const std::vector<std::string>& drawings) {
    DebugQueue queue;
    queue.set_process(process);
    for (const std::string& name : drawings)
      add(queue, "drawings/image/" + name, time).mutable_image_drawing();
    auto& info = *add(queue, "frames/" + process, time).mutable_frame();
    info.set_process(process);
    info.set_number(++number_);
    push(queue);
  }
  /// The drawings that are shown at a time, with a mark at those of earlier frames.
  static std::string shown(Session& session, double time) {
    std::string text;
    for (const auto* drawing : currentDrawings(session.store(), "red1", DrawingKind::kImage, instantAt(time)))
      text += drawing->path.substr(drawing->path.rfind('/') + 1) +
              (isOfLatestFrame(session.store(), "red1", *drawing, instantAt(time)) ? " " : "(old) ");
    return text;
  }

  Session hosted_, far_;
  RemoteSession remote_{far_, {}};

 private:
  static robotcontrol::DebugMessage& add(DebugQueue& queue, const std::string& path, double time) {
    auto& message = *queue.add_messages();
    message.set_path(path);
    assign(*message.mutable_timestamp(), instantAt(time));
    return message;
  }
  void push(const DebugQueue& queue) {
    hosted_.pushQueue("red1", fromWire(queue));
    hosted_.tick();
    far_.tick();
  }

  std::uint64_t number_ = 0;
};

TEST_F(RemoteDrawingsTest, areOldWhenTheirProcessHasGoneOn) {
  keys("cognition", {"ball", "goal"});
  keys("motion", {"feet"});
  keys("", {"ball", "feet", "goal"});
  frame("cognition", 1, {"ball", "goal"});
  frame("motion", 1, {"feet"});
  frame("cognition", 2, {"goal"});
  // The other process goes on later, and its last frame has the time of the first drawings.
  EXPECT_EQ(shown(hosted_, 2), "ball(old) feet goal ");
  EXPECT_EQ(shown(far_, 2), shown(hosted_, 2));
  EXPECT_EQ(shown(far_, 1), shown(hosted_, 1));
  frame("motion", 3, {});
  EXPECT_EQ(shown(far_, 3), shown(hosted_, 3));
}

TEST_F(RemoteDrawingsTest, areMatchedByTimeWhereTheirProcessIsNotKnown) {
  keys("", {"ball"});
  frame("cognition", 1, {"ball"});
  EXPECT_EQ(shown(far_, 1), "ball ");
  // Two processes have the key.
  keys("cognition", {"ball"});
  keys("motion", {"ball"});
  frame("cognition", 2, {"ball"});
  frame("motion", 2.5, {});
  EXPECT_EQ(shown(far_, 2.5), shown(hosted_, 2.5));
}

TEST_F(RemoteDrawingsTest, followTheirKeyIntoTheProcessOfAnotherLayout) {
  keys("cognition", {"ball"});
  keys("", {"ball"});
  frame("cognition", 1, {"ball"});
  const auto processes = std::make_shared<robotcontrol::ProcessTable>();
  processes->add_processes()->set_name("perception");
  hosted_.push({"red1/tables/processes", instantAt(2), processes});
  keys("perception", {"ball"});
  frame("perception", 3, {"ball"});
  EXPECT_EQ(shown(far_, 3), shown(hosted_, 3));
  EXPECT_EQ(far_.store().latest("red1/drawings/image/ball", instantAt(3))->process, "perception");
}

}  // namespace
}  // namespace robotlink::websocket
