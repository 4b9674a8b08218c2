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
#include "robotlink/debugging/drawing/Drawings.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"

namespace widgets::test {

/// A session to which a test publishes what robots and a simulator would: images, drawings, a scene, poses.
/// It records the requests of views. The robot is "red1"; the field is that of 2002.
class SyntheticWorld {
 public:
  using FramePart = std::function<void(robotcontrol::DebugQueue&)>;

  SyntheticWorld();

  void push(const std::string& path, robotlink::PackagePtr value);
  /// Advances the time and lets the session process what was published.
  void advance(int milliseconds = 40);
  robotlink::Instant now() const { return now_; }

  /// An image of uniform color, with one pixel of another color.
  void pushImage(const std::string& path, QSize size, robotlink::YCbCr color, QPoint spot = {},
                 robotlink::YCbCr spotColor = {});
  /// A frame of the process "cognition" with these drawings, which replaces the previous ones.
  void pushFrame(const std::vector<FramePart>& parts);
  /// The scene: ground, a wall, the robot (a box) and the ball.
  void pushScene();
  void pushPoses(const robotlink::Pose2& robot, const robotlink::Vector2& ball);
  void pushEstimates(const robotlink::Pose2& robot, const robotlink::Vector2& ballInRobot);

  robotlink::Session session;
  robotlink::CommandTable commands;
  ViewContext context;
  std::vector<robotcontrol::Request> requests;
  /// If not empty, every request is refused with this reason.
  std::string refusal;
  /// Whether the checksums of color tables are wrong, as after a loss of data.
  bool wrongChecksum = false;

 private:
  robotlink::Instant now_{std::chrono::seconds(1)};
  std::uint64_t frame_ = 0;
};

/// Parts of a frame: the drawing of a debug key with this name.
SyntheticWorld::FramePart imageDrawing(const std::string& key,
                                       const std::function<void(robotlink::ImageDrawing&)>& draw);
/// `kind` is "field" or "robot"; `frame` is the frame of the coordinates.
SyntheticWorld::FramePart worldDrawing(const std::string& kind, const std::string& key,
                                       const std::string& frame,
                                       const std::function<void(robotlink::SceneDrawing&)>& draw);

/// A drawing of the field that no correct program makes: indices past the end, and NaN.
SyntheticWorld::FramePart damagedDrawing(const std::string& key, const std::string& frame);

/// For initTestCase(): fails the running test at any Qt warning, except for those of the offscreen plugin
/// about what it does not support.
void failAtWarnings();
/// Whether two colors differ by at most `tolerance` in each channel.
bool isNear(const QColor& a, const QColor& b, int tolerance = 12);
/// Number of pixels of a picture that are near a color.
int countNear(const QImage& picture, const QColor& color, int tolerance = 12);
/// Writes pictures of the widget, light and dark, to the folder ROBOTCONTROL_TEST_PICTURES, for visual
/// inspection; does nothing if that is not set.
void keepPicture(QWidget& widget, const char* name);

// Mouse operations; pending layouts are completed first.
void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = {});
/// Presses, moves to the end by way of the middle, and releases; `moved` is called after each move.
void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          const std::function<void()>& moved = {}, Qt::KeyboardModifiers modifiers = {});
void turnWheel(QWidget& widget, const QPoint& at, int notches);
void click(const QWidget& parent, const char* button);

/// The widget of this object name; the test is aborted if there is none.
template <typename T>
/// The widget with this object name; aborts the test if there is none.
T* child(const QWidget& parent, const char* name) {
  auto* found = parent.findChild<T*>(QLatin1String(name));
  if (found == nullptr) qFatal("no widget named %s", name);
  return found;
}

}  // namespace widgets::test
