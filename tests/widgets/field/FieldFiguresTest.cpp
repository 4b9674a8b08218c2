// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldFigures.h"

#include <QPainter>

#include "tests/widgets/Bench.h"
#include "tests/widgets/GuiTest.h"

namespace widgets::test {
namespace {

/// 100 pixels a meter, the origin in the middle of 400 x 400 pixels, y up.
const QTransform kFieldToWidget(100, 0, 0, -100, 200, 200);

RobotBelief beliefAt(const char* name, std::optional<robotlink::Pose2> truth,
                     std::optional<robotlink::Pose2> estimate = std::nullopt) {
  RobotBelief belief;
  belief.robot = name;
  belief.team = QColor(255, 0, 0);
  belief.body = {0.5, 0.4};
  belief.truth = truth;
  belief.estimate = estimate;
  return belief;
}

QImage figuresPicture(const FieldFigures& figures) {
  QImage picture(400, 400, QImage::Format_RGB32);
  picture.fill(QColor(0, 90, 0));
  QPainter painter(&picture);
  paintFigures(painter, figures, kFieldToWidget, QApplication::palette());
  return picture;
}

/// Pixels that were painted around a place on the field (m).
int paintedAround(const QImage& picture, const QPointF& place, int reach = 20) {
  const QPoint middle = kFieldToWidget.map(place).toPoint();
  return (2 * reach + 1) * (2 * reach + 1) -
         countNear(picture.copy(QRect(middle - QPoint(reach, reach), middle + QPoint(reach, reach))),
                   QColor(0, 90, 0), 0);
}

}  // namespace

class FieldFiguresTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotIsFoundWithinItsBodyAsItIsTurned() {
    FieldFigures figures;
    figures.robots = {beliefAt("p3at", robotlink::Pose2{1, 1, 0})};
    QCOMPARE(robotAt(figures, {1.2, 1}, 0), std::string("p3at"));
    QCOMPARE(robotAt(figures, {1, 1.24}, 0), std::string());
    figures.robots[0].truth->heading = 1.5707963267948966;
    QCOMPARE(robotAt(figures, {1, 1.24}, 0), std::string("p3at"));
    QCOMPARE(robotAt(figures, {1, 1.3}, 0), std::string());
    QCOMPARE(robotAt(figures, {1, 1.3}, 0.1), std::string("p3at"));
  }

  void anEstimateCountsOnlyWhereTheTruthIsUnknownAndCannotBeDragged() {
    FieldFigures figures;
    figures.robots = {beliefAt("real", std::nullopt, robotlink::Pose2{-1, 0, 0}),
                      beliefAt("simulated", robotlink::Pose2{1, 0, 0}, robotlink::Pose2{0, 1, 0})};
    QCOMPARE(robotAt(figures, {-1, 0}, 0), std::string("real"));
    QCOMPARE(robotAt(figures, {0, 1}, 0), std::string());
    QCOMPARE(figureAt(figures, {-1, 0}, 0), std::string());
    QCOMPARE(figureAt(figures, {1, 0}, 0), std::string("simulated"));
  }

  void aRobotIsBeforeTheBallThatLiesAtIt() {
    FieldFigures figures;
    figures.ball = robotlink::Vector2(1.2, 0);
    QCOMPARE(figureAt(figures, {1.2, 0.04}, 0), std::string("ball"));
    QCOMPARE(figureAt(figures, {1.2, 0.05}, 0), std::string());
    QCOMPARE(figureAt(figures, {1.2, 0.05}, 0.02), std::string("ball"));
    figures.robots = {beliefAt("p3at", robotlink::Pose2{1, 0, 0})};
    QCOMPARE(figureAt(figures, {1.2, 0.04}, 0), std::string("p3at"));
  }

  void figuresArePaintedWhereTheyAre() {
    FieldFigures figures;
    QCOMPARE(paintedAround(figuresPicture(figures), {1, 1}), 0);
    figures.robots = {beliefAt("p3at", robotlink::Pose2{1, 1, 0}, robotlink::Pose2{-1, 1, 0})};
    figures.ball = robotlink::Vector2(-1, -1);
    const QImage picture = figuresPicture(figures);
    QVERIFY(paintedAround(picture, {1, 1}) > 100);
    QVERIFY(paintedAround(picture, {-1, 1}) > 20);
    QCOMPARE(paintedAround(picture, {1, -1}), 0);
    QVERIFY(countNear(picture, figures.ballColor, 30) > 20);
  }

  void linesLeadFromTheTruthToWhatIsBelieved() {
    FieldFigures figures;
    figures.robots = {beliefAt("p3at", robotlink::Pose2{-1, 1, 0}, robotlink::Pose2{1, 1, 0})};
    figures.robots[0].ball = robotlink::Vector2(1, -1);
    figures.ball = robotlink::Vector2(-1, -1);
    const QImage without = figuresPicture(figures);
    QCOMPARE(paintedAround(without, {0, 1}), 0);
    QCOMPARE(paintedAround(without, {-0.5, -1}, 10), 0);
    figures.errorLines = true;
    const QImage with = figuresPicture(figures);
    QVERIFY2(paintedAround(with, {0, 1}) > 200, "the line, and the distance in a box");
    QVERIFY(paintedAround(with, {-0.5, -1}, 10) > 20);
    keepPicture(with, "error-lines");
  }

  void whatIsDraggedIsPaintedAtItsWantedPlace() {
    FieldFigures figures;
    QImage picture(400, 400, QImage::Format_RGB32);
    picture.fill(QColor(0, 90, 0));
    {
      QPainter painter(&picture);
      paintWanted(painter, {"ball", {1, -1, 0}, true, false}, figures, kFieldToWidget,
                  QApplication::palette());
    }
    QVERIFY(paintedAround(picture, {1, -1}) > 20);
    QCOMPARE(paintedAround(picture, {-1, -1}), 0);
  }
};

const GuiTest<FieldFiguresTest> kFieldFiguresTest;

}  // namespace widgets::test

#include "FieldFiguresTest.moc"
