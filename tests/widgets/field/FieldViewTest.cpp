// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListView>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>

#include "robotcontrol/Modeling.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/RobotChoice.h"
#include "widgets/field/FieldCanvas.h"
#include "widgets/field/FieldView.h"

namespace widgets::test {
namespace {

using robotlink::SceneDrawing;
using robotlink::Vector2;
namespace colors = robotlink::colors;

struct ShownField {
  FieldBench world;
  FieldView view{world.context};
  FieldCanvas* canvas = &child<FieldCanvas>(view, "fieldCanvas");

  ShownField() {
    view.resize(800, 600);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
  }
  void step() {
    world.advance();
    view.tick();
  }
  QPoint at(double x, double y) const { return canvas->transform().map(QPointF(x, y)).toPoint(); }
  QImage picture() const { return canvas->grab().toImage(); }
  QColor colorAt(double x, double y) const { return picture().pixelColor(at(x, y)); }
  QColor named(const char* name) const {
    const auto* color = world.context.field->color(name);
    return {color->r, color->g, color->b};
  }
  void click(const char* button) { test::click(view, button); }
  void wheel(const QPoint& position, int notches) { turnWheel(*canvas, position, notches); }
  QString text(const char* label) const { return child<QLabel>(view, label).text(); }
  void placeThings() {
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {0.5, -0.4});
    step();
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    test::drag(
        *canvas, Qt::LeftButton, from, to, [this] { view.tick(); }, modifiers);
  }
};

}  // namespace

class FieldViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aClickSelectsARobotAndMovesNothing() {
    ShownField s;
    s.world.session.setRobots({"blue1", "red1"});
    s.world.session.selectRobot("blue1");
    s.placeThings();
    moveMouse(*s.canvas, s.at(-1, 0.5));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(-1, 0.5));
    moveMouse(*s.canvas, s.at(-1, 0.5) + QPoint(2, 1), Qt::LeftButton);
    s.view.tick();
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(-1, 0.5) + QPoint(2, 1));
    QCOMPARE(s.world.session.selectedRobot(), std::string("red1"));
    QVERIFY(s.world.requests.empty());
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, s.at(1, 1));  // nobody stands there
    QCOMPARE(s.world.session.selectedRobot(), std::string("red1"));
  }

  void onlyTheSelectedRobotsBeliefsAreShown() {
    ShownField s;
    s.world.session.setRobots({"blue1", "red1"});
    s.placeThings();
    s.world.session.selectRobot("blue1");
    s.step();
    const QImage without = s.picture();
    s.world.pushEstimates({0.8, 0.9, 0}, {0.3, 0});
    s.step();
    const QRect around(s.at(0.8, 0.9) - QPoint(20, 20), QSize(40, 40));
    QVERIFY(s.picture().copy(around) == without.copy(around));
    s.world.session.selectRobot("red1");
    s.step();
    QVERIFY(s.picture().copy(around) != without.copy(around));
    child<RobotChoice>(s.view, "fieldRobot").setChoice(QStringLiteral("*"));
    s.world.session.selectRobot("blue1");
    s.step();
    QVERIFY(s.picture().copy(around) != without.copy(around));
  }

  void theFieldHasItsColors() {
    ShownField s;
    QVERIFY(isNear(s.colorAt(1.2, 0.9), s.named("green"), 2));
    QVERIFY(isNear(s.colorAt(0, 0.8), s.named("white"), 40));
    QVERIFY(isNear(s.colorAt(-2.11, 0.299), s.named("yellow"), 20));
    QVERIFY(isNear(s.colorAt(2.11, 0.299), s.named("skyblue"), 20));
    QVERIFY(isNear(s.colorAt(2.2, -1.45), s.named("pink"), 2));  // the upper band
    QVERIFY(isNear(s.colorAt(2.2, 1.45), s.named("skyblue"), 2));
    QVERIFY(isNear(s.colorAt(-2.05, 1.3), s.named("white"), 2));  // a corner's triangle
  }

  void anotherFieldIsFollowed() {
    ShownField s;
    const QRgb green = s.colorAt(1.2, 0.9).rgb();
    auto other = std::make_shared<robotlink::FieldDescription>(*s.world.context.field);
    other->length *= 1.5;
    const double before = s.canvas->transform().m11();
    s.world.context.field = other;
    s.step();
    QVERIFY(s.canvas->transform().m11() < before);
    s.world.context.field = nullptr;
    s.step();
    QVERIFY(s.colorAt(1.2, 0.9).rgb() != green);
  }

  void trueAndEstimatedPosesDiffer() {
    ShownField s;
    s.placeThings();
    QVERIFY(isNear(s.colorAt(-1.02, 0.5), s.named("red"), 2));
    QVERIFY(isNear(s.colorAt(0.5, -0.4), s.named("orange"), 2));
    s.world.pushEstimates({-0.5, -0.5, 0}, {0.8, 0.6});
    s.step();
    // An estimate is an outline on a tinted area, not filled: neither the robot's nor the bare field's
    // color.
    const QColor inside = s.colorAt(-0.55, -0.53);
    QVERIFY(!isNear(inside, s.named("red"), 30) && !isNear(inside, s.named("green"), 10));
    QVERIFY(!isNear(s.colorAt(0.3 + 0.06, 0.1), s.named("green"), 10));
  }

  void theCursorsPlaceIsShown() {
    ShownField s;
    moveMouse(*s.canvas, s.at(1, -0.5));
    const QStringList parts = s.text("fieldCursor").split(QLatin1Char(' '), Qt::SkipEmptyParts);
    QCOMPARE(parts.size(), 6);
    QVERIFY(std::abs(parts[1].toDouble() - 1) < 0.01 && std::abs(parts[4].toDouble() + 0.5) < 0.01);
  }

  void aDrawingIsToggledByAClickInTheList() {
    ShownField s;
    s.placeThings();
    s.world.pushFrame({worldDrawing("field", "ball-model/area", "field", [](SceneDrawing& d) {
      d.circle({1, 0.9}, 0.2, colors::kPink, 1, colors::kPink);
    })});
    s.step();
    QVERIFY(isNear(s.colorAt(1, 0.9), QColor(250, 90, 170)));
    s.click("fieldDrawings");
    auto* list = &child<QListView>(s.view, "drawingsList");
    QVERIFY(list->isVisible());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(0, 0)).topLeft() + QPoint(10, 8));
    QVERIFY(isNear(s.colorAt(1, 0.9), s.named("green")));
    s.click("fieldDrawings");
    QVERIFY(!list->isVisible());
  }

  void theRobotWhoseDrawingsAreShownIsChosenInItsBox() {
    ShownField s;
    s.world.session.setRobots({"red1", "blue1"});
    s.placeThings();
    s.world.pushFrame({worldDrawing("field", "ball-model/area", "field", [](SceneDrawing& d) {
      d.circle({1, 0.9}, 0.2, colors::kPink, 1, colors::kPink);
    })});
    s.step();
    QVERIFY(isNear(s.colorAt(1, 0.9), QColor(250, 90, 170)));
    auto* robots = &child<RobotChoice>(s.view, "fieldRobot");
    robots->setFocus();
    QTest::keyClick(robots, Qt::Key_End);
    QCOMPARE(robots->currentText(), QStringLiteral("blue1"));
    QVERIFY(isNear(s.colorAt(1, 0.9), s.named("green")));
  }

  void aDrawingRelativeToTheRobotLiesWhereTheRobotIs() {
    ShownField s;
    s.world.pushScene();
    s.world.pushPoses({0.5, 0, robotlink::kPi / 2}, {0, 0});
    s.world.pushFrame({worldDrawing("robot", "percept", "red1", [](SceneDrawing& d) {
      d.circle({0.8, 0}, 0.1, colors::kPink, 1, colors::kPink);
    })});
    s.step();
    QVERIFY(isNear(s.colorAt(0.5, 0.8), QColor(250, 90, 170)));
  }

  void theUserChoosesAtWhichPoseRobotsDrawingsLie() {
    ShownField s;
    const QColor pink(250, 90, 170);
    const auto publish = [&] {
      s.world.pushScene();
      s.world.pushPoses({0.5, 0, robotlink::kPi / 2}, {1, 1});
      s.world.pushEstimates({-1, -0.5, 0}, {0.3, 0});
      auto other = std::make_shared<robotcontrol::RobotPose>();
      other->mutable_robot_in_field()->set_x(-0.5);
      s.world.push("red1/other/pose", other);
      s.world.pushFrame({worldDrawing("robot", "percept", "red1", [](SceneDrawing& d) {
        d.circle({0.8, 0}, 0.1, colors::kPink, 1, colors::kPink);
      })});
      s.step();
    };
    publish();
    QVERIFY(s.view.choosePose("models/pose"));
    QVERIFY(isNear(s.colorAt(-0.2, -0.5), pink));
    QVERIFY(!isNear(s.colorAt(0.5, 0.8), pink));
    QVERIFY(s.view.choosePose("other/pose"));
    QVERIFY(isNear(s.colorAt(0.3, 0), pink));
    FieldView copy(s.world.context);
    copy.restoreState(s.view.saveState());
    QCOMPARE(copy.saveState()[QStringLiteral("pose")].toString(), QStringLiteral("other/pose"));
    QVERIFY(s.view.choosePose("true"));
    QVERIFY(isNear(s.colorAt(0.5, 0.8), pink));
    QVERIFY(s.view.choosePose("default"));
    QVERIFY(isNear(s.colorAt(0.5, 0.8), pink));
    const auto wrong = s.view.choosePose("other/poses");
    QVERIFY(!wrong && wrong.error().text.find("other/pose") != std::string::npos);
  }

  void withoutATruePoseNothingIsDrawnAtIt() {
    ShownField s;
    s.world.pushEstimates({-1, -0.5, 0}, {0.3, 0});
    s.world.pushFrame({worldDrawing("robot", "percept", "red1", [](SceneDrawing& d) {
      d.circle({0.8, 0}, 0.1, colors::kPink, 1, colors::kPink);
    })});
    s.step();
    QVERIFY(isNear(s.colorAt(-0.2, -0.5), QColor(250, 90, 170)));
    QVERIFY(s.view.choosePose("true"));
    QVERIFY(!isNear(s.colorAt(-0.2, -0.5), QColor(250, 90, 170)));
  }

  void whatASolutionDrawsInTheShadowIsDashedAndNamedInTheTip() {
    ShownField s;
    s.world.pushScene();
    const auto line = [](double y) {
      return worldDrawing("field", "ball-model/way", "field",
                          [y](SceneDrawing& d) { d.line(Vector2(-1, y), Vector2(1, y), colors::kPink, 4); });
    };
    s.world.pushFrame({line(-0.5), [&](robotcontrol::DebugQueue& queue) {
                         line(0.5)(queue);
                         auto& drawn = *queue.mutable_messages()->rbegin();
                         drawn.set_path("shadow/kalman/" + drawn.path());
                       }});
    s.step();
    const QImage picture = s.picture();
    const auto painted = [&](double y) {
      int count = 0;
      for (int x = s.at(-0.9, y).x(); x <= s.at(0.9, y).x(); ++x)
        count += isNear(picture.pixelColor(x, s.at(0, y).y()), QColor(250, 90, 170)) ? 1 : 0;
      return count;
    };
    const int length = s.at(0.9, 0).x() - s.at(-0.9, 0).x() + 1;
    QCOMPARE(painted(-0.5), length);
    QCOMPARE(painted(0.5), 0);
    const QColor ground = picture.pixelColor(s.at(0.5, 0.8));
    int gaps = 0;
    for (int x = s.at(-0.9, 0.5).x(); x <= s.at(0.9, 0.5).x(); ++x)
      gaps += picture.pixelColor(x, s.at(0, 0.5).y()) == ground ? 1 : 0;
    QVERIFY2(gaps > length / 10 && gaps < length, qPrintable(QString::number(gaps)));
    QString tip;
    for (int x = 0; x < 40 && tip.isEmpty(); ++x) tip = shownTip(*s.canvas, s.at(0, 0.5) + QPoint(x, 0));
    QVERIFY2(tip.contains(QStringLiteral("debug key ball-model/way, of kalman in the shadow")),
             qPrintable(tip));
  }

  void aTipNamesTheDrawingsUnderTheCursor() {
    ShownField s;
    s.world.pushScene();
    s.world.pushFrame({worldDrawing("field", "ball-model/area", "field",
                                    [](SceneDrawing& d) {
                                      d.circle({1, 0.5}, 0.2, colors::kPink, 1, colors::kPink);
                                      d.text({-1, 0.5}, "MMM<b>M", colors::kWhite, 20);
                                    }),
                       worldDrawing("field", "ball-model/dots", "field", [](SceneDrawing& d) {
                         d.dot({1, 0.5}, colors::kBlue);
                       })});
    s.step();
    const QString both = shownTip(*s.canvas, s.at(1, 0.5));
    QVERIFY2(both.contains(QStringLiteral("robot red1, debug key ball-model/area")), qPrintable(both));
    QVERIFY2(both.indexOf(QStringLiteral("<b>dots</b>")) < both.indexOf(QStringLiteral("<b>area</b>")),
             "the upper one is first");
    QVERIFY2(both.contains(QStringLiteral("(1.000, 0.500, ")), qPrintable(both));
    const QString text = shownTip(*s.canvas, s.at(-1, 0.5) + QPoint(8, -7));
    QVERIFY2(text.contains(QStringLiteral("MMM&lt;b&gt;M")), qPrintable(text));
    QVERIFY2(!shownTip(*s.canvas, s.at(0.2, -0.8)).contains(QStringLiteral("ball-model")),
             "nothing is there");
  }

  void aDamagedDrawingHarmsNothing() {
    ShownField s;
    s.placeThings();
    s.world.pushFrame({damagedDrawing("damaged", "field"), damagedDrawing("lost", "nowhere")});
    s.step();
    QVERIFY(isNear(s.colorAt(0.5, -0.4), s.named("orange"), 2));
    shownTip(*s.canvas, s.at(0.5, 0));
  }

  void zoomPanTurnAndFit() {
    ShownField s;
    const QPoint before = s.at(1, 0.5);
    s.wheel(before, 3);
    QVERIFY((s.at(1, 0.5) - before).manhattanLength() <= 2);
    QVERIFY(!s.canvas->viewport().fit);
    const QPoint origin = s.at(0, 0);
    s.drag({400, 50}, {440, 80});
    QCOMPARE(s.at(0, 0) - origin, QPoint(40, 30));
    const QPoint dragged = s.at(0, 0);
    for (const int key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Up}) QTest::keyClick(s.canvas, Qt::Key(key));
    QCOMPARE(s.at(0, 0) - dragged, QPoint(30, 60));
    for (const int key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Down}) QTest::keyClick(s.canvas, Qt::Key(key));
    QCOMPARE(s.at(0, 0), dragged);
    QTest::keyClick(s.canvas, Qt::Key_F);
    QVERIFY(s.canvas->viewport().fit);
    QTest::keyClick(s.canvas, Qt::Key_R);
    QVERIFY(s.at(1, 0).y() < s.at(0, 0).y() && s.at(1, 0).x() == s.at(0, 0).x());  // x points up
  }

  void theButtonsZoom() {
    ShownField s;
    const auto pixelsPerMetre = [&] { return s.text("fieldZoom").section(QLatin1Char(' '), 0, 0).toInt(); };
    s.step();
    const int fitted = pixelsPerMetre();
    s.click("fieldZoomIn");
    QVERIFY(pixelsPerMetre() > fitted);
    s.click("fieldZoomOut");
    s.click("fieldZoomOut");
    QVERIFY(pixelsPerMetre() < fitted);
    s.click("fieldFit");
    QCOMPARE(pixelsPerMetre(), fitted);
  }

  void draggingTheBallPlacesIt() {
    ShownField s;
    s.placeThings();
    s.drag(s.at(0.5, -0.4), s.at(1.0, 0.3));
    QVERIFY(s.world.requests.size() >= 2);
    const auto& place = s.world.requests.back().place_model();
    QCOMPARE(place.model(), std::string("ball"));
    QVERIFY(std::abs(place.pose_in_field().x() - 1.0) < 0.02 &&
            std::abs(place.pose_in_field().y() - 0.3) < 0.02);
  }

  void theWheelTurnsTheRobotThatIsDragged() {
    ShownField s;
    s.placeThings();
    const QPoint from = s.at(-1, 0.5);
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, from);
    s.wheel(from, 2);
    s.view.tick();
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, from);
    QCOMPARE(s.world.requests.size(), std::size_t(1));
    const auto& place = s.world.requests.back().place_model();
    QCOMPARE(place.model(), std::string("red1"));
    QVERIFY(std::abs(place.pose_in_field().heading() - 0.3 - robotlink::radians(30)) < 1e-6);
  }

  void withoutTheToolOnlyShiftMoves() {
    ShownField s;
    s.placeThings();
    s.click("fieldMove");
    s.drag(s.at(0.5, -0.4), s.at(0.6, -0.4));
    QVERIFY(s.world.requests.empty());
    s.drag(s.at(0.5, -0.4), s.at(0.6, -0.4), Qt::ShiftModifier);
    QVERIFY(!s.world.requests.empty());
  }

  void aRefusedPlaceIsShown() {
    ShownField s;
    s.placeThings();
    s.world.refusal = "it would stand in a wall";
    const QImage before = s.picture();
    s.drag(s.at(0.5, -0.4), s.at(1.9, 1.3));
    s.step();
    s.step();
    const QImage after = s.picture();
    const QRect top(200, 0, 400, 40);
    QVERIFY(before.copy(top) != after.copy(top));
    keepPicture(s.view, "field-refused");
    for (int i = 0; i < 70; ++i) s.step();
    QVERIFY(s.picture().copy(top) == before.copy(top));
  }

  void trailsShowWhereTheBallWas() {
    ShownField s;
    s.placeThings();
    for (int i = 0; i < 20; ++i) {
      s.world.pushPoses({-1, 0.5, 0.3}, {-0.5 + 0.05 * i, -0.9});
      s.world.advance(100);
    }
    s.view.tick();
    QVERIFY(isNear(s.colorAt(-0.1, -0.9), s.named("green"), 4));
    s.click("fieldTrails");
    QVERIFY(!isNear(s.colorAt(-0.1, -0.9), s.named("green"), 20));
  }

  void thePictureIsCopied() {
    ShownField s;
    s.placeThings();
    s.view.findChild<QAction*>(QStringLiteral("fieldCopyAction"))->trigger();
    QVERIFY(isNear(QApplication::clipboard()->image().pixelColor(s.at(0.5, -0.4)), s.named("orange"), 4));
  }

  void thePictureIsSavedWhereTheDialogSays() {
    ShownField s;
    s.placeThings();
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("field.png"));
    DialogAnswer answer = DialogAnswer::file(file);
    s.canvas->setFocus();
    QTest::keyClick(s.canvas, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(answer.asked());
    QVERIFY(isNear(QImage(file).pixelColor(s.at(0.5, -0.4)), s.named("orange"), 4));
  }

  void aPictureThatCannotBeSavedSaysWhy() {
    ShownField s;
    QString said;
    DialogAnswer answer([&](QDialog& dialog) {
      said = dynamic_cast<QMessageBox&>(dialog).text();
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    QVERIFY(!s.view.savePicture(QStringLiteral("/no/such/folder/field.png")));
    QVERIFY(answer.asked());
    QVERIFY2(said.contains(QStringLiteral("/no/such/folder/field.png")), qPrintable(said));
  }

  void whatTheUserChoseSurvives() {
    ShownField a;
    a.placeThings();
    a.click("fieldDrawings");
    a.click("fieldTrails");
    a.click("fieldTurn");
    a.wheel({300, 200}, 3);
    child<RobotChoice>(a.view, "fieldRobot").setChoice(QStringLiteral("*"));
    const QJsonObject state = a.view.saveState();
    ShownField b;
    b.view.restoreState(state);
    QCOMPARE(b.view.saveState(), state);
    b.view.restoreState({});  // harmless
  }

  void showsAWholePicture() {
    ShownField s;
    s.world.session.setRobots({"red1", "blue1"});
    s.placeThings();
    s.world.pushEstimates({-0.9, 0.35, 0.5}, {1.4, -1.5});
    s.world.pushFrame({worldDrawing("field", "particles", "field",
                                    [](SceneDrawing& d) {
                                      for (int i = 0; i < 60; ++i) {
                                        d.pose(
                                            {-0.9 + 0.15 * std::sin(i * 1.3), 0.35 + 0.12 * std::cos(i * 2.1),
                                             0.5 + 0.2 * std::sin(i * 3.0)},
                                            colors::kYellow, 0.06);
                                      }
                                      d.arrow({-0.9, 0.35}, {0.4, -0.3}, colors::kPink, 2);
                                      d.text({0.5, -0.2}, "go to ball", colors::kWhite, 13);
                                    }),
                       worldDrawing("robot", "percept", "red1", [](SceneDrawing& d) {
                         d.circle({1.7, -1.2}, 0.08, colors::kOrange, 2);
                       })});
    s.step();
    s.click("fieldDrawings");
    s.click("fieldTrails");
    moveMouse(*s.canvas, s.at(0.2, 0.2));
    keepPicture(s.view, "field-view");
    QVERIFY(countNear(s.picture(), QColor(250, 90, 170), 20) > 50);
  }
};

const GuiTest<FieldViewTest> kFieldViewTest;

}  // namespace widgets::test

#include "FieldViewTest.moc"
