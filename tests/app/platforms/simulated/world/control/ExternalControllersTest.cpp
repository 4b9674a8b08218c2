// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/ExternalControllers.h"

#include <gmock/gmock.h>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using robotcontrol::ControllerInputs;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Controllers elsewhere of the shipped scene with a lift; real time is what the tests say.
class ExternalControllersTest : public testing::Test {
 protected:
  using RealTime = ExternalControllers::RealTime;

  ExternalControllersTest() {
    const auto scene = simcore::Scene::load(robotlink::resource("scenes/elevator.sdf"));
    if (!scene) {
      ADD_FAILURE() << robotlink::describe(scene.error());
      return;
    }
    simulation_ = std::move(simcore::Simulation::create(*scene, {}).value());
  }

  static robotcontrol::AttachController wish(bool lockstep) {
    robotcontrol::AttachController request;
    request.set_name("remote");
    request.add_sensors("elevator/rail/position");
    request.add_sensors("elevator/elevator/calls");
    auto& output = *request.add_outputs();
    output.set_path("seen");
    output.set_unit("m");
    request.set_lockstep(lockstep);
    request.set_patience(0.5);
    return request;
  }
  static robotcontrol::SetPorts answer(std::uint64_t step, double position) {
    robotcontrol::SetPorts set;
    set.set_controller("remote");
    set.set_step(step);
    auto& command = *set.add_commands();
    command.set_port("elevator/rail/request");
    command.add_values(position);
    auto& seen = *set.add_outputs();
    seen.set_port("seen");
    seen.add_values(position / 2);
    return set;
  }
  std::vector<robotlink::StreamMessage> inputs(bool newOnly = false) {
    return external_.inputs(*simulation_, robotlink::Instant(simulation_->time()), now_, newOnly);
  }
  void step() {
    simulation_->control();
    external_.noteEvents(simulation_->events());
    external_.commands().apply(*simulation_);
    simulation_->step();
  }
  static const ControllerInputs& inputsOf(const robotlink::StreamMessage& message) {
    return dynamic_cast<const ControllerInputs&>(*message.value);
  }

  std::unique_ptr<simcore::Simulation> simulation_;
  ExternalControllers external_;
  RealTime now_ = RealTime(std::chrono::hours(1));
};

TEST_F(ExternalControllersTest, itGetsReadingsAndCommandsActuators) {
  ASSERT_TRUE(external_.attach(wish(false), *simulation_));
  const auto first = inputs(true);
  ASSERT_THAT(first, SizeIs(1));
  EXPECT_EQ(first[0].path, "sim/ports/remote");
  ASSERT_EQ(inputsOf(first[0]).readings_size(), 2);
  EXPECT_EQ(inputsOf(first[0]).readings(1).values_size(), 3);
  EXPECT_THAT(inputs(true), IsEmpty()) << "only once";
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_));
  for (int i = 0; i < 500; ++i) step();
  EXPECT_NEAR(simulation_->read("elevator/rail/position").value().front(), 0.4, 0.02)
      << "it overrides the controller of the scene";
  ASSERT_THAT(external_.outputs(), SizeIs(1));
  EXPECT_EQ(external_.outputs()[0]->info.path, "remote/seen");
  EXPECT_EQ(external_.outputs()[0]->values[0], 0.2);
}

TEST_F(ExternalControllersTest, aStepWaitsForTheAnswerToItsInputs) {
  ASSERT_TRUE(external_.attach(wish(true), *simulation_));
  EXPECT_FALSE(external_.waitsUntil());
  ASSERT_THAT(inputs(true), SizeIs(1));
  EXPECT_EQ(external_.waitsUntil(), now_ + std::chrono::milliseconds(500));
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_));
  EXPECT_FALSE(external_.waitsUntil());
  step();
  ASSERT_THAT(inputs(), SizeIs(1));
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_)) << "of a step before";
  EXPECT_TRUE(external_.waitsUntil());
  ASSERT_TRUE(external_.set(answer(1, 0.4), *simulation_));
  EXPECT_FALSE(external_.waitsUntil());
}

