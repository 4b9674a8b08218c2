// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>
#include <filesystem>
#include <optional>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"

/// Maximum time to wait for a condition.
constexpr int kWaitMs = 20000;

/// A workbench with its window and a settings folder of its own, with functions for what a user does.
/// Destroying it and creating another one with the same folder is a restart.
class Desk {
 public:
  explicit Desk(const std::filesystem::path& home) : workbench(home), window(workbench, home) {
    window.resize(1600, 1000);
    window.show();
    workbench.load(app::Workbench::defaultOptions());
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
  template <typename W>
  /// A widget or object by its name; aborts the test if there is none.
  W& find(const char* name) {
    auto* widget = window.findChild<W*>(QLatin1String(name));
    if (widget == nullptr) qFatal("there is no %s", name);
    return *widget;
  }
  bool has(const char* name) const { return window.findChild<QObject*>(QLatin1String(name)) != nullptr; }
  /// Clicks the toolbar button of an action.
  void click(const char* action) {
    auto* button = qobject_cast<QToolButton*>(
        find<QToolBar>("simulationToolBar").widgetForAction(&find<QAction>(action)));
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

  app::Workbench workbench;
  app::MainWindow window;
};
