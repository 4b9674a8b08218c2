// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring, trails and several views of the field, as a user uses them.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/FieldBench.h"
#include "widgets/RobotChoice.h"
#include "widgets/field/FieldCanvas.h"
#include "widgets/field/FieldView.h"

namespace widgets::test {
namespace {

struct MeasuredField {
  FieldBench world;
  FieldView view{world.context};
  FieldCanvas* canvas = &child<FieldCanvas>(view, "fieldCanvas");

  MeasuredField() {
    view.resize(900, 640);
    view.show();
    if (!QTest::qWaitForWindowActive(&view)) qFatal("the view's window never became active");
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {0.5, -0.4});
    step();
  }
  void step() {
    world.advance();
    view.tick();
  }
  /// The robot drives along y = 0.5 at 1 m/s, believing itself half a meter to the right.
  void drive(double seconds) {
    for (double t = 0; t < seconds; t += 0.04) {
      x += 0.04;
      world.pushPoses({x, 0.5, 0}, {0.5, -0.4});
      world.pushEstimates({x, 0, 0}, {0.3, 0});
      step();
    }
  }
  QPoint at(double fieldX, double y) const { return canvas->transform().map(QPointF(fieldX, y)).toPoint(); }
  void clickAt(double fieldX, double y) { QTest::mouseClick(canvas, Qt::LeftButton, {}, at(fieldX, y)); }
  QString text(const char* label) const { return child<QLabel>(view, label).text(); }
  /// Chooses an entry of the menu of trails.
  void choose(const char* entry) {
    auto& menu = child<QMenu>(view, "fieldTrailMenu");
    menu.popup(view.mapToGlobal(QPoint(10, 30)));
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(&child<QAction>(menu, entry)).center());
    step();
  }
  std::size_t trail(const std::string& model) const {
    const auto& trails = canvas->figures().trails;
    const auto found = trails.find(model);
    return found == trails.end() ? 0 : found->second.size();
  }

  double x = -1;
};

}  // namespace

class FieldToolsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void millimetersAndDegreesAreMeasured() {
    MeasuredField s;
    s.canvas->setFocus();
    QTest::keyClick(s.canvas, Qt::Key_L);
    s.clickAt(0, 0);
    s.clickAt(1, 0);
    s.clickAt(1, 1);
    const QString text = s.text("fieldMeasureText");
    const auto isNearText = [&](const QString& before, double wanted, double tolerance) {
      const int from = text.indexOf(before) + before.size();
      int to = from;
      while (to < text.size() &&
             (text[to].isDigit() || text[to] == QLatin1Char('-') || text[to] == QLatin1Char('.')))
        ++to;
      return std::abs(text.mid(from, to - from).toDouble() - wanted) < tolerance;
    };
    QVERIFY2(isNearText(QStringLiteral("AB "), 1000, 12), qPrintable(text));
    QVERIFY2(isNearText(QStringLiteral("angle at B "), 90, 1), qPrintable(text));
    keepPicture(s.view, "field-measure");
    QTest::keyClick(s.canvas, Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(QApplication::clipboard()->text(), text);
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(!child<QAction>(s.view, "fieldMeasureAction").isChecked());
  }

  void nothingIsMovedWhileMeasuring() {
    MeasuredField s;
    click(s.view, "fieldMeasure");
    s.world.requests.clear();
    s.step();
    drag(*s.canvas, Qt::LeftButton, s.at(-1, 0.5), s.at(0.5, 0.5), [&] { s.view.tick(); });
    s.step();
    QVERIFY2(s.world.requests.empty(), "the robot was dragged");
    QVERIFY(s.text("fieldMeasureText").contains(QStringLiteral("AB 15")) ||
            s.text("fieldMeasureText").contains(QStringLiteral("AB 14")));
  }

  void trailsAreAsLongAndOfWhatWasChosen() {
    MeasuredField s;
    s.drive(4);
    QVERIFY(s.canvas->figures().trails.empty());
    click(s.view, "fieldTrails");
    s.step();
    QVERIFY(s.trail("red1") > 35);
    QVERIFY(s.trail("ball") > 35);
    QCOMPARE(s.trail("red1/estimate"), std::size_t{0});
    s.choose("trailSeconds2");
    QVERIFY2(s.trail("red1") >= 19 && s.trail("red1") <= 20, "two seconds in steps of a tenth");
    s.choose("trailBall");
    QCOMPARE(s.trail("ball"), std::size_t{0});
    s.choose("trailEstimates");
    QVERIFY(s.trail("red1/estimate") >= 19);
    keepPicture(s.view, "field-trails");
    const QJsonObject state = s.view.saveState();
    FieldView other(s.world.context);
    other.restoreState(state);
    other.tick();
    const auto& trails = child<FieldCanvas>(other, "fieldCanvas").figures().trails;
    QVERIFY(trails.contains("red1/estimate") && !trails.contains("ball"));
  }

  void trailsFollowWhatTheTimelineShows() {
    MeasuredField s;
    click(s.view, "fieldTrails");
    s.choose("trailSeconds2");
    s.drive(6);
    s.world.session.history().show(robotlink::Instant(robotlink::fromSeconds(3)));
    s.step();
    const auto& places = s.canvas->figures().trails.at("red1");
    QVERIFY2(std::abs(places.back().x() - 1) < 0.15, "where it was then");
    QVERIFY(std::abs(places.front().x() - -0.9) < 0.2);
  }

  void theTitleSaysWhoseBeliefsAreShown() {
    MeasuredField s;
    QSignalSpy titles(&s.view, &View::titleChanged);
    s.world.session.setRobots({"red1", "blue1"});
    s.step();
    child<RobotChoice>(s.view, "fieldRobot").setChoice(QStringLiteral("blue1"));
    QCOMPARE(titles.last().first().toString(), QStringLiteral("Field, blue1"));
    FieldView other(s.world.context);
    QVERIFY2(child<RobotChoice>(other, "fieldRobot").choice().isEmpty(), "each view chooses for itself");
    other.restoreState(s.view.saveState());
    QCOMPARE(child<RobotChoice>(other, "fieldRobot").choice(), QStringLiteral("blue1"));
  }
};

const GuiTest<FieldToolsTest> kFieldToolsTest;

}  // namespace widgets::test

#include "FieldToolsTest.moc"