TEST_F(ExternalControllersTest, aRefusedAnswerIsOneToo) {
  ASSERT_TRUE(external_.attach(wish(true), *simulation_));
  ASSERT_THAT(inputs(true), SizeIs(1));
  auto wrong = answer(0, 0.4);
  wrong.mutable_commands(0)->set_port("elevator/rail/requst");
  EXPECT_FALSE(external_.set(wrong, *simulation_));
  EXPECT_FALSE(external_.waitsUntil()) << "the step goes on at once";
}

TEST_F(ExternalControllersTest, whoIsLateIsNamedAndNotWaitedForUntilItAnswersAgain) {
  ASSERT_TRUE(external_.attach(wish(true), *simulation_));
  ASSERT_THAT(inputs(true), SizeIs(1));
  now_ += std::chrono::milliseconds(400);
  EXPECT_THAT(external_.beforeStep(now_, *simulation_), IsEmpty());
  now_ += std::chrono::milliseconds(200);
  const auto late = external_.beforeStep(now_, *simulation_);
  ASSERT_THAT(late, SizeIs(1));
  EXPECT_THAT(late[0], HasSubstr("The controller remote has not answered step 0 in time"));
  EXPECT_FALSE(external_.waitsUntil());
  step();
  ASSERT_THAT(inputs(), SizeIs(1)) << "it goes on getting them";
  EXPECT_FALSE(external_.waitsUntil());
  robotcontrol::ControllerStates states;
  external_.addStates(states);
  EXPECT_FALSE(states.controllers(0).is_on());
  EXPECT_EQ(states.controllers(0).late(), 1U);
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_));
  EXPECT_TRUE(external_.waitsUntil()) << "for the answer to step 1";
  ASSERT_TRUE(external_.set(answer(1, 0.4), *simulation_));
  EXPECT_FALSE(external_.waitsUntil());
}

TEST_F(ExternalControllersTest, inLockstepTheSameAnswersGiveTheSameBytes) {
  const auto play = [this](double factor) {
    simulation_->reset(5);
    external_.restart();
    static_cast<void>(inputs(true));
    for (std::uint64_t i = 0; i < 200; ++i) {
      EXPECT_TRUE(external_.set(answer(i, factor * static_cast<double>(i)), *simulation_));
      step();
      static_cast<void>(inputs());
    }
    return simulation_->digest();
  };
  ASSERT_TRUE(external_.attach(wish(true), *simulation_));
  const std::uint64_t digest = play(0.001);
  EXPECT_EQ(play(0.001), digest);
  EXPECT_NE(play(0.002), digest);
}

TEST_F(ExternalControllersTest, inputsComeAsRarelyAsItWantsWithAllEvents) {
  auto rare = wish(false);
  rare.set_every(3);
  ASSERT_TRUE(external_.attach(rare, *simulation_));
  ASSERT_THAT(inputs(true), SizeIs(1));
  simcore::ViewEvent event;
  event.key = "A";
  ASSERT_TRUE(simulation_->addEvent(event));
  step();
  EXPECT_THAT(inputs(), IsEmpty());
  step();
  EXPECT_THAT(inputs(), IsEmpty());
  step();
  const auto third = inputs();
  ASSERT_THAT(third, SizeIs(1));
  ASSERT_EQ(inputsOf(third[0]).events_size(), 1);
  EXPECT_EQ(inputsOf(third[0]).events(0).key(), "A");
}

TEST_F(ExternalControllersTest, imagesOfCamerasComeBeforeTheInputs) {
  const auto scene = simcore::Scene::load(robotlink::resource("scenes/field2002.sdf"));
  ASSERT_TRUE(scene);
  simulation_ = std::move(simcore::Simulation::create(*scene, {}).value());
  robotcontrol::AttachController request;
  request.set_name("remote");
  request.add_sensors("red1/camera/image");
  request.add_sensors("red1/headPan/position");
  ASSERT_TRUE(external_.attach(request, *simulation_));
  const auto messages = inputs();
  ASSERT_THAT(messages, SizeIs(2));
  EXPECT_EQ(messages[0].path, "sim/ports/remote/red1/camera/image");
  const auto* image = dynamic_cast<const foxglove::RawImage*>(messages[0].value.get());
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->encoding(), "yuyv");
  EXPECT_EQ(image->data().size(), 2U * image->width() * image->height());
  EXPECT_EQ(messages[1].path, "sim/ports/remote");
  EXPECT_EQ(inputsOf(messages[1]).readings_size(), 1);
}

