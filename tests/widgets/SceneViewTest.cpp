// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/SyntheticWorld.h"
#include "widgets/RobotChoice.h"
#include "widgets/scene/EdgeSmoothing.h"
#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/SceneView.h"

namespace widgets::test {
namespace {

using robotlink::SceneDrawing;
using robotlink::Vector3;
namespace colors = robotlink::colors;

const Vector3 kBall(0.5, -0.4, 0.042);

struct Shown {
  SyntheticWorld world;
  SceneView view{world.context};
  SceneCanvas* canvas = child<SceneCanvas>(view, "sceneCanvas");

  Shown() {
    view.resize(480, 400);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    QTest::keyClick(canvas, Qt::Key_R);  // all of the field, so that it is known where things are
  }
  /// What the camera needs to come to rest.
  void settle() {
    for (int i = 0; i < 120; ++i) view.tick();
  }
  /// Waits, at a true thread boundary, for the picture that shows what is there now.
  bool step() {
    world.advance();
    view.tick();
    return QTest::qWaitFor([this] { return canvas->upToDate(); }, 10000);
  }
  bool placeThings() {
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});
    return step();
  }
  QPoint at(const Vector3& place) const { return canvas->camera().project(canvas->size(), place)->toPoint(); }
  QImage picture() const { return canvas->rendered(); }
  QColor colorAt(const Vector3& place) const { return picture().pixelColor(at(place)); }
  QColor named(const char* name) const {
    const auto* color = world.context.field->color(name);
    return {color->r, color->g, color->b};
  }
  void click(const char* button) { test::click(view, button); }
};

/// How much two pictures differ: the share of pixels that are not near.
double difference(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += isNear(a.pixelColor(x, y), b.pixelColor(x, y), 8) ? 0 : 1;
  }
  return double(count) / (a.width() * a.height());
}

}  // namespace

class SceneViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    failAtWarnings();
    const auto renderer = SceneRenderer::create();
    if (!renderer) QSKIP(renderer.error().text.c_str());
    qInfo("drawn by %s", renderer->device().c_str());
  }

  void withoutASceneItIsSaidWhy() {
    Shown s;
    QVERIFY(s.step());
    QVERIFY(s.canvas->hint().contains(QStringLiteral("start a simulation")));
    s.world.session.push({"replay", robotlink::Instant{}, std::make_shared<robotcontrol::ReplayStatus>()});
    QVERIFY(s.step());
    QVERIFY(s.canvas->hint().contains(QStringLiteral("log holds no scene")));
  }

  void theBallIsOrangeWhereItLies() {
    Shown s;
    QVERIFY(s.placeThings());
    const QColor ball = s.colorAt(kBall);
    QVERIFY2(std::abs(ball.hue() - s.named("orange").hue()) < 6 && ball.saturation() > 180,
             qPrintable(ball.name()));
    // What lies flat has its own colour.
    QVERIFY(isNear(s.colorAt({1.2, 0.8, 0}), s.named("green"), 8));
    QVERIFY(isNear(s.colorAt({-1, 0.5, 0.17}), s.named("red"), 60));
  }

  void theLightOfTheSimulationFallsOnTheScene() {
    Shown s;
    QVERIFY(s.placeThings());
    const QColor before = s.colorAt({1.2, 0.8, 0}), sky = s.picture().pixelColor(5, 5);
    auto status = std::make_shared<robotcontrol::SimulationStatus>();
    status->set_brightness(0.6);
    status->set_warmth(0.5);
    s.world.push("simulation", status);
    QVERIFY(s.step());
    const QColor warm = s.colorAt({1.2, 0.8, 0});
    QVERIFY2(isNear(warm,
                    QColor(int(before.red() * 0.6), int(before.green() * 0.45), int(before.blue() * 0.3)), 4),
             qPrintable(before.name() + QLatin1Char(' ') + warm.name()));
    QCOMPARE(s.picture().pixelColor(5, 5), sky);
  }

  void theWorldMovesWithTheTransforms() {
    Shown s;
    QVERIFY(s.placeThings());
    s.world.pushPoses({-1, 0.5, 0.3}, {-0.2, 0.9});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt(kBall), s.named("green"), 8));
    QVERIFY(s.colorAt({-0.2, 0.9, 0.042}).hue() < 40);
  }

  void nothingIsDrawnAgainWhileNothingChanges() {
    Shown s;
    QVERIFY(s.placeThings());
    QVERIFY(s.step());  // what stands still is drawn once more, smoothly
    QSignalSpy pictures(s.canvas, &SceneCanvas::pictureShown);
    s.world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});  // said again
    QVERIFY(s.step());
    QTest::qWait(80);
    QCOMPARE(pictures.count(), 0);
  }

  void edgesAreSmoothInMovingPicturesAndInStillOnes() {
    Shown s;
    QVERIFY(s.placeThings());
    const auto colorsAlongTheEdge = [&] {
      std::set<QRgb> colors;
      const QImage picture = s.picture();
      for (int i = 0; i < 60; ++i) {
        const QPoint edge = s.at({-2.1, -1.0 + i * 0.02, 0});
        for (int x = -2; x <= 2; ++x) colors.insert(picture.pixel(edge.x() + x, edge.y()));
      }
      return colors.size();
    };
    const auto moving = colorsAlongTheEdge();
    QVERIFY2(moving > 6, qPrintable(QString::number(moving)));  // two, if they were jagged
    QVERIFY(s.step());
    QVERIFY(colorsAlongTheEdge() > 6);
  }

  void smoothingMixesWhatLiesAcrossASlantedEdgeAndLeavesTheRest() {
    QImage picture(60, 40, QImage::Format_RGB32);
    picture.fill(Qt::black);
    for (int x = 0; x < picture.width(); ++x) {
      for (int y = 10 + x / 6; y < picture.height(); ++y) picture.setPixelColor(x, y, Qt::white);
    }
    const QImage smooth = smoothEdges(picture);
    int mixed = 0;
    for (int x = 12; x < 48; ++x) {
      for (int y = 0; y < 40; ++y) {
        const int grey = smooth.pixelColor(x, y).red();
        mixed += grey > 10 && grey < 245 ? 1 : 0;
        if (std::abs(y - (10 + x / 6)) > 2) QCOMPARE(grey, picture.pixelColor(x, y).red());
      }
    }
    QVERIFY2(mixed > 18, qPrintable(QString::number(mixed)));
    QImage straight(40, 40, QImage::Format_RGB32);
    straight.fill(Qt::black);
    for (int x = 0; x < 40; ++x) {
      for (int y = 20; y < 40; ++y) straight.setPixelColor(x, y, Qt::white);
    }
    QCOMPARE(smoothEdges(straight), straight);
  }

  void draggingTurnsTheCamera() {
    Shown s;
    QVERIFY(s.placeThings());
    const QImage before = s.picture();
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, {30, 30}, {90, 50});
    QVERIFY(s.step());
    QVERIFY(s.canvas->camera().azimuth != camera.azimuth && s.canvas->camera().elevation > camera.elevation);
    QVERIFY(difference(before, s.picture()) > 0.1);
    QVERIFY(s.colorAt(kBall).hue() < 40);  // it is still where the camera says
    QVERIFY(s.world.requests.empty());
  }

  void theArrowKeysTurnAndMoveTheCamera() {
    Shown s;
    QVERIFY(s.placeThings());
    const SceneCamera before = s.canvas->camera();
    QTest::keyClick(s.canvas, Qt::Key_Left);
    QVERIFY(!(s.canvas->camera() == before));
    QVERIFY(s.canvas->camera().target == before.target);
    QTest::keyClick(s.canvas, Qt::Key_Right);
    QTest::keyClick(s.canvas, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(s.canvas->camera().target != before.target);
    QTest::keyClick(s.canvas, Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY((s.canvas->camera().target - before.target).norm() < 1e-6);
  }

  void theWholeFieldIsSeenWhateverTheSize() {
    Shown s;
    QVERIFY(s.placeThings());
    for (const QSize size : {QSize(300, 500), QSize(700, 300)}) {
      s.view.resize(size);
      QApplication::processEvents();
      for (const double x : {-2.25, 2.25}) {
        for (const double y : {-1.5, 1.5}) QVERIFY(s.canvas->rect().contains(s.at({x, y, 0.4})));
      }
    }
  }

  void theRightButtonMovesTheCamera() {
    Shown s;
    QVERIFY(s.placeThings());
    const QPoint before = s.at({0, 0, 0});
    drag(*s.canvas, Qt::RightButton, {200, 200}, {240, 200});
    const QPoint moved = s.at({0, 0, 0}) - before;
    QVERIFY2(std::abs(moved.x() - 40) <= 3 && std::abs(moved.y()) <= 3,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
  }

  void theWheelZoomsToTheCursor() {
    Shown s;
    QVERIFY(s.placeThings());
    const SceneCamera home = s.canvas->camera();
    const QPoint before = s.at({1, 0.5, 0});
    turnWheel(*s.canvas, before, 4);
    QVERIFY((s.at({1, 0.5, 0}) - before).manhattanLength() <= 4);
    QVERIFY(s.canvas->camera().distance < home.distance && !s.canvas->overview());
    QTest::keyClick(s.canvas, Qt::Key_R);
    QCOMPARE(s.canvas->camera(), home);
  }

  void presetsLookFromAboveAndFromBehind() {
    Shown s;
    QVERIFY(s.placeThings());
    s.click("sceneFromAbove");
    QVERIFY(s.canvas->camera().elevation > robotlink::radians(89));
    s.click("sceneBehind");
    QVERIFY(std::abs(robotlink::normalizedAngle(s.canvas->camera().azimuth - 0.3 - robotlink::kPi)) < 1e-9);
    const QPoint robot = s.at({-1, 0.5, 0.1});
    QVERIFY(s.canvas->rect().contains(robot));
  }

  void aNewViewIsNearTheRobotAndFollowsIt() {
    SyntheticWorld world;
    SceneView view(world.context);
    auto* canvas = child<SceneCanvas>(view, "sceneCanvas");
    view.resize(600, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});
    world.advance();
    view.tick();
    QVERIFY(!canvas->overview());
    QVERIFY(canvas->camera().distance < 3);
    const auto seen = [&](double x, double y) {
      const auto at = canvas->camera().project(canvas->size(), {x, y, 0.05});
      return at && canvas->rect().adjusted(60, 60, -60, -60).contains(at->toPoint());
    };
    QVERIFY(seen(-1, 0.5));
    for (int i = 0; i < 100; ++i) {
      world.pushPoses({-1 + 0.02 * i, 0.5, 0.3}, {kBall.x(), kBall.y()});
      world.advance();
      view.tick();
      QVERIFY(seen(-1 + 0.02 * i, 0.5));
    }
    // The camera that a person chooses stays until he follows again.
    QTest::keyClick(canvas, Qt::Key_A);
    QVERIFY(canvas->camera().elevation > robotlink::radians(89));
    world.pushPoses({-1, -1, 0.3}, {kBall.x(), kBall.y()});
    world.advance();
    const SceneCamera above = canvas->camera();
    view.tick();
    QCOMPARE(canvas->camera(), above);
  }

  void theCameraFollowsTheRobotGently() {
    Shown s;
    QVERIFY(s.placeThings());
    const Vector3 far(5, 5, 0);  // the ball plays no part
    s.world.pushPoses({-1, 0.5, 0.3}, {far.x(), far.y()});
    QVERIFY(s.step());
    QTest::keyClick(s.canvas, Qt::Key_F);
    const Vector3 before = s.canvas->camera().target;
    s.world.pushPoses({-0.6, 0.8, 0.3}, {far.x(), far.y()});
    s.world.advance();
    s.view.tick();
    const double first = (s.canvas->camera().target - before).norm();
    QVERIFY2(first > 0.02 && first < 0.25, qPrintable(QString::number(first)));
    s.settle();
    const Vector3 moved = s.canvas->camera().target - before;
    QVERIFY2((moved - Vector3(0.4, 0.3, 0)).norm() < 2e-3,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
    // At rest nothing is drawn for it.
    const SceneCamera still = s.canvas->camera();
    s.view.tick();
    QCOMPARE(s.canvas->camera(), still);
  }

  void theCameraOverTheShoulderTurnsWithTheRobot() {
    Shown s;
    QVERIFY(s.placeThings());
    s.click("sceneBehind");
    const SceneCamera before = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, {30, 30}, {60, 30});  // a little to the side, as a person likes it
    const double aside = robotlink::normalizedAngle(s.canvas->camera().azimuth - before.azimuth);
    s.world.pushPoses({-0.7, 0.5, 1.3}, {kBall.x(), kBall.y()});
    s.world.advance();
    s.settle();
    const double turned = robotlink::normalizedAngle(s.canvas->camera().azimuth - before.azimuth);
    QVERIFY2(std::abs(turned - aside - 1) < 0.01, qPrintable(QStringLiteral("%1 %2").arg(turned).arg(aside)));
    QVERIFY(s.canvas->rect().contains(s.at({-0.7, 0.5, 0.1})));
    // It is one or the other.
    s.click("sceneFollow");
    QVERIFY(!s.view.findChild<QAction*>(QStringLiteral("sceneBehindAction"))->isChecked());
  }

  void whatIsDraggedDoesNotTakeTheCameraAlong() {
    Shown s;
    s.world.session.setRobots({"red1"});
    QVERIFY(s.placeThings());
    QTest::keyClick(s.canvas, Qt::Key_F);
    s.settle();
    const Vector3 top(-1, 0.5, 0.17);
    const SceneCamera before = s.canvas->camera();
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(top) + QPoint(60, 0), Qt::LeftButton);
    s.world.pushPoses({-0.6, 0.5, 0.3}, {kBall.x(), kBall.y()});
    QVERIFY(s.step());
    QCOMPARE(s.canvas->camera(), before);
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(top) + QPoint(60, 0));
    s.view.tick();
    QVERIFY(!(s.canvas->camera() == before));
  }

  void aClickSelectsARobotAndMovesNothing() {
    Shown s;
    s.world.session.setRobots({"blue1", "red1"});
    s.world.session.selectRobot("blue1");
    QVERIFY(s.placeThings());
    const Vector3 top(-1, 0.5, 0.17);
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(top) + QPoint(2, 0), Qt::LeftButton);
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(top) + QPoint(2, 0));
    QCOMPARE(s.world.session.selectedRobot(), std::string("red1"));
    s.view.tick();
    QVERIFY(s.world.requests.empty());
  }

  void wireFrameShowsEdgesOnly() {
    Shown s;
    QVERIFY(s.placeThings());
    const int filled = countNear(s.picture(), s.named("green"), 10);
    QTest::keyClick(s.canvas, Qt::Key_W);
    QVERIFY(s.step());
    const int edges = countNear(s.picture(), s.named("green"), 10);
    QVERIFY2(filled > 8000 && edges < filled / 10,
             qPrintable(QStringLiteral("%1 %2").arg(filled).arg(edges)));
    s.click("sceneWireFrame");
    QVERIFY(s.step());
    QCOMPARE(countNear(s.picture(), s.named("green"), 10), filled);
  }

  void draggingTheBallPlacesIt() {
    Shown s;
    QVERIFY(s.placeThings());
    s.click("sceneZoomIn");  // a pixel is less than a centimetre now
    const Vector3 wanted(0.9, 0.2, kBall.z());
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at(wanted), [&] { s.view.tick(); });
    QVERIFY(s.world.requests.size() >= 2);
    const auto& place = s.world.requests.back().place_model();
    QCOMPARE(place.model(), std::string("ball"));
    const auto& pose = place.pose_in_field();
    QVERIFY2(std::hypot(pose.x() - wanted.x(), pose.y() - wanted.y()) < 0.02,
             qPrintable(QStringLiteral("%1 %2").arg(pose.x()).arg(pose.y())));
    // The camera did not move.
    QCOMPARE(s.canvas->camera(), camera);
  }

  void aGhostShowsWhereTheRobotIsWantedAndTheWheelTurnsIt() {
    Shown s;
    QVERIFY(s.placeThings());
    s.click("sceneZoomIn");  // a pixel is less than a centimetre now
    const Vector3 top(-1, 0.5, 0.17), wanted(-0.3, 0.2, 0.17);
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(wanted), Qt::LeftButton);
    turnWheel(*s.canvas, s.at(wanted), 2);
    QVERIFY(s.step());
    QVERIFY(!isNear(s.colorAt(wanted), s.named("green"), 30));
    keepPicture(s.view, "scene-drag");
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(wanted));
    const auto& pose = s.world.requests.back().place_model().pose_in_field();
    QVERIFY(std::abs(pose.heading() - 0.3 - robotlink::radians(30)) < 1e-9);
    QVERIFY(std::hypot(pose.x() - wanted.x(), pose.y() - wanted.y()) < 0.02);
  }

  void withoutTheToolOnlyControlMoves() {
    Shown s;
    QVERIFY(s.placeThings());
    s.click("sceneMove");
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at(kBall) + QPoint(30, 0), [&] { s.view.tick(); });
    QVERIFY(s.world.requests.empty());
    drag(
        *s.canvas, Qt::LeftButton, s.at(kBall), s.at(kBall) + QPoint(30, 0), [&] { s.view.tick(); },
        Qt::ControlModifier);
    QVERIFY(!s.world.requests.empty());
  }

  void aRefusedPlaceIsShown() {
    Shown s;
    QVERIFY(s.placeThings());
    s.world.refusal = "it would stand in a wall";
    const QImage before = s.canvas->grab().toImage();
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at({1.5, 1.3, kBall.z()}), [&] { s.view.tick(); });
    QVERIFY(s.step());
    QVERIFY(s.step());
    const QRect top(140, 8, 200, 20);
    QVERIFY(before.copy(top) != s.canvas->grab().toImage().copy(top));
  }

  void drawingsAreShownInSpaceAndToggledByAClick() {
    Shown s;
    QVERIFY(s.placeThings());
    s.world.pushFrame({worldDrawing("field", "area", "field",
                                    [](SceneDrawing& d) {
                                      d.circle({1, 0.6}, 0.3, colors::kPink, 1, colors::kPink);
                                    }),
                       worldDrawing("robot", "post", "red1", [](SceneDrawing& d) {
                         robotlink::Pose3 pose = robotlink::Pose3::Identity();
                         pose.translation() = Vector3(0.6, 0, 0.2);
                         d.box(pose, {0.1, 0.1, 0.4}, colors::kBlue);
                       })});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt({1, 0.6, 0}), QColor(250, 90, 170)));
    const Vector3 post(-1 + 0.6 * std::cos(0.3), 0.5 + 0.6 * std::sin(0.3), 0.2);
    QVERIFY(s.colorAt(post).blue() > 100);
    s.click("sceneDrawings");
    auto* list = child<QListView>(s.view, "drawingsList");
    QVERIFY(list->isVisible());
    QVERIFY(s.step());  // the canvas is narrower now
    QVERIFY(isNear(s.colorAt({1, 0.6, 0}), QColor(250, 90, 170)));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(0, 0)).topLeft() + QPoint(10, 8));
    QTRY_VERIFY(isNear(s.colorAt({1, 0.6, 0}), s.named("green"), 8));
  }

  void theRobotWhoseDrawingsAreShownIsChosenInItsBox() {
    Shown s;
    s.world.session.setRobots({"red1", "blue1"});
    QVERIFY(s.placeThings());
    s.world.pushFrame({worldDrawing("field", "area", "field", [](SceneDrawing& d) {
      d.circle({1, 0.6}, 0.3, colors::kPink, 1, colors::kPink);
    })});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt({1, 0.6, 0}), QColor(250, 90, 170)));
    auto* robots = child<RobotChoice>(s.view, "sceneRobot");
    robots->setFocus();
    QTest::keyClick(robots, Qt::Key_End);
    QCOMPARE(robots->currentText(), QStringLiteral("blue1"));
    QTRY_VERIFY(isNear(s.colorAt({1, 0.6, 0}), s.named("green"), 8));
  }

  void aDamagedDrawingHarmsNothing() {
    Shown s;
    QVERIFY(s.placeThings());
    s.world.pushFrame({damagedDrawing("damaged", "field"), damagedDrawing("lost", "nowhere")});
    QVERIFY(s.step());
    QVERIFY(s.colorAt(kBall).hue() < 40);
  }

  void namesAndGridAreToggled() {
    Shown s;
    QVERIFY(s.placeThings());
    QVERIFY(s.step());  // what stands still is drawn once more, smoothly
    const QImage before = s.picture();
    QTest::keyClick(s.canvas, Qt::Key_L);
    QVERIFY(s.step());
    QVERIFY(difference(before, s.picture()) > 0.0005);
    const QImage withGrid = s.picture();
    QTest::keyClick(s.canvas, Qt::Key_G);
    QVERIFY(s.step());
    QVERIFY(difference(withGrid, s.picture()) > 0.002);
  }

  void thePictureIsCopied() {
    Shown s;
    QVERIFY(s.placeThings());
    s.view.findChild<QAction*>(QStringLiteral("sceneCopyAction"))->trigger();
    QCOMPARE(QApplication::clipboard()->image().pixelColor(s.at(kBall)).hue(), s.colorAt(kBall).hue());
  }

  void thePictureIsSavedWhereTheDialogSays() {
    Shown s;
    QVERIFY(s.placeThings());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("scene.png"));
    DialogAnswer answer = DialogAnswer::file(file);
    QTest::keyClick(s.canvas, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(answer.asked());
    QCOMPARE(QImage(file).pixelColor(s.at(kBall)).hue(), s.colorAt(kBall).hue());
  }

  void theContextMenuHasTheCamerasPlaces() {
    Shown s;
    QVERIFY(s.placeThings());
    const auto before = s.canvas->camera();
    QTest::mouseClick(s.canvas, Qt::RightButton, {}, {100, 100});
    auto* menu = child<QMenu>(s.view, "sceneMenu");
    QVERIFY(menu->isVisible());
    auto* fromAbove = s.view.findChild<QAction*>(QStringLiteral("sceneFromAboveAction"));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(fromAbove).center());
    QVERIFY(!(s.canvas->camera() == before));
  }

  void whatTheUserChoseSurvives() {
    Shown a;
    QVERIFY(a.placeThings());
    a.click("sceneDrawings");
    a.click("sceneWireFrame");
    a.click("sceneGrid");
    a.click("sceneBehind");
    child<RobotChoice>(a.view, "sceneRobot")->setChoice(QStringLiteral("red1"));
    const QJsonObject state = a.view.saveState();
    Shown b;
    b.view.restoreState(state);
    QCOMPARE(b.view.saveState(), state);
    b.view.restoreState({});  // harmless
  }

  void showsAWholePicture() {
    Shown s;
    s.view.resize(800, 600);
    QVERIFY(s.placeThings());
    s.world.pushFrame({worldDrawing("field", "plan", "field",
                                    [](SceneDrawing& d) {
                                      d.arrow({-1, 0.5}, {0.4, -0.35}, colors::kPink, 3);
                                      d.circle({0.5, -0.4}, 0.15, colors::kYellow, 2, {{240, 210, 40}, 0.3});
                                      d.text({0.5, -0.6}, "go to ball", colors::kWhite, 13);
                                    }),
                       worldDrawing("robot", "axes", "red1", [](SceneDrawing& d) {
                         d.axes(robotlink::Pose3::Identity(), 0.4);
                         d.sphere({0.5, 0.3, 0.2}, 0.06, {{90, 200, 240}, 0.6});
                       })});
    QVERIFY(s.step());
    s.click("sceneDrawings");
    QVERIFY(s.step());
    QVERIFY(s.step());
    keepPicture(s.view, "scene-view");
    QVERIFY(countNear(s.picture(), QColor(250, 90, 170), 25) > 50);
    QVERIFY(countNear(s.picture(), QColor(220, 40, 40), 60) > 20);
  }

  void withoutOpenGlTheReasonIsShown() {
    SceneCanvas canvas(
        []() -> robotlink::Result<SceneRenderer> { return robotlink::failure("scene.no-egl", "no EGL"); });
    canvas.resize(400, 300);
    canvas.show();
    const auto words = [&] {
      return countNear(canvas.grab().toImage(), canvas.palette().color(QPalette::ToolTipBase), 2);
    };
    QTRY_VERIFY(words() > 1000);
  }
};

}  // namespace widgets::test

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  widgets::test::SceneViewTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "SceneViewTest.moc"
