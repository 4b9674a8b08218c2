// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/MessageChange.h"

#include <gtest/gtest.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/robotlink/packages/ForeignTime.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;

TEST(MessageChange, allTimesInAMessageAreMoved) {
  MessageChange change(-1500ms, {});
  foxglove::SceneUpdate scene;
  robotlink::assign(*scene.add_entities()->mutable_timestamp(), Instant(3s));
  robotlink::assign(*scene.add_entities()->mutable_timestamp(), Instant(2200ms));
  scene.add_entities();
  change.apply(scene);
  EXPECT_EQ(robotlink::instant(scene.entities(0).timestamp()), Instant(1500ms));
  EXPECT_EQ(robotlink::instant(scene.entities(1).timestamp()), Instant(700ms));
  EXPECT_FALSE(scene.entities(2).has_timestamp());
}

TEST(MessageChange, framesOfReferenceAndRobotsGetTheirNewNames) {
  MessageChange change(0s, {{"red1", "red1-2"}});
  foxglove::RawImage image;
  image.set_frame_id("red1/camera");
  image.set_encoding("red1");
  change.apply(image);
  EXPECT_EQ(image.frame_id(), "red1-2/camera");
  EXPECT_EQ(image.encoding(), "red1") << "not every text is a name";
  foxglove::SceneUpdate scene;
  scene.add_entities()->set_frame_id("red1");
  scene.add_entities()->set_frame_id("red11");
  scene.add_entities()->set_frame_id("field");
  change.apply(scene);
  EXPECT_EQ(scene.entities(0).frame_id(), "red1-2");
  EXPECT_EQ(scene.entities(1).frame_id(), "red11");
  EXPECT_EQ(scene.entities(2).frame_id(), "field");
  robotcontrol::ProgramSetup setup;
  setup.set_robot("red1");
  change.apply(setup);
  EXPECT_EQ(setup.robot(), "red1-2");
}

TEST(MessageChange, onlyTypesWithSuchFieldsAreConcerned) {
  EXPECT_FALSE(MessageChange().concerns(*foxglove::RawImage::descriptor()));
  MessageChange change(1s, {});
  EXPECT_TRUE(change.concerns(*foxglove::RawImage::descriptor()));
  EXPECT_TRUE(change.concerns(*foxglove::SceneUpdate::descriptor()));
  EXPECT_FALSE(change.concerns(*robotcontrol::KeyTable::descriptor()));
}

TEST(MessageChange, aTimeThatCannotBeMovedStaysAsItIs) {
  MessageChange change(1s, {});
  foxglove::RawImage image;
  image.mutable_timestamp()->set_seconds(std::numeric_limits<std::int64_t>::max());
  change.apply(image);
  EXPECT_EQ(image.timestamp().seconds(), std::numeric_limits<std::int64_t>::max());
}

TEST(MessageChange, aForeignTypeThatIsOnlyCalledTimestampIsNotMoved) {
  robotlink::test::ForeignTime foreign;
  MessageChange change(1s, {});
  EXPECT_FALSE(change.concerns(*foreign.message().GetDescriptor()));
  change.apply(foreign.message());
  EXPECT_EQ(foreign.message().ShortDebugString(), "stamp { }");
}

}  // namespace
}  // namespace logplayer
