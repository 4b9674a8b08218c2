// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/requests/WorldRequests.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "robotcontrol/Requests.pb.h"

namespace robotlink {
namespace {

using robotcontrol::ControlSnapshots;
using robotcontrol::Request;
using testing::HasSubstr;

const double kNotANumber = std::nan("");
constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(WorldRequests, aModelIsTurnedByAnyAnglesThatAreNumbers) {
  Request request;
  auto& turn = *request.mutable_turn_model();
  EXPECT_EQ(wrongTurn(request), "the request must name the model to turn");
  turn.set_model("ball");
  turn.set_heading(1000);
  EXPECT_EQ(wrongTurn(request), "");
  turn.set_roll(kNotANumber);
  EXPECT_THAT(wrongTurn(request), HasSubstr("not all numbers"));
  turn.set_roll(0);
  turn.set_pitch(-kEndless);
  EXPECT_THAT(wrongTurn(request), HasSubstr("not all numbers"));
}

TEST(WorldRequests, speedsOfAThrownModelHaveLimitsInEachDirection) {
  Request request;
  auto& thrown = *request.mutable_throw_model();
  thrown.set_model("ball");
  for (const double bad : {100.1, -100.1, kNotANumber, kEndless}) {
    thrown.mutable_velocity()->set_y(bad);
    EXPECT_THAT(wrongThrow(request), HasSubstr("at most 100 m/s")) << bad;
  }
  thrown.mutable_velocity()->set_y(-100);
  EXPECT_EQ(wrongThrow(request), "") << "the limit itself is allowed";
  thrown.mutable_spin()->set_x(-1001);
  EXPECT_THAT(wrongThrow(request), HasSubstr("at most 1000 rad/s"));
}

TEST(WorldRequests, whatIsPinnedHasAName) {
  Request request;
  request.mutable_pin_object();
  EXPECT_NE(wrongPin(request), "");
  request.mutable_pin_object()->set_path("red1/link:head");
  EXPECT_EQ(wrongPin(request), "");
}

TEST(WorldRequests, lettingGoNeedsNothing) {
  Request request;
  auto& drag = *request.mutable_drag_object();
  EXPECT_THAT(wrongDrag(request), HasSubstr("must name"));
  drag.mutable_target()->set_x(kNotANumber);
  drag.set_released(true);
  EXPECT_EQ(wrongDrag(request), "");
}

TEST(WorldRequests, aHandReachesFarButNotAnywhereAndHasAStrength) {
  Request request;
  auto& drag = *request.mutable_drag_object();
  drag.set_path("ball");
  drag.mutable_grip()->set_z(10'001);
  EXPECT_THAT(wrongDrag(request), HasSubstr("too far away"));
  drag.mutable_grip()->set_z(-10'000);
  EXPECT_EQ(wrongDrag(request), "") << "without a strength it has the usual one";
  for (const double bad : {0.009, 101.0, -1.0, kNotANumber}) {
    drag.set_strength(bad);
    EXPECT_THAT(wrongDrag(request), HasSubstr("between 0.01 and 100")) << bad;
  }
  for (const double good : {0.01, 100.0}) {
    drag.set_strength(good);
    EXPECT_EQ(wrongDrag(request), "") << good;
  }
}

TEST(WorldRequests, aPushHasAForceAPlaceAndATime) {
  Request request;
  auto& push = *request.mutable_push_object();
  EXPECT_THAT(wrongPush(request), HasSubstr("must name"));
  push.set_path("ball");
  EXPECT_EQ(wrongPush(request), "");
  push.mutable_force()->set_x(1.1e6);
  EXPECT_THAT(wrongPush(request), HasSubstr("1000000 N"));
  push.mutable_force()->set_x(-1e6);
  push.mutable_point()->set_y(kEndless);
  EXPECT_THAT(wrongPush(request), HasSubstr("too far away"));
  push.mutable_point()->set_y(0);
  for (const double bad : {-0.1, 60.1, kNotANumber}) {
    push.set_seconds(bad);
    EXPECT_THAT(wrongPush(request), HasSubstr("60 s")) << bad;
  }
}

TEST(WorldRequests, forcesAreReadForAWhile) {
  Request request;
  auto& reading = *request.mutable_read_forces();
  EXPECT_EQ(wrongForceReading(request), "") << "0 s ends it";
  for (const double bad : {-1.0, 61.0, kNotANumber}) {
    reading.set_seconds(bad);
    EXPECT_THAT(wrongForceReading(request), HasSubstr("at most 60 s")) << bad;
  }
}

TEST(WorldRequests, goingBackTakesSomeTimeButNotForever) {
  Request request;
  ControlSnapshots& control = *request.mutable_control_snapshots();
  control.set_action(ControlSnapshots::REWIND);
  for (const double bad : {0.0, -1.0, 1.1e6, kNotANumber}) {
    control.set_seconds(bad);
    EXPECT_THAT(wrongSnapshots(request), HasSubstr("must be above 0")) << bad;
  }
  control.set_seconds(0.5);
  EXPECT_EQ(wrongSnapshots(request), "") << "it needs no name";
}

TEST(WorldRequests, aSnapshotOfAnUnknownActionOrALongNameIsRefused) {
  Request request;
  ControlSnapshots& control = *request.mutable_control_snapshots();
  control.set_action(static_cast<ControlSnapshots::Action>(77));
  control.set_name("a");
  EXPECT_THAT(wrongSnapshots(request), HasSubstr("no such action"));
  control.set_action(ControlSnapshots::RESTORE);
  EXPECT_EQ(wrongSnapshots(request), "");
  control.set_name(std::string(101, 'a'));
  EXPECT_THAT(wrongSnapshots(request), HasSubstr("too long"));
  control.set_name("");
  control.set_file("/tmp/a.snapshot");
  EXPECT_EQ(wrongSnapshots(request), "");
  EXPECT_EQ(fileOfSnapshot(request), "/tmp/a.snapshot");
}

}  // namespace
}  // namespace robotlink
