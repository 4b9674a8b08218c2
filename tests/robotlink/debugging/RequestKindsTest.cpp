// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/RequestKinds.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

using namespace robotlink;
using robotcontrol::KeyMode;
using robotcontrol::Request;
using ::testing::HasSubstr;

namespace {

Request keyRequest(const std::string& key, KeyMode::Kind kind = KeyMode::ALWAYS) {
  Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  return request;
}

Request solutionRequest(const std::string& task, const std::string& solution) {
  Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  return request;
}

}  // namespace

TEST(RequestKinds, everyKindOfRequestIsDeclaredOnce) {
  std::set<int> declared;
  for (const RequestKind& kind : requestKinds()) {
    EXPECT_TRUE(declared.insert(kind.what).second) << kind.words;
    EXPECT_NE(kind.doer, RequestDoer::kNobody) << kind.words;
    EXPECT_EQ(kind.task != nullptr, kind.doer == RequestDoer::kTask) << kind.words;
    EXPECT_TRUE(!kind.isOverride || (kind.subject != nullptr && kind.isOfProgram()))
        << kind.words << ": an override belongs to a program, and replaces the one before";
  }
  const auto* what = Request::descriptor()->FindOneofByName("what");
  ASSERT_NE(what, nullptr);
  EXPECT_EQ(declared.size(), static_cast<std::size_t>(what->field_count()));
  for (int i = 0; i < what->field_count(); ++i) {
    EXPECT_TRUE(declared.contains(what->field(i)->number())) << what->field(i)->name();
  }
}

TEST(RequestKinds, aRequestReadsAsWordsWithItsRobot) {
  EXPECT_EQ(inWords(keyRequest("motion/legs")), "set key of red1");
  EXPECT_EQ(inWords(solutionRequest("ball-percept", "region")), "select solution");
  EXPECT_EQ(inWords(Request()), "nothing");
  EXPECT_EQ(kindOf(Request()).doer, RequestDoer::kNobody);
}

TEST(RequestKinds, speedsHaveLimits) {
  Request replay, simulation;
  for (const double speed : {0.04, 51.0, std::numeric_limits<double>::quiet_NaN()}) {
    replay.mutable_control_replay()->set_speed(speed);
    EXPECT_EQ(wrongWith(replay), "the speed must be between 0.05 and 50 times real time");
  }
  replay.mutable_control_replay()->set_speed(50);
  EXPECT_EQ(wrongWith(replay), "");
  replay.mutable_control_replay()->clear_speed();
  EXPECT_EQ(wrongWith(replay), "");
  simulation.mutable_control_simulation()->set_speed(101);
  EXPECT_EQ(wrongWith(simulation), "the speed must be between 0 and 100 times real time");
  simulation.mutable_control_simulation()->set_speed(-1);
  EXPECT_EQ(wrongWith(simulation), "") << "the speed stays";
  simulation.mutable_control_simulation()->clear_speed();
  EXPECT_EQ(wrongWith(simulation), "") << "the speed stays";
}

TEST(RequestKinds, twoRequestsSetTheSameIfTheirSubjectIsTheSame) {
  EXPECT_TRUE(setTheSame(keyRequest("a"), keyRequest("a", KeyMode::OFF)));
  EXPECT_FALSE(setTheSame(keyRequest("a"), keyRequest("b")));
  EXPECT_TRUE(setTheSame(solutionRequest("ball", "one"), solutionRequest("ball", "other")));
  EXPECT_FALSE(setTheSame(solutionRequest("ball", "one"), keyRequest("ball")));
  Request motion;
  motion.mutable_motion();
  EXPECT_FALSE(setTheSame(motion, motion)) << "a motion sets nothing, each counts";
}

