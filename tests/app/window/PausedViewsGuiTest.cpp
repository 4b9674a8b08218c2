// SPDX-License-Identifier: GPL-3.0-or-later
// Views that are opened in a pause: they show what there is, though no frame runs that would publish it.
#include <qtadvanceddocking/DockWidget.h>
#include <QLabel>

#include "app/core/program/ShippedFiles.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

/// A desk without views, with a simulation that ran for a while and is paused.
class PausedDesk : public EmptyDesk {
 public:
  explicit PausedDesk(const std::filesystem::path& home) : EmptyDesk(home) {}

  bool run(const std::string& line) { return workbench.commands().runLine(line).has_value(); }
  /// Runs a scene for so long, beginning with a command; returns whether that was possible.
  bool runAndPause(const std::string& scene, double seconds, const std::string& first = {}) {
    window.docks().closeAll();
    RunOptions options = defaultSimulation();
    options.scene = sceneNamed(scene);
    workbench.open(SimulationFeed::opening(options));
    if (!comes([&] { return loaded(); })) return false;
    for (const char* robot : {"red1", "blue1"}) {
      if (!first.empty() && !(run(std::string("robot.select ") + robot) && run(first))) return false;
    }
    if (!run("simulation.start")) return false;
    const auto now = [&] { return robotlink::seconds(workbench.session().timeline().newest()); };
    if (!comes([&] { return now() > seconds; })) return false;
    return run("simulation.pause") && comes([&] { return status() != nullptr && !status()->running(); });
  }
  widgets::View* open(const char* id) {
    ads::CDockWidget* dock = window.docks().open(QLatin1String(id));
    dock->setAsCurrentTab();
    return qobject_cast<widgets::View*>(dock->widget());
  }
};

/// The texts that say why there is nothing, in a view or parts of it.
QStringList hints(const QWidget& view) {
  QStringList texts;
  for (const QLabel* hint : view.findChildren<QLabel*>(QStringLiteral("emptyHint")))
    if (hint->isVisible() && !hint->text().isEmpty()) texts << hint->text();
  return texts;
}

}  // namespace

class PausedViewsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void viewsOpenedInAPauseShowWhatThereIs_data() {
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("robot");
    QTest::addColumn<QStringList>("views");
    // What each shows as numbers contains these texts.
    QTest::addColumn<QStringList>("texts");
    const auto add = [](const char* scene, const char* robot,
                        const std::vector<std::pair<const char*, const char*>>& all) {
      QStringList views, texts;
      for (const auto& [view, text] : all) {
        views << QString::fromLatin1(view);
        texts << QString::fromLatin1(text);
      }
      QTest::newRow(scene) << QString::fromLatin1(scene) << QString::fromLatin1(robot) << views << texts;
    };
    add("game2002-1", "blue1",
        {{"behavior", "take place\t"},
         {"game", "blue1\tblue\t1"},
         {"image", "\t"},
         {"field", "estimate\tblue1\t"},
         {"joints", "headPan\t"},
         {"timing", "self-localisation\tfield-monte-carlo"},
         {"data", "the behavior's state (behavior/state)"},
         {"robots", "behavior: soccer"},
         {"processes", "cognition\trunning"},
         {"solutions", "field-monte-carlo"},
         {"debug-keys", "ball-percept"},
         {"motion", "soccer steers the robot"},
         {"camera", "Time of the image"},
         {"scene-tree", "ball"}});
    add("pioneer", "p3at1",
        {{"base-state", "State\tconnected"},
         {"radar", "laser\t0\t"},
         {"behavior", "follow-path\t"},
         {"field", "robot\tp3at1\t"},
         {"timing", "driving\tfollow-path"},
         {"data", "p3at1"}});
  }

  void viewsOpenedInAPauseShowWhatThereIs() {
    QFETCH(QString, scene);
    QFETCH(QString, robot);
    QFETCH(QStringList, views);
    QFETCH(QStringList, texts);
    PausedDesk desk(home_);
    QVERIFY(desk.runAndPause(scene.toStdString(), 1));
    QVERIFY(desk.run("robot.select " + robot.toStdString()));
    const auto instant = desk.workbench.session().timeline().newest();
    for (int i = 0; i < views.size(); ++i) {
      widgets::View* view = desk.open(qPrintable(views[i]));
      const auto isThere = [&] { return view->numbers().value_or(QString()).contains(texts[i]); };
      QVERIFY2(comes(isThere), qPrintable(views[i]));
      QVERIFY2(hints(*view).isEmpty(), qPrintable(views[i] + hints(*view).join(QLatin1Char(' '))));
    }
    QVERIFY(!desk.status()->running());
    QCOMPARE(desk.workbench.session().timeline().newest(), instant);
  }

  void theBehaviorOfAnotherRobotIsShownInAPause() {
    PausedDesk desk(home_);
    QVERIFY(desk.runAndPause("game2002-1", 1));
    widgets::View* view = desk.open("behavior");
    for (const char* robot : {"red1", "blue1"}) {
      QVERIFY(desk.run(std::string("robot.select ") + robot));
      QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>("behaviorNow").text().contains(QStringLiteral("take place")),
                               kWaitMs);
      QVERIFY(hints(*view).isEmpty());
      // The graph is sent once a second only, and is there, too.
      QTRY_VERIFY_WITH_TIMEOUT(desk.find<QAction>("behaviorReleaseAction").isEnabled(), kWaitMs);
    }
  }
};

const widgets::test::GuiTest<PausedViewsGuiTest> kPausedViewsGuiTest;

}  // namespace app::test

#include "PausedViewsGuiTest.moc"
