// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>

#include "robotcontrol/Requests.pb.h"
#include "tests/widgets/scene/ModesScene.h"
#include "widgets/Theme.h"
#include "widgets/scene/ObjectLooks.h"
#include "widgets/scene/SceneObjects.h"
#include "widgets/scene/render/MeshBuilder.h"
#include "widgets/scene/render/MeshEdges.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {

class SceneModesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!sceneCanBeDrawn()) QSKIP("no OpenGL here");
  }

  void aBoxHasTwelveEdgesAndABallOneForEachSideOfItsTriangles() {
    SceneMesh box;
    MeshBuilder(box).box(robotlink::Pose3::Identity(), {1, 2, 3}, {255, 0, 0, 255});
    QCOMPARE(meshEdges(box).size(), std::size_t(2 * 12));
    SceneMesh damaged = box;
    damaged.indices.insert(damaged.indices.end(), {0, 1, 999});
    QCOMPARE(meshEdges(damaged).size(), std::size_t(2 * 12));
    SceneMesh ball;
    MeshBuilder(ball).sphere(robotlink::Pose3::Identity(), {1, 1, 1}, {255, 0, 0, 255});
    QVERIFY(meshEdges(ball).size() > 500);
  }

  void edgesAreSeenThroughOrHideEachOther() {
    ModesScene s;
    const int filled = s.red();
    QVERIFY2(filled > 2000 && s.blue() == 0, qPrintable(QString::number(filled)));
    QVERIFY(s.view.drawObject({}, "hidden-lines"));
    QVERIFY(s.step());
    const int outlines = s.red();
    QVERIFY2(outlines > 50 && outlines < filled / 4 && s.blue() < 5, qPrintable(QString::number(outlines)));
    QVERIFY(s.view.drawObject({}, "wire"));
    QVERIFY(s.step());
    QVERIFY2(s.blue() > 100, qPrintable(QString::number(s.blue())));
    QVERIFY(s.red() < filled / 3);
    QVERIFY(!s.view.drawObject({}, "glass"));
  }

  void trianglesAreOfOneColorInFlatShading() {
    ModesScene s;
    QVERIFY(s.view.showOnly("crate/joint:swing", true));
    QVERIFY(s.rest());
    const int smooth = s.alike(), blue = s.blue();
    QVERIFY2(blue > 2000, qPrintable(QString::number(blue)));
    QVERIFY(s.view.drawObject({}, "flat"));
    QVERIFY(s.step());
    QVERIFY2(s.alike() > smooth + blue / 20, qPrintable(QStringLiteral("%1 %2").arg(smooth).arg(s.alike())));
    QVERIFY(s.blue() > blue * 9 / 10);
  }

  void onePartCanBeDrawnOtherwiseAndSeenThrough() {
    ModesScene s;
    const int filled = s.red();
    QVERIFY(s.view.drawObject("crate/link:box", "wire"));
    QVERIFY(s.view.drawObject("crate/link:core", "shaded"));
    QVERIFY(s.step());
    QVERIFY2(s.red() < filled / 3 && s.blue() > 1000, qPrintable(QString::number(s.blue())));
    QVERIFY2(s.green() > 5000, "the floor stays as it is");
    QVERIFY(s.view.drawObject("crate/link:box", "view"));
    QVERIFY(s.view.setOpacity("crate/link:box", 0.2));
    QVERIFY(s.view.setOpacity("crate/link:core", 1));
    QVERIFY(s.step());
    QVERIFY2(s.red() < filled / 3 && s.blue() > 500, qPrintable(QString::number(s.blue())));
    QVERIFY(s.view.setOpacity("crate/link:box", 1));
    QVERIFY(s.step());
    QCOMPARE(s.blue(), 0);
    QVERIFY(!s.view.setOpacity("crate", 2));
    QVERIFY(!s.view.setOpacity("nobody", 0.5));
  }

  void whatIsBelowTheMouseIsHiddenByItsMenuAndShownAgain() {
    ModesScene s;
    QVERIFY(s.red() > 2000);
    QMenu* menu = menuAt(s, ModesScene::kTop);
    QVERIFY(menu != nullptr);
    auto* link = menu->findChild<QMenu*>(QStringLiteral("sceneObject:crate/link:box"));
    QVERIFY(link != nullptr && menu->findChild<QMenu*>(QStringLiteral("sceneObject:crate")) != nullptr);
    link->findChild<QAction*>(QStringLiteral("sceneHide"))->trigger();
    menu->close();
    QVERIFY(s.step());
    QVERIFY2(s.red() == 0 && s.blue() == 0, "what belongs to it is hidden, too");
    QVERIFY2(!s.canvas->hitAt(s.at(ModesScene::kTop))->object.starts_with("crate"), "nor can it be hit");
    menu = menuAt(s, ModesScene::kTop);
    auto* show = menu->findChild<QAction*>(QStringLiteral("sceneShowHidden"));
    QVERIFY(show != nullptr);
    show->trigger();
    menu->close();
    QVERIFY(s.step());
    QVERIFY(s.red() > 2000);
  }

  void aPartOfSomethingHiddenCanBeShown() {
    ModesScene s;
    QVERIFY(s.view.hideObject("crate"));
    QVERIFY(s.view.showObject("crate/link:core"));
    QVERIFY(s.step());
    QVERIFY(s.red() == 0 && s.blue() > 500);
    QVERIFY(s.view.showObject({}));
    QVERIFY(s.step());
    QVERIFY(s.red() > 2000);
    QVERIFY(!s.view.hideObject("crate/link:nothing"));
  }

  void solidsAreShownOverWhatIsSeenOrInPlaceOfIt() {
    ModesScene s;
    QCOMPARE(s.orange(), 0);
    QTest::keyClick(s.canvas, Qt::Key_P, Qt::ShiftModifier);
    QVERIFY(s.step());
    const int edges = s.orange();
    QVERIFY2(edges > 60 && s.red() > 1500, qPrintable(QString::number(edges)));
    const int before = s.calmBlue();
    QVERIFY(s.view.showLayer("visuals", false));
    QVERIFY(s.step());
    const int filled = s.calmBlue();
    QVERIFY2(s.red() == 0 && s.green() == 0 && filled > before + 2000, qPrintable(QString::number(filled)));
    QCOMPARE(s.orange(), 0);
    QVERIFY(s.view.drawObject({}, "wire"));
    QVERIFY(s.step());
    QVERIFY2(s.calmBlue() < filled / 2, qPrintable(QString::number(s.calmBlue())));
    QVERIFY(s.view.showLayer("visuals", true) && s.view.drawObject({}, "shaded"));
    QVERIFY(s.step());
    QVERIFY2(s.orange() > 60, "edges over visible shapes stand out");
    QVERIFY(!s.view.showLayer("dreams", true));
  }

  void calmColorsDifferAndAreNeverGlaring() {
    QPalette light, dark;
    light.setColor(QPalette::Base, Qt::white);
    light.setColor(QPalette::Text, Qt::black);
    dark.setColor(QPalette::Base, Qt::black);
    dark.setColor(QPalette::Text, Qt::white);
    for (int i = 0; i < 12; ++i) {
      const QColor onLight = calmColor(i, 0.38, light), onDark = calmColor(i, 0.38, dark);
      QVERIFY2(onLight.hslSaturationF() < 0.4 && onDark.hslSaturationF() < 0.4, qPrintable(onLight.name()));
      // The sky behind them is pale, or dark.
      QVERIFY(onLight.lightnessF() < 0.6 && onDark.lightnessF() > 0.55);
      QVERIFY2(calmColor(i, 0.1, light).hslSaturationF() < 0.12, "what is fixed is nearly gray");
      if (i > 0) QVERIFY(onLight != calmColor(i - 1, 0.38, light));
    }
  }

  void theSurroundingsAreSelectedByADoubleClickOnly() {
    ModesScene s;
    const auto& selection = sceneSelection(s.world.context);
    const QPoint floor = s.at({1.2, -0.6, 0});
    QVERIFY(s.canvas->hitAt(floor)->owner() == "floor" && s.canvas->isBackground(*s.canvas->hitAt(floor)));
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, floor);
    QCOMPARE(selection.object(), std::string());
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, s.at(ModesScene::kTop));
    QCOMPARE(selection.object(), std::string("crate"));
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, floor);
    QCOMPARE(selection.object(), std::string("crate"));
    doubleClick(*s.canvas, floor);
    QCOMPARE(selection.object(), std::string("floor"));
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QCOMPARE(selection.object(), std::string());
  }

  void aLongWallIsNoSurroundings() {
    const auto plank = [](double length, double width, double angle) {
      SceneShape shape;
      MeshBuilder(shape.opaque).box(robotlink::Pose3::Identity(), {length, width, 1}, {200, 200, 200, 255});
      SceneBody body;
      body.shape = std::make_shared<const SceneShape>(std::move(shape));
      body.inField.rotate(Eigen::AngleAxisd(angle, robotlink::Vector3::UnitZ()));
      body.object = std::make_shared<const std::string>("room/link:l/visual:v");
      return body;
    };
    QVERIFY(!isSurroundings("room", {plank(8, 0.1, 0)}));
    QVERIFY(!isSurroundings("room", {plank(8, 0.1, 0.8)}));
    QVERIFY(isSurroundings("room", {plank(8, 0.1, 0), plank(8, 0.1, 1.57)}));
    QVERIFY(isSurroundings("room", {plank(3, 1.5, 0.3)}));
    QVERIFY(!isSurroundings("other", {plank(3, 3, 0)}));
    // Beside a large robot, a table is an object as well.
    SceneBody robot = plank(0.8, 0.8, 0);
    robot.model = "robot";
    QVERIFY(!isSurroundings("room", {plank(3, 1.5, 0.3), robot}));
    robot.model = "room";
    QVERIFY2(!isSurroundings("room", {robot, plank(8, 8, 0)}), "it moves");
  }

  void aRoomIsNoneOfTheObjectsOfTheMenuUntilItIsSelected() {
    ModesScene s;
    const robotlink::Vector3 floor(1.2, -0.6, 0);
    sceneSelection(s.world.context).select("crate");
    QMenu* menu = menuAt(s, floor);
    QVERIFY(menu != nullptr);
    QCOMPARE(sceneSelection(s.world.context).object(), std::string("crate"));
    QVERIFY2(menu->findChild<QMenu*>(QStringLiteral("sceneObject:floor")) != nullptr, "it can be hidden");
    menu->close();
  }

  void nothingHidesJointsFramesAndCenters() {
    ModesScene s;
    const auto yellow = [](const QColor& c) { return c.red() > 120 && c.green() > 100 && c.blue() < 60; };
    const auto violet = [](const QColor& c) {
      return c.red() > 90 && c.blue() > 90 && c.green() < c.red() - 40 && c.green() < c.blue() - 40;
    };
    QVERIFY(s.count(yellow) == 0 && s.count(violet) == 0);
    QTest::keyClick(s.canvas, Qt::Key_J, Qt::ShiftModifier);
    QVERIFY(s.step());
    QVERIFY2(s.count(yellow) > 10, qPrintable(QString::number(s.count(yellow))));
    QTest::keyClick(s.canvas, Qt::Key_M, Qt::ShiftModifier);
    QVERIFY(s.step());
    QVERIFY2(s.count(violet) > 10, qPrintable(QString::number(s.count(violet))));
    const QImage before = s.picture();
    QTest::keyClick(s.canvas, Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(s.step());
    s.settle();
    QTRY_VERIFY2(pictureDifference(before, s.picture()) > 0.0001, "axes");
    QVERIFY(s.view.hideObject("crate"));
    QVERIFY(s.step());
    QVERIFY2(s.count(yellow) == 0 && s.count(violet) == 0, "what is hidden has no markers");
  }

  void forcesAreArrowsAndAskedForWhileTheyAreShown() {
    ModesScene s;
    s.world.push("forces", std::make_shared<robotcontrol::WorldForces>());
    const auto asked = [&] {
      return std::ranges::count_if(s.world.requests, [](const auto& r) { return r.has_read_forces(); });
    };
    QVERIFY(s.step());
    QCOMPARE(asked(), std::ptrdiff_t(0));
    QTest::keyClick(s.canvas, Qt::Key_C, Qt::ShiftModifier);
    s.settle();
    QVERIFY2(asked() >= 2 && asked() <= 4, qPrintable(QString::number(asked())));
    QVERIFY(s.step());
    const int before = s.orange();
    auto forces = std::make_shared<robotcontrol::WorldForces>();
    auto& contact = *forces->add_contacts();
    contact.set_first("crate/link:box");
    contact.set_second("floor");
    contact.mutable_point()->set_z(0.6);
    contact.mutable_force()->set_z(40);
    s.world.push("forces", forces);
    QVERIFY(s.step());
    QVERIFY2(s.orange() > before + 8, qPrintable(QString::number(s.orange())));
    QVERIFY(s.view.hideObject("crate") && s.view.hideObject("floor"));
    s.world.push("forces", std::make_shared<robotcontrol::WorldForces>(*forces));
    QVERIFY(s.step());
    QCOMPARE(s.orange(), 0);
  }

  void raysEndAtWhatTheyHit() {
    ModesScene s;
    QTest::keyClick(s.canvas, Qt::Key_S, Qt::ShiftModifier);
    QVERIFY(s.step());
    const auto asked =
        std::ranges::find_if(s.world.requests, [](const auto& r) { return r.has_read_ports(); });
    QVERIFY(asked != s.world.requests.end());
    QCOMPARE(asked->read_ports().ports(0), std::string("crate/laser"));
    const auto hit = [](const QColor& c) { return c.red() > 170 && c.green() < 110 && c.blue() < 100; };
    const QImage before = s.picture();
    auto readings = std::make_shared<robotcontrol::PortReadings>();
    auto& laser = *readings->add_readings();
    laser.set_port("crate/laser");
    for (const double range : {4.0, 0.4, 4.0}) laser.add_values(range);
    s.world.push("ports", readings);
    QVERIFY(s.step());
    const QPoint end = s.at({0.31 + 0.4, 0, 0.5});
    bool found = false;
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y) found = found || hit(s.picture().pixelColor(end + QPoint(x, y)));
    QVERIFY2(found, "the ray ahead ends with a point");
    QVERIFY(pictureDifference(before, s.picture()) > 0.0005);
  }

  void theCameraFollowsAnObjectAndLooksOutOfIt() {
    ModesScene s;
    QVERIFY(s.view.followObject("crate", SceneView::Following::kPosition));
    QVERIFY(s.rest());
    QVERIFY((s.canvas->camera().target - robotlink::Vector3(0, 0, 0.3)).norm() < 0.02);
    s.moveTo({0.8, 0.4, 0});
    // Each tick from now on goes a tenth of the way that is left.
    QVERIFY(s.step());
    QVERIFY(s.rest());
    const robotlink::Vector3 target = s.canvas->camera().target;
    QVERIFY2((target - robotlink::Vector3(0.8, 0.4, 0.3)).norm() < 0.02,
             qPrintable(QStringLiteral("%1 %2 %3").arg(target.x()).arg(target.y()).arg(target.z())));
    const double azimuth = s.canvas->camera().azimuth;
    QVERIFY(s.view.followObject("crate", SceneView::Following::kHeading));
    s.moveTo({0.8, 0.4, 0.7});
    QVERIFY(s.step());
    QVERIFY(s.rest());
    QVERIFY(std::abs(s.canvas->camera().azimuth - azimuth) > 0.2);
    QTest::keyClick(s.canvas, Qt::Key_E);
    QVERIFY(s.rest());
    const auto& eye = s.canvas->camera().eyeInField;
    QVERIFY(eye.has_value());
    const robotlink::Vector3 expected(0.8 + 0.35 * std::cos(0.7), 0.4 + 0.35 * std::sin(0.7), 0.6);
    QVERIFY((s.canvas->camera().position() - expected).norm() < 1e-9);
    QCOMPARE(s.canvas->camera().verticalAngle, 0.9);
    QVERIFY2(s.red() == 0 && s.green() > 3000, "the floor is ahead, the crate is behind");
    QTest::keyClick(s.canvas, Qt::Key_E);
    QVERIFY(s.step());
    QVERIFY(!s.canvas->camera().eyeInField && s.red() > 500);
  }

  void anObjectIsFollowedFromWhereItIsSeenAsAWhole() {
    ModesScene s;
    QVERIFY(s.view.followObject("crate", SceneView::Following::kHeading));
    QVERIFY(s.rest());
    const SceneCamera& camera = s.canvas->camera();
    QVERIFY((camera.target - robotlink::Vector3(0, 0, 0.3)).norm() < 0.02);
    QVERIFY2(camera.distance > 1.5 && camera.distance < 2.5, qPrintable(QString::number(camera.distance)));
  }

  void anObjectThatIsGoneIsNamed() {
    ModesScene s;
    QVERIFY(s.view.showOnly("crate", true));
    s.world.push("objects", std::make_shared<robotcontrol::WorldObjects>());
    QVERIFY(s.step());
    QCOMPARE(s.canvas->hint(), QStringLiteral("There is no 'crate' in this scene."));
  }

  void aViewShowsOneObjectAlone() {
    ModesScene s;
    QSignalSpy titles(&s.view, &View::titleChanged);
    QVERIFY(s.view.showOnly("crate/link:core", true));
    QVERIFY(s.rest());
    QVERIFY2(s.red() == 0 && s.green() == 0 && s.blue() > 5000, qPrintable(QString::number(s.blue())));
    QVERIFY(titles.last().first().toString().contains(QStringLiteral("crate/link:core")));
    QVERIFY(s.view.showOnly({}, false));
    QVERIFY(s.step());
    QVERIFY(s.red() > 500);
    QVERIFY(s.view.showOnly("crate", false));
    QVERIFY(s.rest());
    QVERIFY2(s.green() > 500 && s.red() > 5000, "with its surroundings");
  }

  void modesAndObjectsSurvive() {
    ModesScene a;
    QVERIFY(a.view.drawObject({}, "flat"));
    QVERIFY(a.view.showLayer("joints", true) && a.view.showLayer("shadows", false));
    QVERIFY(a.view.hideObject("floor") && a.view.setOpacity("crate/link:box", 0.5));
    QVERIFY(a.view.drawObject("crate/link:core", "wire"));
    QVERIFY(a.view.showOnly("crate", true));
    QVERIFY(a.view.followObject("crate", SceneView::Following::kFirstPerson));
    const QJsonObject state = a.view.saveState();
    ModesScene b;
    b.view.restoreState(state);
    QVERIFY(b.rest());
    QCOMPARE(b.view.saveState(), state);
    QVERIFY(b.canvas->camera().eyeInField.has_value());
    // What older layouts had.
    QJsonObject older;
    older.insert(QStringLiteral("wireFrame"), true);
    b.view.restoreState(older);
    QVERIFY(child<QAction>(b.view, "sceneWireFrameAction").isChecked());
  }

  void wherePartsAreIsCopiedAsNumbers() {
    ModesScene s;
    s.moveTo({0.5, 0.25, 0.5});
    QVERIFY(s.step());
    const QString table = *s.view.numbers();
    QVERIFY(table.startsWith(QStringLiteral("object\tx m")));
    QVERIFY2(table.contains(QStringLiteral("crate\t0.5000\t0.2500\t0.3000\t0.00\t0.00\t28.65\n")),
             qPrintable(table));
  }

  void whatIsShownIsSavedAsPictureAndNumbers() {
    ModesScene s;
    const QTemporaryDir folder;
    const auto written = [&](const char* name) {
      QFile file(folder.filePath(QLatin1String(name)));
      if (!s.view.saveTo(file.fileName()) || !file.open(QIODevice::ReadOnly)) return QByteArray();
      return file.readAll();
    };
    const QByteArray drawing = written("scene.svg");
    QVERIFY(drawing.contains("<svg") && drawing.contains("<image"));
    QVERIFY(written("scene.png").startsWith("\x89PNG"));
    const QByteArray table = written("scene.csv");
    QVERIFY(table.startsWith("object,x m,y m") && table.contains("\ncrate,0.0000,0.0000,0.3000,"));
    QVERIFY(written("scene.txt").contains("\ncrate\t0.0000\t"));
  }

  void whatIsFixedIsOutlinedUnderTheMouseAndWhereItIsSelected() {
    ModesScene s;
    const auto outlined = [&] { return s.step() ? s.orange() : -1; };
    moveMouse(*s.canvas, s.at(ModesScene::kTop));
    QVERIFY(outlined() > 100);
    moveMouse(*s.canvas, s.at({1.2, -0.6, 0}));
    QCOMPARE(outlined(), 0);
    // A joint has no shape; its link has.
    sceneSelection(s.world.context).select("crate/joint:swing");
    const int box = outlined();
    QVERIFY(box > 100);
    sceneSelection(s.world.context).select("crate/link:core");
    const int ball = outlined();
    QVERIFY2(ball >= 0 && ball < box / 4, "the box hides it");
    sceneSelection(s.world.context).select("floor");
    QVERIFY(outlined() > 20);
    QCOMPARE(s.canvas->cursor().shape(), Qt::ArrowCursor);
  }

  void damagedLooksAreLeftOut() {
    ObjectLooks looks;
    looks.restore(
        {QJsonValue(3),
         QJsonObject{{QStringLiteral("object"), QStringLiteral("a")},
                     {QStringLiteral("surface"), QStringLiteral("glass")}},
         QJsonObject{{QStringLiteral("object"), QStringLiteral("b")}, {QStringLiteral("opacity"), -7.0}}});
    const SceneObjects objects;
    QCOMPARE(looks.of("b/link:x", objects).opacity.value(), ObjectLook::kMinOpacity);
    QVERIFY(!looks.of("a", objects).surface && *looks.of("a", objects).isShown);
  }

 private:
  static void doubleClick(QWidget& widget, const QPoint& at) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
    QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, at);
  }
  /// The menu of a right click at a place of the scene.
  static QMenu* menuAt(ModesScene& s, const robotlink::Vector3& place) {
    QTest::mouseClick(s.canvas, Qt::RightButton, {}, s.at(place));
    const auto menus = s.view.findChildren<QMenu*>(QStringLiteral("sceneMenu"));
    return menus.isEmpty() ? nullptr : menus.last();
  }
};

const GuiTest<SceneModesTest> kSceneModesTest;

}  // namespace widgets::test

#include "SceneModesTest.moc"