TEST_F(ExternalControllersTest, itGetsTheTruthWithTheReadings) {
  auto curious = wish(false);
  curious.add_sensors("elevator/rail/position/true");
  curious.add_sensors("elevator/true_pose");
  ASSERT_TRUE(external_.attach(curious, *simulation_));
  const auto first = inputs(true);
  ASSERT_THAT(first, SizeIs(1));
  ASSERT_EQ(inputsOf(first[0]).readings_size(), 4);
  EXPECT_EQ(inputsOf(first[0]).readings(2).values_size(), 1);
  EXPECT_EQ(inputsOf(first[0]).readings(3).values_size(), 7);
}

TEST_F(ExternalControllersTest, whatMakesNoSenseIsRefused) {
  auto wrong = wish(false);
  wrong.set_sensors(0, "elevator/rail/positon");
  auto done = external_.attach(wrong, *simulation_);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text, HasSubstr("elevator/rail/position"));
  wrong = wish(false);
  wrong.set_name("elevator");
  EXPECT_FALSE(external_.attach(wrong, *simulation_)) << "the name of a model";
  wrong.set_name("a/b");
  EXPECT_FALSE(external_.attach(wrong, *simulation_));
  wrong = wish(false);
  wrong.mutable_outputs(0)->add_shape(1 << 30);
  EXPECT_FALSE(external_.attach(wrong, *simulation_));
  EXPECT_TRUE(external_.isEmpty());
  EXPECT_FALSE(external_.set(answer(0, 1), *simulation_)) << "it is not attached";
  ASSERT_TRUE(external_.attach(wish(false), *simulation_));
  auto set = answer(0, 1);
  set.mutable_commands(0)->set_port("elevator/rail/requst");
  done = external_.set(set, *simulation_);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text, HasSubstr("elevator/rail/request"));
  set = answer(0, 1);
  set.mutable_commands(0)->add_values(2);
  EXPECT_FALSE(external_.set(set, *simulation_));
  set = answer(0, 1);
  set.mutable_outputs(0)->set_port("heard");
  EXPECT_FALSE(external_.set(set, *simulation_));
}

TEST_F(ExternalControllersTest, whatMustNotMoveIsNotCommanded) {
  ASSERT_TRUE(external_.attach(wish(false), *simulation_));
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_));
  external_.commands().setStopped({"elevator"});
  for (int i = 0; i < 300; ++i) step();
  EXPECT_NEAR(simulation_->read("elevator/rail/position").value().front(), 0, 0.02);
  external_.commands().setStopped({});
  for (int i = 0; i < 300; ++i) step();
  EXPECT_NEAR(simulation_->read("elevator/rail/position").value().front(), 0.4, 0.02);
}

TEST_F(ExternalControllersTest, whoEndsReleasesWhatItHasSet) {
  ASSERT_TRUE(external_.attach(wish(false), *simulation_));
  ASSERT_TRUE(external_.set(answer(0, 0.4), *simulation_));
  for (int i = 0; i < 300; ++i) step();
  robotcontrol::AttachController end;
  end.set_name("remote");
  end.set_ended(true);
  ASSERT_TRUE(external_.attach(end, *simulation_));
  EXPECT_FALSE(external_.attach(end, *simulation_)) << "it has ended";
  for (int i = 0; i < 500; ++i) step();
  EXPECT_NEAR(simulation_->read("elevator/rail/position").value().front(), 0, 0.02)
      << "the controller of the scene has it again";
}

}  // namespace
}  // namespace app
