// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/ControlMessages.h"

#include <gtest/gtest.h>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/control/ControllerOutput.h"
#include "simcore/control/Controllers.h"
#include "simcore/world/ViewEvent.h"

namespace app {
namespace {

using robotlink::Vector3;
using simcore::DrawnShape;
using simcore::ViewEvent;

constexpr robotlink::Instant kNow{std::chrono::milliseconds(2500)};

ViewEvent clickOnBall() {
  ViewEvent event;
  event.kind = ViewEvent::Kind::kMousePressed;
  event.view = "scene";
  event.button = 3;
  event.origin = {1, 2, 3};
  event.direction = {0, 0, -1};
  event.object = "ball/ball/visual";
  event.model = "ball";
  event.point = {1, 2, 0.1};
  return event;
}

Vector3 vectorIn(const foxglove::Vector3& from) {
  return {from.x(), from.y(), from.z()};
}

TEST(ControlMessages, anEventOfTheMouseSaysWhereItHits) {
  robotcontrol::ViewEvent message;
  assign(message, clickOnBall());
  EXPECT_EQ(message.kind(), robotcontrol::ViewEvent::MOUSE_PRESSED);
  EXPECT_EQ(message.view(), "scene");
  EXPECT_EQ(message.button(), 3);
  EXPECT_EQ(vectorIn(message.origin()), Vector3(1, 2, 3));
  EXPECT_EQ(vectorIn(message.direction()), Vector3(0, 0, -1));
  EXPECT_EQ(message.object(), "ball/ball/visual");
  EXPECT_EQ(message.model(), "ball");
  EXPECT_EQ(vectorIn(message.point()), Vector3(1, 2, 0.1));
}

TEST(ControlMessages, aRayThatHitsNothingHasNoPoint) {
  ViewEvent event = clickOnBall();
  event.object.clear();
  robotcontrol::ViewEvent message;
  assign(message, event);
  EXPECT_TRUE(message.has_origin());
  EXPECT_FALSE(message.has_point());
}

TEST(ControlMessages, anEventOfTheKeyboardHasNoRay) {
  ViewEvent event;
  event.kind = ViewEvent::Kind::kKeyReleased;
  event.key = "Space";
  robotcontrol::ViewEvent message;
  assign(message, event);
  EXPECT_EQ(message.kind(), robotcontrol::ViewEvent::KEY_RELEASED);
  EXPECT_EQ(message.key(), "Space");
  EXPECT_FALSE(message.has_origin());
  EXPECT_FALSE(message.has_direction());
}

TEST(ControlMessages, nobodyElsewhereSaysWhatARayHits) {
  robotcontrol::ViewEvent request;
  assign(request, clickOnBall());
  const ViewEvent event = viewEvent(request);
  EXPECT_EQ(event.origin, Vector3(1, 2, 3));
  EXPECT_EQ(event.button, 3);
  EXPECT_EQ(event.object, "");
  EXPECT_EQ(event.model, "");
  EXPECT_EQ(event.point, Vector3::Zero());
}

TEST(ControlMessages, kindsOfEventsAreTheSameOnBothSides) {
  for (int number = 0; number < robotcontrol::ViewEvent::Kind_ARRAYSIZE; ++number) {
    robotcontrol::ViewEvent request, back;
    request.set_kind(static_cast<robotcontrol::ViewEvent::Kind>(number));
    const ViewEvent event = viewEvent(request);
    assign(back, event);
    EXPECT_EQ(back.kind(), request.kind());
    const bool isOfMouse = robotcontrol::ViewEvent::Kind_Name(request.kind()).starts_with("MOUSE");
    EXPECT_EQ(event.isOfMouse(), isOfMouse) << number;
  }
}

TEST(ControlMessages, eventsOfAStepKeepTheirOrder) {
  ViewEvent pressed, released;
  pressed.key = "A";
  released.key = "B";
  const std::vector<ViewEvent> events{pressed, released};
  const auto message = viewEvents(events, kNow, 77);
  EXPECT_EQ(message->step(), 77U);
  EXPECT_EQ(robotlink::instant(message->timestamp()), kNow);
  ASSERT_EQ(message->events_size(), 2);
  EXPECT_EQ(message->events(0).key(), "A");
  EXPECT_EQ(message->events(1).key(), "B");
  EXPECT_EQ(viewEvents({}, kNow, 78)->events_size(), 0);
}

TEST(ControlMessages, aControllerWithTroubleIsOff) {
  simcore::ControllerStatus status{.path = "lift/elevator", .model = "lift", .kind = "elevator"};
  robotcontrol::ControllerState state;
  assign(state, status);
  EXPECT_EQ(state.path(), "lift/elevator");
  EXPECT_EQ(state.kind(), "elevator");
  EXPECT_TRUE(state.is_on());
  status.trouble = "it threw an exception";
  assign(state, status);
  EXPECT_FALSE(state.is_on());
  EXPECT_EQ(state.trouble(), "it threw an exception");
}

/// The only entity of a drawing with these shapes.
foxglove::SceneEntity drawn(std::vector<DrawnShape> shapes) {
  simcore::ControllerOutput output;
  output.kind = simcore::ControllerOutput::Kind::kDrawing;
  output.info.path = "referee/lines";
  output.shapes = std::move(shapes);
  const auto update = drawingMessage(output, kNow);
  EXPECT_EQ(update->entities_size(), 1);
  return update->entities(0);
}

TEST(ControlMessages, aDrawingReplacesItselfByItsPath) {
  const auto entity = drawn({});
  EXPECT_EQ(entity.id(), "referee/lines");
  EXPECT_EQ(entity.frame_id(), "field");
  EXPECT_EQ(robotlink::instant(entity.timestamp()), kNow);
  EXPECT_EQ(entity.lines_size() + entity.spheres_size() + entity.cubes_size() + entity.texts_size(), 0);
}

TEST(ControlMessages, eachKindOfShapeIsDrawnInItsPlace) {
  const auto entity = drawn({
      {.kind = DrawnShape::Kind::kLine, .points = {{0, 0, 0}, {1, 2, 3}}, .size = {0.02, 5, 5}},
      {.kind = DrawnShape::Kind::kSphere, .points = {{1, 0, 0}}, .size = {0.5, 7, 7}, .color = {0, 0, 255}},
      {.kind = DrawnShape::Kind::kBox, .points = {{0, 1, 0}}, .size = {1, 2, 3}},
      {.kind = DrawnShape::Kind::kText, .points = {{0, 0, 1}}, .size = {0.25, 0, 0}, .text = "Goal!"},
  });
  ASSERT_EQ(entity.lines_size(), 1);
  EXPECT_EQ(entity.lines(0).thickness(), 0.02);
  ASSERT_EQ(entity.lines(0).points_size(), 2);
  EXPECT_EQ(entity.lines(0).points(1).z(), 3);
  EXPECT_EQ(entity.lines(0).pose().orientation().w(), 1) << "points are in the world";
  ASSERT_EQ(entity.spheres_size(), 1);
  EXPECT_EQ(vectorIn(entity.spheres(0).size()), Vector3(0.5, 0.5, 0.5)) << "x is the diameter";
  EXPECT_EQ(entity.spheres(0).pose().position().x(), 1);
  EXPECT_EQ(entity.spheres(0).color().b(), 1);
  EXPECT_EQ(entity.spheres(0).color().a(), 1);
  ASSERT_EQ(entity.cubes_size(), 1);
  EXPECT_EQ(vectorIn(entity.cubes(0).size()), Vector3(1, 2, 3));
  EXPECT_EQ(entity.cubes(0).pose().position().y(), 1);
  ASSERT_EQ(entity.texts_size(), 1);
  EXPECT_EQ(entity.texts(0).text(), "Goal!");
  EXPECT_EQ(entity.texts(0).font_size(), 0.25);
  EXPECT_TRUE(entity.texts(0).billboard()) << "it is read from all sides";
}

}  // namespace
}  // namespace app
