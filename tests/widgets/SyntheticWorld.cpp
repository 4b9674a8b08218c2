// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/SyntheticWorld.h"
#include "robotlink/debugging/SharedDebugQueue.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QMouseEvent>
#include <QPalette>
#include <QPixmap>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Checksum.h"
#include "robotlink/packages/Conversions.h"

namespace widgets::test {
namespace {

using robotlink::Pose2;
using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

constexpr double kBallRadius = 0.042;

std::shared_ptr<const robotlink::FieldDescription> field2002() {
  auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  if (!field) qFatal("%s", robotlink::describe(field.error()).c_str());
  return std::make_shared<const robotlink::FieldDescription>(std::move(*field));
}

void addTransform(foxglove::FrameTransforms& to, const std::string& frame, const Pose2& pose, double height) {
  auto& transform = *to.add_transforms();
  transform.set_parent_frame_id("field");
  transform.set_child_frame_id(frame);
  robotlink::assign(*transform.mutable_translation(), Vector3(pose.x, pose.y, height));
  transform.mutable_rotation()->set_z(std::sin(pose.heading / 2));
  transform.mutable_rotation()->set_w(std::cos(pose.heading / 2));
}

foxglove::SceneEntity& addEntity(foxglove::SceneUpdate& scene, const std::string& id,
                                 const std::string& frame, const std::string& model) {
  auto& entity = *scene.add_entities();
  entity.set_id(id);
  entity.set_frame_id(frame);
  if (model.empty()) return entity;
  auto& pair = *entity.add_metadata();
  pair.set_key("model");
  pair.set_value(model);
  return entity;
}

void addCube(foxglove::SceneEntity& entity, const Vector3& center, const Vector3& size,
             robotlink::Rgb color) {
  auto& cube = *entity.add_cubes();
  Pose3 pose = Pose3::Identity();
  pose.translation() = center;
  robotlink::assign(*cube.mutable_pose(), pose);
  robotlink::assign(*cube.mutable_size(), size);
  robotlink::assign(*cube.mutable_color(), color);
}

QtMessageHandler previousHandler = nullptr;

void failingHandler(QtMsgType type, const QMessageLogContext& where, const QString& text) {
  if (type == QtWarningMsg && !text.startsWith(QLatin1String("This plugin does not support"))) {
    QTest::qFail(qPrintable(QStringLiteral("warning: %1").arg(text)), __FILE__, __LINE__);
  }
  if (previousHandler != nullptr) previousHandler(type, where, text);
}

}  // namespace

SyntheticWorld::SyntheticWorld() : context{session, commands, field2002(), {}} {
  session.setRobots({"red1"});
  session.setRequestSink([this](const robotcontrol::Request& request) {
    requests.push_back(request);
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(refusal.empty());
    result.set_reason(refusal);
    if (request.has_set_color_table())
      result.set_checksum(robotlink::checksum(request.set_color_table().table()) + wrongChecksum);
    session.pushResult(result);
  });
}

void SyntheticWorld::push(const std::string& path, robotlink::PackagePtr value) {
  session.push({path, now_, std::move(value)});
}

void SyntheticWorld::advance(int milliseconds) {
  now_ += std::chrono::milliseconds(milliseconds);
  session.tick();
}

void SyntheticWorld::pushImage(const std::string& path, QSize size, robotlink::YCbCr color, QPoint spot,
                               robotlink::YCbCr spotColor) {
  robotlink::Image image(size.width(), size.height(), robotlink::PixelFormat::kYuyv);
  for (std::size_t i = 0; i < image.data.size(); i += 4) {
    image.data[i] = image.data[i + 2] = color.y;
    image.data[i + 1] = color.cb;
    image.data[i + 3] = color.cr;
  }
  if (spotColor != robotlink::YCbCr()) {
    std::uint8_t* pair = image.row(spot.y()) + std::ptrdiff_t{2} * (spot.x() & ~1);
    pair[spot.x() % 2 == 0 ? 0 : 2] = spotColor.y;
    pair[1] = spotColor.cb;
    pair[3] = spotColor.cr;
  }
  auto message = std::make_shared<foxglove::RawImage>();
  robotlink::assign(*message, image.view(), now_, "camera");
  push(path, message);
}

void SyntheticWorld::pushFrame(const std::vector<FramePart>& parts) {
  robotcontrol::DebugQueue queue;
  queue.set_process("cognition");
  for (const auto& part : parts) part(queue);
  auto& end = *queue.add_messages();
  end.set_path("frames/cognition");
  end.mutable_frame()->set_process("cognition");
  end.mutable_frame()->set_number(++frame_);
  for (auto& message : *queue.mutable_messages()) robotlink::assign(*message.mutable_timestamp(), now_);
  session.pushQueue("red1", robotlink::fromWire(std::move(queue)));
}

void SyntheticWorld::pushScene() {
  const auto rgb = [this](const char* name) { return *context.field->color(name); };
  auto scene = std::make_shared<foxglove::SceneUpdate>();
  addCube(addEntity(*scene, "ground", "field", ""), {0, 0, -0.01}, {4.2, 2.7, 0.02}, rgb("green"));
  addCube(addEntity(*scene, "wall", "field", ""), {0, 1.4, 0.05}, {4.4, 0.1, 0.1}, rgb("white"));
  addCube(addEntity(*scene, "red1/body", "red1", "red1"), {0, 0, 0.12}, {0.25, 0.14, 0.1}, rgb("red"));
  auto& ball = *addEntity(*scene, "ball/ball", "ball", "ball").add_spheres();
  robotlink::assign(*ball.mutable_pose(), Pose3(Pose3::Identity()));
  robotlink::assign(*ball.mutable_size(), Vector3(Vector3::Constant(2 * kBallRadius)));
  robotlink::assign(*ball.mutable_color(), rgb("orange"));
  push("scene", scene);
}

void SyntheticWorld::pushPoses(const Pose2& robot, const Vector2& ball) {
  auto transforms = std::make_shared<foxglove::FrameTransforms>();
  addTransform(*transforms, "red1", robot, 0);
  addTransform(*transforms, "ball", {ball.x(), ball.y(), 0}, kBallRadius);
  push("transforms", transforms);
}

void SyntheticWorld::pushEstimates(const Pose2& robot, const Vector2& ballInRobot) {
  auto pose = std::make_shared<robotcontrol::RobotPose>();
  robotlink::assign(*pose->mutable_robot_in_field(), robot);
  pose->set_position_deviation(0.1);
  push("red1/models/pose", pose);
  auto ball = std::make_shared<robotcontrol::BallModel>();
  ball->set_known(true);
  robotlink::assign(*ball->mutable_position_in_robot(), ballInRobot);
  ball->set_standard_deviation(0.08);
  push("red1/models/ball", ball);
}

SyntheticWorld::FramePart damagedDrawing(const std::string& key, const std::string& frame) {
  return [=](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/field/" + key);
    auto& entity = *message.mutable_scene_drawing()->add_entities();
    entity.set_frame_id(frame);
    auto& lines = *entity.add_lines();
    auto& triangles = *entity.add_triangles();
    for (const double x : {0.0, std::nan(""), 1.0}) {
      lines.add_points()->set_x(x);
      triangles.add_points()->set_x(x);
    }
    for (const std::uint32_t index : {0U, 1U, 7U, 0xFFFFFFFFU, 2U}) {
      lines.add_indices(index);
      triangles.add_indices(index);
    }
    entity.add_texts()->set_font_size(std::nan(""));
    entity.add_spheres()->mutable_size()->set_x(std::nan(""));
  };
}

SyntheticWorld::FramePart imageDrawing(const std::string& key,
                                       const std::function<void(robotlink::ImageDrawing&)>& draw) {
  return [key, draw](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/image/" + key);
    robotlink::ImageDrawing drawing(*message.mutable_image_drawing());
    draw(drawing);
  };
}

SyntheticWorld::FramePart worldDrawing(const std::string& kind, const std::string& key,
                                       const std::string& frame,
                                       const std::function<void(robotlink::SceneDrawing&)>& draw) {
  return [=](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/" + kind + "/" + key);
    auto& entity = *message.mutable_scene_drawing()->add_entities();
    entity.set_frame_id(frame);
    robotlink::SceneDrawing drawing(entity);
    draw(drawing);
  };
}

void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  QApplication::processEvents();
  QMouseEvent event(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, buttons, modifiers);
  QApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          const std::function<void()>& moved, Qt::KeyboardModifiers modifiers) {
  moveMouse(widget, from, Qt::NoButton, modifiers);
  QTest::mousePress(&widget, button, modifiers, from);
  for (const QPoint& at : {(from + to) / 2, to}) {
    moveMouse(widget, at, button, modifiers);
    if (moved) moved();
  }
  QTest::mouseRelease(&widget, button, modifiers, to);
}

