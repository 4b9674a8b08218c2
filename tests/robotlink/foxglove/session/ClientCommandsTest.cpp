// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ClientCommands.h"

#include <gmock/gmock.h>

#include "robotcontrol/Requests.pb.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::MotionRequest;
using testing::HasSubstr;

ClientChannel channel(const std::string& topic, const std::string& encodedAs = "json",
                      const std::string& schemaName = {}) {
  return {1, topic, encodedAs, schemaName, {}, {}};
}

TEST(ClientCommands, motionsAreJsonOrSerialized) {
  const auto read = commandOf(channel("red1/remote/motion"),
                              R"({"motion": {"kind": "WALK", "walk": {"x": 0.1, "rotation": -1}}})");
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->robot(), "red1");
  EXPECT_EQ(read->motion().motion().kind(), MotionRequest::WALK);
  const std::string bytes = read->motion().SerializeAsString();
  const auto same = commandOf(channel("red1/remote/motion", "protobuf", "robotcontrol.RemoteMotion"), bytes);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->SerializeAsString(), read->SerializeAsString());
}

TEST(ClientCommands, aVelocityIsAMotionAndZeroIsToStand) {
  const auto drives = commandOf(channel("p3at1/remote/drive"), R"({"velocity": {"x": 0.2}})");
  ASSERT_TRUE(drives);
  EXPECT_EQ(drives->motion().motion().kind(), MotionRequest::WALK);
  EXPECT_EQ(drives->motion().motion().walk().x(), 0.2);
  EXPECT_EQ(commandOf(channel("p3at1/remote/drive"), "{}")->motion().motion().kind(), MotionRequest::STAND);
}

TEST(ClientCommands, aGoalIsOne) {
  const auto goal = commandOf(channel("p3at1/remote/goal"), R"({"pose_in_field": {"x": 1}})");
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->set_goal().pose_in_field().x(), 1);
}

TEST(ClientCommands, whatCannotBeTakenIsSaid) {
  const auto problem = [](const ClientChannel& on, const std::string& payload) {
    const auto read = commandOf(on, payload);
    return read ? "none" : read.error().text;
  };
  EXPECT_THAT(problem(channel("/chatter"), "{}"), HasSubstr("ROBOT/remote/drive"));
  EXPECT_THAT(problem(channel("remote/motion"), "{}"), HasSubstr("nothing receives"));
  EXPECT_THAT(problem(channel("red1/remote/motion", "protobuf", "a.B"), ""), HasSubstr("a.B"));
  EXPECT_THAT(problem(channel("red1/remote/motion", "protobuf"), "\xff"), HasSubstr("no robotcontrol."));
  EXPECT_THAT(problem(channel("red1/remote/motion"), "{"), HasSubstr("no robotcontrol."));
  EXPECT_THAT(problem(channel("red1/remote/drive"), R"({"velocity": {"x": "NaN"}})"),
              HasSubstr("not numbers"));
  EXPECT_THAT(problem(channel("red1/remote/motion"), R"({"motion": {"kind": 99}})"),
              HasSubstr("no such kind"));
}

}  // namespace
}  // namespace robotlink::websocket
