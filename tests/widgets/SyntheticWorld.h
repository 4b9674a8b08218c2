// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPoint>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Image.h"
#include "robotlink/debugging/Drawings.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"

namespace widgets::test {

/// A session that a test tells what robots and a simulator would tell: images, drawings, a scene, poses.
/// Takes down what views request. The robot is "red1"; the field is that of 2002.
class SyntheticWorld {
 public:
  using FramePart = std::function<void(robotcontrol::DebugQueue&)>;

  SyntheticWorld();

  void push(const std::string& path, robotlink::PackagePtr value);
  /// Goes on in time and lets the session take in what was pushed.
  void advance(int milliseconds = 40);
  robotlink::Instant now() const { return now_; }

  /// An image of one colour, with one pixel of another.
  void pushImage(const std::string& path, QSize size, robotlink::YCbCr color, QPoint spot = {},
                 robotlink::YCbCr spotColor = {});
  /// A frame of the process "cognition" with these drawings in it, and none of those before.
  void pushFrame(const std::vector<FramePart>& parts);
  /// Ground, a wall, the robot (a box) and the ball.
  void pushScene();
  void pushPoses(const robotlink::Pose2& robot, const robotlink::Vector2& ball);
  void pushEstimates(const robotlink::Pose2& robot, const robotlink::Vector2& ballInRobot);

  robotlink::Session session;
  robotlink::CommandTable commands;
  ViewContext context;
  std::vector<robotcontrol::Request> requests;
  std::string refusal;         ///< not empty: every request is refused with it
  bool wrongChecksum = false;  ///< of colour tables, as if something were lost on the way

 private:
  robotlink::Instant now_{std::chrono::seconds(1)};
  std::uint64_t frame_ = 0;
};

/// Parts of a frame: what a debug key of this name draws.
SyntheticWorld::FramePart imageDrawing(const std::string& key,
                                       const std::function<void(robotlink::ImageDrawing&)>& draw);
/// `kind` is "field" or "robot"; `frame` the frame of the coordinates.
SyntheticWorld::FramePart worldDrawing(const std::string& kind, const std::string& key,
                                       const std::string& frame,
                                       const std::function<void(robotlink::SceneDrawing&)>& draw);

/// A drawing of the field that no honest program makes: indices past the end, numbers that are none.
SyntheticWorld::FramePart damagedDrawing(const std::string& key, const std::string& frame);

/// Fails the running test at any Qt warning but those of the offscreen platform about what it cannot do. For
/// initTestCase().
void failAtWarnings();
/// Whether two colours differ by at most `tolerance` in each channel.
bool isNear(const QColor& a, const QColor& b, int tolerance = 12);
/// How many pixels of a picture are near a colour.
int countNear(const QImage& picture, const QColor& color, int tolerance = 12);
/// Writes pictures of the widget, in light and dark, where ROBOTCONTROL_TEST_PICTURES says, for people to
/// look at; does nothing otherwise.
void keepPicture(QWidget& widget, const char* name);

// What a person does with a mouse; whatever is still to be laid out is laid out first.
void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = {});
/// Presses, moves there by way of the middle, and releases; `moved` is called after each move.
void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          const std::function<void()>& moved = {}, Qt::KeyboardModifiers modifiers = {});
void turnWheel(QWidget& widget, const QPoint& at, int notches);
void click(const QWidget& parent, const char* button);

/// The widget of this object name; the test is aborted if there is none.
template <typename T>
T* child(const QWidget& parent, const char* name) {
  auto* found = parent.findChild<T*>(QLatin1String(name));
  if (found == nullptr) qFatal("no widget named %s", name);
  return found;
}

}  // namespace widgets::test
