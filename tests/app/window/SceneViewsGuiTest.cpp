// SPDX-License-Identifier: GPL-3.0-or-later
// Views of a simulated scene: commands about its objects, and the views with which each scene was left.
#include <qtadvanceddocking/DockWidget.h>
#include <QJsonArray>
#include <QJsonObject>
#include <QLabel>
#include <algorithm>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Session.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/scene/SceneView.h"

namespace app::test {
namespace {

struct ScenesDesk : Desk {
  using Desk::Desk;
  /// The error's id; empty: none.
  QString run(const char* line) {
    const auto done = workbench.commands().runLine(line);
    return done ? QString() : QString::fromStdString(done.error().id);
  }
  std::vector<ads::CDockWidget*> scenes() { return window.docks().docks(QStringLiteral("scene")); }
  QJsonObject state(std::size_t view = 0) {
    return qobject_cast<widgets::SceneView*>(scenes().at(view)->widget())->saveState();
  }
  bool hasObjects() {
    return workbench.session().store().latest("objects", workbench.session().timeline().newest()) != nullptr;
  }
  /// Opens a scene by its name, and waits until it is there.
  bool open(const char* name) {
    const auto before = workbench.loaded() == nullptr ? std::string() : workbench.loaded()->sources.front();
    if (!run((std::string("simulation.open ") + name).c_str()).isEmpty()) return false;
    return comes([&] {
      return workbench.loaded() != nullptr && workbench.loaded()->sources.front() != before && hasObjects();
    });
  }
};

}  // namespace

class SceneViewsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void objectsAreHiddenDrawnAndFollowedByCommands() {
    ScenesDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasObjects(), 20000);
    QCOMPARE(desk.run("view.show scene"), QString());
    for (const char* line :
         {"scene.view flat", "scene.hide ball", "scene.opacity red1 0.5", "scene.draw red1/link:head wire",
          "scene.layer solids", "scene.layer shadows off", "scene.follow ball heading"})
      QCOMPARE(desk.run(line), QString());
    const auto hidden = desk.workbench.commands().find("scene.show")->offer({});
    QVERIFY(std::ranges::count(hidden, "ball") == 1 && std::ranges::count(hidden, "red1") == 0);
    const QJsonObject state = desk.state();
    QCOMPARE(state[QStringLiteral("looks")].toArray().size(), 3);
    QCOMPARE(state[QStringLiteral("followed")].toString(), QStringLiteral("ball"));
    QVERIFY(state[QStringLiteral("modes")].toObject()[QStringLiteral("solids")].toBool());
    QCOMPARE(desk.run("scene.show ''"), QString());
    QCOMPARE(desk.state()[QStringLiteral("looks")].toArray().size(), 2);
    QCOMPARE(desk.run("scene.hide nobody"), QStringLiteral("scene.object"));
    QCOMPARE(desk.run("scene.view flat plots"), QStringLiteral("view.kind"));
    QCOMPARE(desk.run("scene.open red1 alone"), QString());
    QCOMPARE(desk.scenes().size(), std::size_t{2});
    QCOMPARE(desk.state(1)[QStringLiteral("only")].toString(), QStringLiteral("red1"));
    QVERIFY(desk.scenes().at(1)->windowTitle().contains(QStringLiteral("red1")));
  }

  void aScreenshotShowsViewsThatWereJustOpenedInFull() {
    ScenesDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasObjects(), 20000);
    const std::string picture = "'" + (home_ / "window.png").string() + "'";
    QCOMPARE(desk.run("view.perspective Drive"), QString());
    QCOMPARE(desk.run(("view.screenshot window " + picture).c_str()), QString());
    const auto& robot = desk.find<QLabel>("motionRobot");
    QCOMPARE(robot.text(), QStringLiteral("red1"));
    QVERIFY(robot.width() >= robot.sizeHint().width());
  }

  void aRobotThatIsRenamedStaysSelected() {
    ScenesDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasObjects(), 20000);
    QVERIFY(desk.open("mixed"));
    auto& session = desk.workbench.session();
    session.selectRobot("red1");
    desk.window.tick();
    QCOMPARE(desk.run("scene.rename red1 rex"), QString());
    QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(session.selectedRobot()), QStringLiteral("rex"), 20000);
  }

  void aRobotThatIsRenamedStaysSelectedThoughItsSceneWasListedBeforeIt() {
    Desk desk(home_, Desk::Opens::kNothing);
    auto& session = desk.workbench.session();
    double time = 0;
    const auto showObjects = [&](std::initializer_list<const char*> names) {
      auto objects = std::make_shared<robotcontrol::WorldObjects>();
      for (const char* name : names) objects->add_objects()->set_path(name);
      session.push({"objects", robotlink::Instant(robotlink::fromSeconds(++time)), objects});
      desk.window.tick();
    };
    session.setRobots({"first"});
    desk.window.tick();
    showObjects({"red1", "red2"});
    session.setRobots({"red1", "red2"});
    session.selectRobot("red2");
    desk.window.tick();
    showObjects({"red1", "rex"});
    session.setRobots({"red1", "rex"});
    desk.window.tick();
    QCOMPARE(session.selectedRobot(), std::string("rex"));
  }

  void eachSceneHasTheViewsWithWhichItWasLeft() {
    ScenesDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.hasObjects(), 20000);
    for (const char* line : {"view.show scene", "scene.view wire", "scene.hide ball", "view.show columns"})
      QCOMPARE(desk.run(line), QString());
    const std::string first = desk.workbench.loaded()->sources.front();
    QVERIFY(desk.open("pioneer"));
    for (const char* line : {"view.close columns", "scene.view shaded", "scene.show ''"})
      QCOMPARE(desk.run(line), QString());
    QVERIFY(desk.open(first.c_str()));
    QTRY_VERIFY(desk.window.docks().isOpen(QStringLiteral("columns")));
    const QJsonObject state = desk.state();
    QCOMPARE(state[QStringLiteral("modes")].toObject()[QStringLiteral("surface")].toString(),
             QStringLiteral("wire"));
    QCOMPARE(state[QStringLiteral("looks")].toArray().size(), 1);
    QVERIFY(desk.open("pioneer"));
    QTRY_VERIFY(!desk.window.docks().isOpen(QStringLiteral("columns")));
  }
};

const widgets::test::GuiTest<SceneViewsGuiTest> kSceneViewsGuiTest;

}  // namespace app::test

#include "SceneViewsGuiTest.moc"
