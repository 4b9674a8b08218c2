// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QLabel>
#include <QTabBar>
#include <QTableView>
#include <memory>
#include <string>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/commands/CommandCatalog.h"
#include "tests/widgets/Bench.h"
#include "tests/widgets/sceneedit/ToyLanguage.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEditorCommands.h"
#include "widgets/sceneedit/SceneEditorView.h"
#include "widgets/sceneedit/SceneTextEdit.h"

namespace widgets::test {

inline const std::string kRoom =
    "<sdf>\n"
    "  <world name=\"room\">\n"
    "    <include>\n"
    "      <uri>model://rover</uri>\n"
    "      <name>rover1</name>\n"
    "    </include>\n"
    "    <model name=\"desk\">\n"
    "      <link name=\"top\"/>\n"
    "    </model>\n"
    "  </world>\n"
    "</sdf>\n";
inline const std::string kRover =
    "<sdf>\n"
    "  <model name=\"rover\">\n"
    "    <link name=\"head\">\n"
    "      <sensor name=\"camera\"/>\n"
    "    </link>\n"
    "  </model>\n"
    "</sdf>\n";

/// A window with the scene editor, in which a room is simulated that has a rover from another file.
struct RoomBench : Bench {
  RoomBench() : room(folder.write("room.sdf", kRoom)), rover(folder.write("rover.sdf", kRover)) {
    context.sceneLanguage = std::make_shared<ToyLanguage>();
    commands = robotlink::CommandTable(robotlink::commandCatalog());
    commands.attach("view.show", [](const auto&) -> robotlink::Result<void> { return {}; });
    commands.attach("scene.reload", [this](const auto&) -> robotlink::Result<void> {
      ++reloads;
      return {};
    });
    attachSceneEditorCommands(context);
  }
  void simulate() {
    robotcontrol::SimulationStatus status;
    status.set_scene(room.string());
    push("simulation", status, 2);
    session.tick();
  }
  void show() {
    view = open<SceneEditorView>({1000, 700});
    QCOMPARE(refusal("scene.edit " + room.string()), std::string());
    tick(*view);
  }
  std::string refusal(const std::string& line) {
    const auto done = commands.runLine(line);
    return done ? std::string() : done.error().id;
  }
  SceneBench& bench() { return sceneBench(context); }
  SceneTextEdit& text() const { return child<SceneTextEdit>(*view, "sceneText"); }
  std::string shown() const { return text().toPlainText().toStdString(); }
  std::string saved() const { return robotlink::readFile(room).value_or(""); }
  QAbstractItemView& proposals() const {
    auto* list = QApplication::activePopupWidget();
    if (list == nullptr) qFatal("nothing is proposed");
    return *qobject_cast<QAbstractItemView*>(list);
  }
  QTableView& problems() const { return child<QTableView>(*view, "sceneProblems"); }
  QTabBar& tabs() const { return child<QTabBar>(*view, "sceneTabs"); }
  /// Sets the cursor behind a text.
  void setCursor(const char* behind) {
    const QString word = QLatin1String(behind);
    QTextCursor cursor(text().document());
    cursor.setPosition(text().toPlainText().indexOf(word) + word.size());
    text().setTextCursor(cursor);
    text().setFocus();
  }
  int line() const { return text().textCursor().blockNumber() + 1; }
  /// Ticks until there are as many problems.
  bool waitForProblems(int count) {
    return QTest::qWaitFor([this, count] {
      tick(*view);
      return problems().model()->rowCount() == count && bench().current()->isChecked();
    });
  }
  const TestFolder folder;
  const std::filesystem::path room, rover;
  int reloads = 0;
  std::unique_ptr<SceneEditorView> view;
};

}  // namespace widgets::test
