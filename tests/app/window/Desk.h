// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QDeadlineTimer>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>
#include <filesystem>
#include <optional>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/app/MadeUpRobots.h"
#include "tests/widgets/Bench.h"
#include "widgets/color/ColorBench.h"

namespace app::test {

using widgets::test::child;
using widgets::test::click;
using widgets::test::find;

/// Maximum time to wait for a condition, also on a machine that does much else.
constexpr int kWaitMs = 60'000;

/// Waits until a condition holds; false if it never does. QTest::qWaitFor() looks only when no event is left,
/// which on a busy machine, where each tick of a window takes longer than the next one is away, is at the
/// end.
template <typename Condition>
bool comes(Condition condition) {
  constexpr int kBetweenLooksMs = 10;
  const QDeadlineTimer end(kWaitMs);
  while (!condition()) {
    if (end.hasExpired()) return false;
    QTest::qWait(kBetweenLooksMs);
  }
  return true;
}

/// A workbench with its window and a settings folder of its own, with functions for what a user does.
/// Destroying it and creating another one with the same folder is a restart.
class Desk {
 public:
  enum class Opens : std::uint8_t { kNothing, kScene };

  explicit Desk(const std::filesystem::path& home, Opens opens = Opens::kScene)
      : workbench(home), window(workbench, home) {
    workbench.search().listenBy(network.source());
    window.resize(1600, 1000);
    window.show();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window never became active");
    if (opens == Opens::kScene) workbench.open(SimulationFeed::opening(defaultSimulation()));
  }

  /// Whether the simulation is loaded and has published its status.
  bool loaded() { return workbench.loaded() != nullptr && status() != nullptr; }
  /// The newest status; null if there is none.
  const robotcontrol::SimulationStatus* status() {
    return workbench.session().store().latestAs<robotcontrol::SimulationStatus>(
        "simulation", workbench.session().timeline().newest());
  }
  /// The true position of the robot.
  std::optional<robotlink::Vector3> robot() {
    const auto* message = workbench.session().store().latestAs<foxglove::FrameTransforms>(
        "transforms", workbench.session().timeline().newest());
    if (message == nullptr) return std::nullopt;
    for (const auto& transform : message->transforms()) {
      if (transform.child_frame_id() == "red1") return robotlink::vector3(transform.translation());
    }
    return std::nullopt;
  }
  /// A widget or object by its name; aborts the test if there is none.
  template <typename W>
  W& find(const char* name) {
    return child<W>(window, name);
  }
  bool has(const char* name) const { return window.findChild<QObject*>(QLatin1String(name)) != nullptr; }
  /// Clicks the button of an action in a toolbar.
  void click(const char* action, const char* bar = "simulationToolBar") {
    auto* button = qobject_cast<QToolButton*>(find<QToolBar>(bar).widgetForAction(&find<QAction>(action)));
    if (button == nullptr) qFatal("there is no button for %s", action);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// Opens the menu that contains an action and clicks its entry.
  void choose(const char* action) {
    QAction& entry = find<QAction>(action);
    for (QWidget* widget : entry.associatedWidgets()) {
      auto* menu = qobject_cast<QMenu*>(widget);
      if (menu == nullptr) continue;
      menu->popup(window.mapToGlobal(QPoint(20, 40)));
      return QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(&entry).center());
    }
    qFatal("%s is in no menu", action);
  }

  widgets::ColorBench& colors() { return *window.context().colors; }

  /// What is announced there, rather than on the network of the machine.
  MadeUpRobots network;
  Workbench workbench;
  MainWindow window;
};

/// A desk without a scene, which takes a third of the time.
class EmptyDesk : public Desk {
 public:
  explicit EmptyDesk(const std::filesystem::path& home) : Desk(home, Opens::kNothing) {}
};

/// Lets what was deleted later go, and looks at everything once more.
inline void settle(Desk& desk) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QCoreApplication::processEvents();
  desk.window.tick();
}

}  // namespace app::test
