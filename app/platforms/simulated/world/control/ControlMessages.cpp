// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/ControlMessages.h"

#include "foxglove/Scene.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/Simulation.h"
#include "simcore/control/ControllerOutput.h"
#include "simcore/control/Controllers.h"
#include "simcore/world/ViewEvent.h"

namespace app {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;
using simcore::DrawnShape;

Vector3 vectorOf(const foxglove::Vector3& from) {
  return {from.x(), from.y(), from.z()};
}

void setPose(foxglove::Pose& to, const Vector3& at) {
  Pose3 pose = Pose3::Identity();
  pose.translate(at);
  robotlink::assign(to, pose);
}

void addShape(foxglove::SceneEntity& entity, const DrawnShape& shape) {
  switch (shape.kind) {
    case DrawnShape::Kind::kLine: {
      auto& line = *entity.add_lines();
      line.set_thickness(shape.size.x());
      line.mutable_pose()->mutable_orientation()->set_w(1);
      robotlink::assign(*line.mutable_color(), shape.color);
      for (const Vector3& point : shape.points) {
        auto& added = *line.add_points();
        added.set_x(point.x());
        added.set_y(point.y());
        added.set_z(point.z());
      }
      return;
    }
    case DrawnShape::Kind::kSphere: {
      auto& sphere = *entity.add_spheres();
      setPose(*sphere.mutable_pose(), shape.points.front());
      robotlink::assign(*sphere.mutable_size(), Vector3(Vector3::Constant(shape.size.x())));
      robotlink::assign(*sphere.mutable_color(), shape.color);
      return;
    }
    case DrawnShape::Kind::kBox: {
      auto& box = *entity.add_cubes();
      setPose(*box.mutable_pose(), shape.points.front());
      robotlink::assign(*box.mutable_size(), shape.size);
      robotlink::assign(*box.mutable_color(), shape.color);
      return;
    }
    case DrawnShape::Kind::kText: {
      auto& text = *entity.add_texts();
      setPose(*text.mutable_pose(), shape.points.front());
      text.set_billboard(true);
      text.set_font_size(shape.size.x());
      text.set_text(shape.text);
      robotlink::assign(*text.mutable_color(), shape.color);
      return;
    }
  }
}

}  // namespace

std::optional<robotcontrol::PortReading> readingOf(const simcore::Simulation& simulation,
                                                   const std::string& path) {
  robotcontrol::PortReading reading;
  reading.set_port(path);
  const simcore::Port* const of = simulation.portOfTruth(path);
  if (of != nullptr && of->kind == simcore::Port::Kind::kCamera) {
    for (const simcore::TruePercept& percept : simulation.truePercepts(of->index)) {
      auto& added = *reading.add_percepts();
      added.set_model(percept.model);
      robotlink::assign(*added.mutable_model_in_camera(), percept.modelInCamera);
      added.set_left(percept.left);
      added.set_top(percept.top);
      added.set_right(percept.right);
      added.set_bottom(percept.bottom);
      added.set_pixels(percept.pixels);
    }
    return reading;
  }
  const auto values = simulation.read(path);
  if (!values) return std::nullopt;
  reading.mutable_values()->Add(values->begin(), values->end());
  return reading;
}

simcore::ViewEvent viewEvent(const robotcontrol::ViewEvent& from) {
  simcore::ViewEvent event;
  event.kind = static_cast<simcore::ViewEvent::Kind>(from.kind());
  event.view = from.view();
  event.key = from.key();
  event.button = from.button();
  event.origin = vectorOf(from.origin());
  event.direction = vectorOf(from.direction());
  return event;
}

void assign(robotcontrol::ViewEvent& to, const simcore::ViewEvent& from) {
  to.set_kind(static_cast<robotcontrol::ViewEvent::Kind>(from.kind));
  to.set_view(from.view);
  to.set_key(from.key);
  to.set_button(from.button);
  to.set_object(from.object);
  to.set_model(from.model);
  if (!from.isOfMouse()) return;
  robotlink::assign(*to.mutable_origin(), from.origin);
  robotlink::assign(*to.mutable_direction(), from.direction);
  if (!from.object.empty()) robotlink::assign(*to.mutable_point(), from.point);
}

std::shared_ptr<const robotcontrol::ViewEvents> viewEvents(std::span<const simcore::ViewEvent> events,
                                                           robotlink::Instant time, std::uint64_t step) {
  auto message = std::make_shared<robotcontrol::ViewEvents>();
  robotlink::assign(*message->mutable_timestamp(), time);
  message->set_step(step);
  for (const simcore::ViewEvent& event : events) assign(*message->add_events(), event);
  return message;
}

void assign(robotcontrol::ControllerState& to, const simcore::ControllerStatus& from) {
  to.set_path(from.path);
  to.set_kind(from.kind);
  to.set_trouble(from.trouble);
  to.set_is_on(from.isOn());
}

std::shared_ptr<const foxglove::SceneUpdate> drawingMessage(const simcore::ControllerOutput& output,
                                                            robotlink::Instant time) {
  auto update = std::make_shared<foxglove::SceneUpdate>();
  auto& entity = *update->add_entities();
  robotlink::assign(*entity.mutable_timestamp(), time);
  entity.set_frame_id("field");
  entity.set_id(output.info.path);
  for (const DrawnShape& shape : output.shapes) addShape(entity, shape);
  return update;
}

}  // namespace app
