// SPDX-License-Identifier: GPL-3.0-or-later
// The harness of all tests of views and of the window; ../README.md says how to use it.
#pragma once

#include <QApplication>
#include <QColor>
#include <QPoint>
#include <QTest>
#include <QTreeView>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"
#include "tests/widgets/GuiTest.h"
#include "widgets/View.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motions/MotionLink.h"
#include "widgets/sceneedit/SceneBench.h"

namespace widgets::test {

/// A session without a program: the test publishes what a robot would and controls the time. Requests are
/// recorded instead of sent. Contents for certain views are in FieldBench, CameraBench, LogBench and
/// DriveBench.
class Bench {
 public:
  struct Options {
    std::vector<std::string> robots{"red1", "blue1"};  // the first one is selected
    bool answers = false;                              // whether requests are answered at once
    bool field = false;                                // whether the robots play on the field of 2002
  };

  Bench() : Bench(Options()) {}
  explicit Bench(const Options& options);

  /// Creates and shows a view.
  template <typename V>
  std::unique_ptr<V> open(QSize size = {700, 500}) {
    auto view = std::make_unique<V>(context);
    view->resize(size);
    view->show();
    if (!QTest::qWaitForWindowActive(view.get())) qFatal("the view's window never became active");
    tick(*view);
    return view;
  }
  void tick(View& view) {
    session.tick();
    view.tick();
    if (context.steering) context.steering->tick();
    if (context.motions) tickMotions(context);
    if (context.scenes) sceneBench(context).tick();
  }

  template <typename T>
  void push(const std::string& path, const T& message, double time) {
    session.push(
        {path, robotlink::Instant(robotlink::fromSeconds(time)), std::make_shared<const T>(message)});
  }
  /// Publishes at now().
  void push(const std::string& path, robotlink::PackagePtr value) {
    session.push({path, now_, std::move(value)});
  }
  /// Advances the time and lets the session process what was published.
  void advance(int milliseconds = 40);
  robotlink::Instant now() const { return now_; }

  /// Answers the last request.
  void answer(bool accepted, const std::string& reason = {}) { answer(requests.back(), accepted, reason); }
  void answer(const robotcontrol::Request& request, bool accepted, const std::string& reason = {});

  robotlink::Session session;
  robotlink::CommandTable commands;
  ViewContext context{session, commands, nullptr, {}};
  std::vector<robotcontrol::Request> requests;
  /// If not empty, requests that are answered at once are refused with this reason.
  std::string refusal;
  /// Whether the checksums of color tables are wrong, as after a loss of data.
  bool wrongChecksum = false;

 private:
  robotlink::Instant now_{std::chrono::seconds(1)};
};

/// For main(): the resources of this source tree, and a new home folder. Aborts the program at any Qt
/// warning, except for those of the offscreen plugin about what it does not support.
class BenchHome {
 public:
  BenchHome();
  /// The home folder, for files of tests.
  static std::filesystem::path path();

 private:
  TestFolder folder_;
};

/// A widget or object by its object name; aborts the program if there is none.
template <typename W>
W& child(const QObject& parent, const char* name) {
  W* found = parent.findChild<W*>(QLatin1String(name));
  if (found == nullptr) qFatal("there is no %s", name);
  return *found;
}

// Mouse operations; pending layouts are completed first.
void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = {});
/// Presses, moves to the end by way of the middle, and releases; `moved` is called after each move.
void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          const std::function<void()>& moved = {}, Qt::KeyboardModifiers modifiers = {});
void turnWheel(QWidget& widget, const QPoint& at, int notches);
void click(QWidget& widget);
void click(const QWidget& parent, const char* button);

/// The text of the tool tip at a place of a widget.
QString shownTip(QWidget& widget, const QPoint& at);

/// The index that shows `text` in a column, anywhere in the tree; invalid if there is none.
QModelIndex find(const QTreeView& tree, const QString& text, int column = 0);
void clickCell(QTreeView& tree, const QModelIndex& index);

/// Whether two colors differ by at most `tolerance` in each channel.
bool isNear(const QColor& a, const QColor& b, int tolerance = 12);
/// Number of pixels of a picture that are near a color.
int countNear(const QImage& picture, const QColor& color, int tolerance = 12);

/// Saves a picture in the folder ROBOTCONTROL_TEST_PICTURES, for visual inspection; does nothing if that is
/// not set. A widget is saved in light and dark.
void keepPicture(const QImage& picture, const char* name);
void keepPicture(QWidget& widget, const char* name);

}  // namespace widgets::test