void turnWheel(QWidget& widget, const QPoint& at, int notches) {
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

void click(const QWidget& parent, const char* button) {
  QApplication::processEvents();
  QTest::mouseClick(child<QAbstractButton>(parent, button), Qt::LeftButton);
}

void failAtWarnings() {
  previousHandler = qInstallMessageHandler(failingHandler);
}

bool isNear(const QColor& a, const QColor& b, int tolerance) {
  const auto close = [tolerance](int x, int y) { return std::abs(x - y) <= tolerance; };
  return close(a.red(), b.red()) && close(a.green(), b.green()) && close(a.blue(), b.blue());
}

int countNear(const QImage& picture, const QColor& color, int tolerance) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      count += isNear(picture.pixelColor(x, y), color, tolerance) ? 1 : 0;
  }
  return count;
}

void keepPicture(QWidget& widget, const char* name) {
  const QString folder = qEnvironmentVariable("ROBOTCONTROL_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  const QString file = folder + QLatin1Char('/') + QLatin1String(name);
  QApplication::processEvents();
  widget.grab().save(file + QStringLiteral(".png"));
  const QPalette light = QApplication::palette();
  QApplication::setPalette(QPalette(QColor(53, 58, 64), QColor(40, 44, 50)));
  QTest::qWait(400);  // pictures that are drawn elsewhere follow
  widget.grab().save(file + QStringLiteral("-dark.png"));
  QApplication::setPalette(light);
}

}  // namespace widgets::test