TEST(RequestKinds, whatIsWrongWithARequestItselfIsSaid) {
  EXPECT_THAT(wrongWith(keyRequest("no-such-key-anywhere")), HasSubstr("there is no debug key"));
  EXPECT_EQ(wrongWith(keyRequest("package/camera/image")), "");
  EXPECT_EQ(wrongWith(keyRequest("package/camera/image", KeyMode::EVERY_N)),
            "this mode of a debug key needs a number above 0");
  Request place;
  place.mutable_place_model()->mutable_pose_in_field()->set_x(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(wrongWith(place), "");
  place.mutable_place_model()->clear_pose_in_field();
  EXPECT_EQ(wrongWith(place), "the request needs the pose at which to place the model");
  place.mutable_place_model()->mutable_pose_in_field();
  EXPECT_EQ(wrongWith(place), "") << "the middle of the field";
  place.mutable_place_model()->set_roll(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(wrongWith(place), "");
  Request goal;
  goal.mutable_set_goal();
  EXPECT_EQ(wrongWith(goal), "the goal has no pose");
  goal.mutable_set_goal()->set_cancelled(true);
  EXPECT_EQ(wrongWith(goal), "");
  Request table;
  table.mutable_set_color_table();
  EXPECT_EQ(wrongWith(table), "") << "without cells it takes back the one before";
  table.mutable_set_color_table()->mutable_table()->set_cells("abc");
  EXPECT_EQ(wrongWith(table), "a color table has 262144 cells, this one has 3");
}

TEST(RequestKinds, whateverNamesAFileIsRefusedFromElsewhere) {
  const std::set<std::string> fileNames = {"path", "file", "folder", "directory", "url"};
  int named = 0;
  for (const RequestKind& kind : requestKinds()) {
    Request request;
    const auto* field = Request::descriptor()->FindFieldByNumber(kind.what);
    auto* details = Request::GetReflection()->MutableMessage(&request, field);
    EXPECT_EQ(wrongFromElsewhere(request), "") << kind.words;
    for (int i = 0; i < field->message_type()->field_count(); ++i) {
      const auto* one = field->message_type()->field(i);
      // The paths of these are those of objects of the scene.
      const bool isOfObject = kind.what == Request::kPinObject || kind.what == Request::kDragObject ||
                              kind.what == Request::kPushObject;
      if (isOfObject || !fileNames.contains(one->name())) continue;
      details->GetReflection()->SetString(details, one, "/tmp/evil");
      EXPECT_THAT(wrongFromElsewhere(request), HasSubstr("/tmp/evil")) << kind.words;
      ++named;
    }
  }
  EXPECT_GT(named, 0);
}

TEST(RequestKinds, whatAPersonChoseIsKeptForLaterProgramsAndCanBeNamed) {
  const RequestKind& solution = kindOf(solutionRequest("ball", "region"));
  EXPECT_TRUE(solution.isOverride);
  EXPECT_EQ(solution.choice(solutionRequest("ball", "region")), "solution region of task ball");
  Request stop;
  stop.mutable_stop();
  EXPECT_FALSE(kindOf(stop).isOverride);
  EXPECT_EQ(kindOf(stop).doer, RequestDoer::kPlatform);
}

TEST(RequestKinds, onlyARequestThatSaysSoReleasesStop) {
  Request stop;
  EXPECT_FALSE(engagesStop(stop)) << "it is about something else";
  stop.mutable_stop();
  EXPECT_TRUE(engagesStop(stop));
  stop.mutable_stop()->set_engaged(true);
  EXPECT_TRUE(engagesStop(stop));
  stop.mutable_stop()->set_engaged(false);
  EXPECT_FALSE(engagesStop(stop));
  Request copy;
  ASSERT_TRUE(copy.ParseFromString(stop.SerializeAsString()));
  EXPECT_FALSE(engagesStop(copy)) << "false is sent, too";
}

TEST(RequestKinds, anOverrideCanBeRemoved) {
  const auto removes = [](const Request& request) { return kindOf(request).removes(request); };
  EXPECT_FALSE(removes(keyRequest("a")));
  EXPECT_TRUE(removes(keyRequest("a", KeyMode::OFF)));
  EXPECT_TRUE(removes(keyRequest("a", KeyMode::N_TIMES))) << "it ends by itself";
  Request packages;
  packages.mutable_record_packages();
  EXPECT_TRUE(removes(packages));
  packages.mutable_record_packages()->add_packages("models/ball");
  EXPECT_FALSE(removes(packages));
}

TEST(RequestKinds, whatHandsDoHasLimits) {
  Request thrown;
  thrown.mutable_throw_model()->mutable_velocity()->set_x(5);
  EXPECT_THAT(wrongWith(thrown), HasSubstr("must name"));
  thrown.mutable_throw_model()->set_model("ball");
  EXPECT_EQ(wrongWith(thrown), "");
  thrown.mutable_throw_model()->mutable_spin()->set_z(1e9);
  EXPECT_THAT(wrongWith(thrown), HasSubstr("rad/s"));
  Request drag;
  drag.mutable_drag_object()->set_path("ball");
  EXPECT_EQ(wrongWith(drag), "");
  drag.mutable_drag_object()->mutable_target()->set_z(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(wrongWith(drag), HasSubstr("too far away"));
  Request push;
  push.mutable_push_object()->set_path("ball");
  push.mutable_push_object()->set_seconds(-1);
  EXPECT_THAT(wrongWith(push), HasSubstr("60 s"));
}

TEST(RequestKinds, aSnapshotHasANameOrAFileThatOnlySomebodyHereMayName) {
  using robotcontrol::ControlSnapshots;
  Request request;
  ControlSnapshots& control = *request.mutable_control_snapshots();
  control.set_action(ControlSnapshots::TAKE);
  EXPECT_THAT(wrongWith(request), HasSubstr("either a name or a file"));
  control.set_name("before");
  EXPECT_EQ(wrongWith(request), "");
  EXPECT_EQ(wrongFromElsewhere(request), "");
  control.set_file("/tmp/a.snapshot");
  EXPECT_NE(wrongWith(request), "");
  control.clear_name();
  EXPECT_EQ(wrongWith(request), "");
  EXPECT_NE(wrongFromElsewhere(request), "");
  control.set_action(ControlSnapshots::REWIND);
  control.set_seconds(0);
  EXPECT_NE(wrongWith(request), "");
}
