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
#include "app/robotcontrol/ViewDocks.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"

constexpr int kWaitMs = 20000;

/// A workbench with its window, on a home of its own, and what a person does with it. Closing and making
/// another one is a restart.
class Desk {
 public:
  explicit Desk(const std::filesystem::path& home) : workbench(home), window(workbench, home) {
    window.resize(1600, 1000);
    window.show();
    workbench.load(app::Workbench::defaultOptions());
  }

  bool loaded() { return workbench.loaded() != nullptr && status() != nullptr; }
  const robotcontrol::SimulationStatus* status() {
    return workbench.session().store().latestAs<robotcontrol::SimulationStatus>(
        "simulation", workbench.session().timeline().newest());
  }
  /// Where the robot truly is.
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
  W& find(const char* name) {
    auto* widget = window.findChild<W*>(QLatin1String(name));
    if (widget == nullptr) qFatal("there is no %s", name);
    return *widget;
  }
  bool has(const char* name) const { return window.findChild<QObject*>(QLatin1String(name)) != nullptr; }
  /// Clicks an action's button in the toolbar.
  void click(const char* action) {
    auto* button = qobject_cast<QToolButton*>(
        find<QToolBar>("simulationToolBar").widgetForAction(&find<QAction>(action)));
    if (button == nullptr) qFatal("there is no button for %s", action);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// Opens the menu that an action is in, and clicks the action there.
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
