// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListView>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <set>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/scene/ShownScene.h"
#include "widgets/RobotChoice.h"
#include "widgets/scene/render/EdgeSmoothing.h"
#include "widgets/world/RobotBody.h"

namespace widgets::test {
namespace {

using robotlink::SceneDrawing;
using robotlink::Vector3;
namespace colors = robotlink::colors;

/// A pillar and a name beside it, drawn by the key "ball-model/post".
FieldBench::FramePart post() {
  return worldDrawing("field", "ball-model/post", "field", [](SceneDrawing& d) {
    robotlink::Pose3 pose = robotlink::Pose3::Identity();
    pose.translation() = Vector3(1, 0.6, 0.2);
    d.box(pose, {0.2, 0.2, 0.4}, colors::kBlue);
    d.circle({0, 0.9}, 0.3, colors::kPink, 6);
    d.text({0.2, -1}, "MMMM", colors::kWhite, 20);
  });
}

/// One entity: a blue roof of 0.4 x 0.4 m, 0.2 m above a point on the ground.
std::shared_ptr<const foxglove::SceneUpdate> boxShapes() {
  auto shapes = std::make_shared<foxglove::SceneUpdate>();
  auto& triangles = *shapes->add_entities()->add_triangles();
  robotlink::assign(*triangles.mutable_color(), robotlink::Rgb{20, 40, 230});
  const auto add = [&](double x, double y, double z) {
    auto& point = *triangles.add_points();
    point.set_x(x);
    point.set_y(y);
    point.set_z(z);
  };
  const std::array<std::array<double, 2>, 6> roof{
      {{-0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}}};
  for (const auto& [x, y] : roof) add(x, y, 0.2);
  // What touches the ground.
  add(0, 0, 0);
  add(0.01, 0, 0);
  add(0, 0.01, 0);
  return shapes;
}

std::shared_ptr<robotcontrol::KeyTable> drawnEveryTenth(const std::string& key) {
  auto table = std::make_shared<robotcontrol::KeyTable>();
  auto& entry = *table->add_keys();
  entry.set_name(key);
  entry.mutable_mode()->set_kind(robotcontrol::KeyMode::EVERY_N);
  entry.mutable_mode()->set_n(10);
  return table;
}

}  // namespace

class SceneViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!sceneCanBeDrawn()) QSKIP("no OpenGL here");
  }

  void withoutASceneItIsSaidWhy() {
    ShownScene s;
    QVERIFY(s.step());
    QVERIFY(s.canvas->hint().contains(QStringLiteral("start a simulation")));
    s.world.session.push({"replay", robotlink::Instant{}, std::make_shared<robotcontrol::ReplayStatus>()});
    QVERIFY(s.step());
    QVERIFY(s.canvas->hint().contains(QStringLiteral("log holds no scene")));
  }

  void aRobotWithoutASceneStandsOnAPlainFloorByItsOwnModel() {
    ShownScene s;
    auto body = std::make_shared<RobotBody>();
    body->parts.assign(1, robotlink::Pose3::Identity());
    body->shapes = boxShapes();
    auto description = std::make_shared<robotlink::RobotDescription>();
    description->name = "box";
    s.world.context.robots["red1"] = description;
    s.world.context.bodyOf = [&](const std::string& kind, const QColor&) {
      return kind == "box" ? body : nullptr;
    };
    s.world.pushEstimates({1, 0.5, 0}, {0, 0});
    QVERIFY(s.step());
    const QColor blue = s.colorAt({1, 0.38, 0.2});
    QVERIFY2(blue.blue() > 120 && blue.red() < 80, qPrintable(blue.name()));
    const QColor floor = s.colorAt({-1, -0.5, 0});
    QVERIFY2(std::abs(floor.red() - floor.blue()) < 12 && floor.red() > 90, qPrintable(floor.name()));
    auto camera = std::make_shared<robotcontrol::CameraPose>();
    camera->mutable_camera_in_robot()->mutable_position()->set_z(0.2);
    camera->mutable_camera_in_robot()->mutable_orientation()->set_w(1);
    camera->set_horizontal_angle(1);
    camera->set_vertical_angle(0.8);
    const QImage before = s.picture();
    s.world.push("red1/camera/pose", camera);
    QVERIFY(s.step());
    QVERIFY2(pictureDifference(before, s.picture()) > 0.0005, "its camera is shown");
    QVERIFY(s.view.choosePose("true"));
    QVERIFY(s.step());
    QVERIFY2(!(s.colorAt({1, 0.38, 0.2}).blue() > 120 && s.colorAt({1, 0.38, 0.2}).red() < 80),
             "no true pose is known");
  }

  void theBallIsOrangeWhereItLies() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const QColor ball = s.colorAt(kBall);
    QVERIFY2(std::abs(ball.hue() - s.named("orange").hue()) < 6 && ball.saturation() > 180,
             qPrintable(ball.name()));
    // What lies flat has its own color.
    QVERIFY(isNear(s.colorAt({1.2, 0.8, 0}), s.named("green"), 8));
    QVERIFY(isNear(s.colorAt({-1, 0.5, 0.17}), s.named("red"), 60));
  }

  void aTipNamesTheDrawingUnderTheCursor() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.world.pushFrame({post()});
    QVERIFY(s.step());
    const QString pillar = shownTip(*s.canvas, s.at({1, 0.6, 0.2}));
    QVERIFY2(
        pillar.contains(QStringLiteral("debug key ball-model/post")) && pillar.contains(QStringLiteral(" m")),
        qPrintable(pillar));
    QVERIFY(shownTip(*s.canvas, s.at({0.2, -1, 0}) + QPoint(4, -4)).contains(QStringLiteral("MMMM")));
    QVERIFY(shownTip(*s.canvas, s.at({0.3, 0.9, 0.005})).contains(QStringLiteral("ball-model/post")));
    QVERIFY(!shownTip(*s.canvas, s.at({-1.5, -1, 0})).contains(QStringLiteral("ball-model")));
  }

  void theLightOfTheSimulationFallsOnTheScene() {
    ShownScene s;
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
    ShownScene s;
    QVERIFY(s.placeThings());
    s.world.pushPoses({-1, 0.5, 0.3}, {-0.2, 0.9});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt(kBall), s.named("green"), 8));
    QVERIFY(s.colorAt({-0.2, 0.9, 0.042}).hue() < 40);
  }

  void nothingIsDrawnAgainWhileNothingChanges() {
    ShownScene s;
    QVERIFY(s.placeThings());
    QVERIFY(s.step());  // what stands still is drawn once more, smoothly
    s.world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});  // said again
    s.world.advance();
    s.view.tick();
    QVERIFY2(s.canvas->upToDate(), "another picture was asked for");
  }

  void edgesAreSmoothInMovingPicturesAndInStillOnes() {
    ShownScene s;
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
        const int gray = smooth.pixelColor(x, y).red();
        mixed += gray > 10 && gray < 245 ? 1 : 0;
        if (std::abs(y - (10 + x / 6)) > 2) QCOMPARE(gray, picture.pixelColor(x, y).red());
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

  void wireFrameShowsEdgesOnly() {
    ShownScene s;
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

  void drawingsAreShownInSpaceAndToggledByAClick() {
    ShownScene s;
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
    auto* list = &child<QListView>(s.view, "drawingsList");
    QVERIFY(list->isVisible());
    QVERIFY(s.step());  // the canvas is narrower now
    QVERIFY(isNear(s.colorAt({1, 0.6, 0}), QColor(250, 90, 170)));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(0, 0)).topLeft() + QPoint(10, 8));
    // A point beside the middle, whose pixel has the plain color of the field in the smaller canvas.
    QTRY_VERIFY2(isNear(s.colorAt({1.15, 0.7, 0}), s.named("green"), 10),
                 qPrintable(s.colorAt({1.15, 0.7, 0}).name()));
  }

  void aDrawingOfAnEarlierFrameIsFaded() {
    ShownScene s;
    s.view.resize(760, 400);
    s.world.push("red1/tables/keys", drawnEveryTenth("ball-model/post"));
    QVERIFY(s.placeThings());
    s.world.pushFrame({post()});
    QVERIFY(s.step());
    QVERIFY(s.step());  // what stands still is drawn once more, smoothly
    const Vector3 inPost(1, 0.6, 0.25), onCircle(0.3, 0.9, 0);
    const auto* state = &child<QLabel>(s.view, "sceneState");
    const auto white = [&] { return countNear(s.picture(), Qt::white, 8); };
    const QColor solid = s.colorAt(inPost);
    const int whiteBefore = white();
    QVERIFY(solid.blue() > 100 && solid.red() < 80);
    QVERIFY(isNear(s.colorAt(onCircle), QColor(250, 90, 170), 30));
    QVERIFY(!state->text().contains(QStringLiteral("faded")));
    keepPicture(s.view, "scene-fresh");

    s.world.pushFrame({});
    QVERIFY(s.step());
    QVERIFY(s.step());
    keepPicture(s.view, "scene-faded");
    QVERIFY2(!isNear(s.colorAt(inPost), solid, 40), "it would look like what is seen in this frame");
    QVERIFY2(!isNear(s.colorAt(inPost), s.named("green"), 10), "it is still there");
    QVERIFY(!isNear(s.colorAt(onCircle), QColor(250, 90, 170), 60));
    QVERIFY(!isNear(s.colorAt(onCircle), s.named("green"), 10));
    QVERIFY2(white() < whiteBefore - 60, "the text is faded, too");
    QVERIFY(state->text().contains(QStringLiteral("faded")));

    s.world.pushFrame({post()});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt(inPost), solid, 8));
    QVERIFY(state->text().isEmpty());
  }

  void theRobotWhoseDrawingsAreShownIsChosenInItsBox() {
    ShownScene s;
    s.world.session.setRobots({"red1", "blue1"});
    QVERIFY(s.placeThings());
    s.world.pushFrame({worldDrawing("field", "area", "field", [](SceneDrawing& d) {
      d.circle({1, 0.6}, 0.3, colors::kPink, 1, colors::kPink);
    })});
    QVERIFY(s.step());
    QVERIFY(isNear(s.colorAt({1, 0.6, 0}), QColor(250, 90, 170)));
    auto* robots = &child<RobotChoice>(s.view, "sceneRobot");
    robots->setFocus();
    QTest::keyClick(robots, Qt::Key_End);
    QCOMPARE(robots->currentText(), QStringLiteral("blue1"));
    QTRY_VERIFY(isNear(s.colorAt({1, 0.6, 0}), s.named("green"), 8));
  }

  void aDamagedDrawingHarmsNothing() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.world.pushFrame({damagedDrawing("damaged", "field"), damagedDrawing("lost", "nowhere")});
    QVERIFY(s.step());
    QVERIFY(s.colorAt(kBall).hue() < 40);
  }

  void namesAndGridAreToggled() {
    ShownScene s;
    QVERIFY(s.placeThings());
    QVERIFY(s.step());  // what stands still is drawn once more, smoothly
    const QImage before = s.picture();
    QTest::keyClick(s.canvas, Qt::Key_L);
    QVERIFY(s.step());
    QVERIFY(pictureDifference(before, s.picture()) > 0.0005);
    const QImage withGrid = s.picture();
    QTest::keyClick(s.canvas, Qt::Key_G);
    QVERIFY(s.step());
    QVERIFY(pictureDifference(withGrid, s.picture()) > 0.002);
  }

  void thePictureIsCopied() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.view.findChild<QAction*>(QStringLiteral("sceneCopyAction"))->trigger();
    QCOMPARE(QApplication::clipboard()->image().pixelColor(s.at(kBall)).hue(), s.colorAt(kBall).hue());
  }

  void thePictureIsSavedWhereTheDialogSays() {
    ShownScene s;
    QVERIFY(s.placeThings());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("scene.png"));
    DialogAnswer answer = DialogAnswer::file(file);
    QTest::keyClick(s.canvas, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(answer.asked());
    QCOMPARE(QImage(file).pixelColor(s.at(kBall)).hue(), s.colorAt(kBall).hue());
  }

  void whatTheUserChoseSurvives() {
    ShownScene a;
    QVERIFY(a.placeThings());
    a.click("sceneDrawings");
    a.click("sceneWireFrame");
    a.click("sceneGrid");
    a.click("sceneBehind");
    child<RobotChoice>(a.view, "sceneRobot").setChoice(QStringLiteral("red1"));
    const QJsonObject state = a.view.saveState();
    ShownScene b;
    b.view.restoreState(state);
    QCOMPARE(b.view.saveState(), state);
    b.view.restoreState({});  // harmless
  }

  void showsAWholePicture() {
    ShownScene s;
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

const GuiTest<SceneViewTest> kSceneViewTest;

}  // namespace widgets::test

#include "SceneViewTest.moc"
