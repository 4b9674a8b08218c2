// SPDX-License-Identifier: GPL-3.0-or-later
// The handles, the menu and the history of the objects in the scene view, with the mouse and the keys.
#include "widgets/scene/SceneHands.h"

#include <QAction>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "tests/widgets/scene/ShownScene.h"
#include "widgets/scene/ScenePalette.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {
namespace {

using robotlink::Vector3;

/// The shown field, on which the ball is an object that moves and the post one that does not.
struct HandBench : ShownScene {
  HandBench() {
    robotcontrol::WorldObjects objects;
    const auto add = [&](const char* path, const Vector3& place, bool isMovable) {
      auto& object = *objects.add_objects();
      object.set_path(path);
      object.set_name(path);
      object.set_model(path);
      object.set_is_movable(isMovable);
      object.set_frame("field");
      object.mutable_pose_in_frame()->mutable_position()->set_x(place.x());
      object.mutable_pose_in_frame()->mutable_position()->set_y(place.y());
      object.mutable_pose_in_frame()->mutable_position()->set_z(place.z());
      object.mutable_pose_in_frame()->mutable_orientation()->set_w(1);
    };
    add("ball", kBall, true);
    add("post", {1, 0.5, 0}, false);
    world.push("objects", std::make_shared<robotcontrol::WorldObjects>(objects));
    if (!placeThings()) qFatal("the scene is not drawn");
  }
  void select(const char* object) {
    sceneSelection(world.context).select(object);
    if (!step()) qFatal("the scene is not drawn");
  }
  /// A place on an axis of the handles at a point, in their lengths.
  QPoint onHandle(const Vector3& place, int axis, double share) const {
    Gizmo gizmo;
    gizmo.pose.translation() = place;
    return at(place + share * gizmo.length(canvas->camera(), canvas->size()) * Vector3::Unit(axis));
  }
  const robotcontrol::PlaceModel& asked() const { return world.requests.back().place_model(); }
  QAction& action(const char* name) { return child<QAction>(view, name); }
  SceneEdits& edits() { return sceneEdits(world.context); }
};

}  // namespace

class SceneHandsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!sceneCanBeDrawn()) QSKIP("no OpenGL here");
  }

  void aClickSelectsAndAHandleMoves() {
    HandBench s;
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, s.at(kBall));
    QCOMPARE(sceneSelection(s.world.context).object(), std::string("ball"));
    QVERIFY(s.step());
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, s.onHandle(kBall, 2, 0.95), s.onHandle(kBall, 2, 1.6));
    QCOMPARE(s.canvas->camera(), camera);
    QVERIFY(s.asked().height() > kBall.z() + 0.1);
    QVERIFY(std::abs(s.asked().pose_in_field().x() - kBall.x()) < 1e-6);
    QVERIFY(std::abs(s.asked().pose_in_field().y() - kBall.y()) < 1e-6);
  }

  void controlSnapsToAGrid() {
    HandBench s;
    s.select("ball");
    drag(*s.canvas, Qt::LeftButton, s.onHandle(kBall, 0, 0.95), s.onHandle(kBall, 0, 1.5), {},
         Qt::ControlModifier);
    const double x = s.asked().pose_in_field().x() * 10;
    QVERIFY(std::abs(x - std::round(x)) < 1e-6 && std::abs(x - 10 * kBall.x()) > 0.5);
  }

  void escapeEndsADragAsIfThereHadBeenNone() {
    HandBench s;
    s.select("ball");
    const QPoint from = s.onHandle(kBall, 0, 0.95), to = s.onHandle(kBall, 0, 1.6);
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, from);
    moveMouse(*s.canvas, (from + to) / 2, Qt::LeftButton);
    moveMouse(*s.canvas, to, Qt::LeftButton);
    s.view.tick();
    QVERIFY(std::abs(s.asked().pose_in_field().x() - kBall.x()) > 0.01);
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(std::abs(s.asked().pose_in_field().x() - kBall.x()) < 1e-6);
    const auto requests = s.world.requests.size();
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, to);
    s.view.tick();
    QCOMPARE(s.world.requests.size(), requests);
    QVERIFY(!s.edits().canUndo());
  }

  void aMoveIsUndoneAndRedoneByKeys() {
    HandBench s;
    s.select("ball");
    drag(*s.canvas, Qt::LeftButton, s.onHandle(kBall, 1, 0.95), s.onHandle(kBall, 1, 1.5));
    const double moved = s.asked().pose_in_field().y();
    QVERIFY(s.action("sceneEditUndoAction").isEnabled());
    QTest::keyClick(s.canvas, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(std::abs(s.asked().pose_in_field().y() - kBall.y()) < 1e-6);
    QTest::keySequence(s.canvas, QKeySequence(QKeySequence::Redo));
    QCOMPARE(s.asked().pose_in_field().y(), moved);
  }

  void withoutATextOnlyWhatMovesHasHandles() {
    HandBench s;
    s.select("post");
    const SceneCamera before = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, s.onHandle({1, 0.5, 0}, 0, 0.95), s.onHandle({1, 0.5, 0}, 0, 1.5));
    QVERIFY(!(s.canvas->camera() == before));
    QVERIFY(s.world.requests.empty());
  }

  void theMenuIsAboutWhatIsUnderTheMouse() {
    HandBench s;
    QTest::mouseClick(s.canvas, Qt::RightButton, {}, s.at(kBall));
    QCOMPARE(sceneSelection(s.world.context).object(), std::string("ball"));
    auto* menu = s.view.findChild<QMenu*>(QStringLiteral("sceneMenu"));
    QVERIFY(menu != nullptr);
    QStringList names;
    for (const QAction* action : menu->actions()) names << action->objectName();
    QVERIFY(names.contains(QStringLiteral("sceneWriteAction")));
    QVERIFY(names.contains(QStringLiteral("sceneGoToTextAction")));
    QVERIFY2(!s.action("sceneEraseAction").isEnabled(), "no text of the scene can be changed here");
    menu->close();
    QTRY_VERIFY(s.action("sceneEraseAction").isEnabled());
  }

  void whatMovesIsPinnedAndReleased() {
    HandBench s;
    s.select("ball");
    QTest::keyClick(s.canvas, Qt::Key_P);
    QCOMPARE(s.world.requests.back().pin_object().path(), std::string("ball"));
    QVERIFY(s.world.requests.back().pin_object().pinned());
    robotcontrol::SimulationStatus status;
    status.add_pinned("ball/link:ball");
    s.world.push("simulation", std::make_shared<robotcontrol::SimulationStatus>(status));
    QVERIFY(s.step());
    QTest::keyClick(s.canvas, Qt::Key_P);
    QVERIFY(!s.world.requests.back().pin_object().pinned());
    QTest::keyClick(s.canvas, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(s.world.requests.back().pin_object().pinned());
  }

  void whatIsLetGoOfInMotionIsThrownWhileTheSimulationRuns() {
    HandBench s;
    const auto throws = [&] {
      const QPoint from = s.at(kBall), to = s.at(kBall + Vector3(0.4, 0, 0));
      QTest::mousePress(s.canvas, Qt::LeftButton, {}, from, 10);
      for (int i = 1; i <= 4; ++i) {
        QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 4, Qt::NoButton, Qt::LeftButton, {});
        move.setTimestamp(static_cast<ulong>(1'000'000 + 20 * i));
        QApplication::sendEvent(s.canvas, &move);
      }
      QMouseEvent release(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton, {});
      release.setTimestamp(1'000'090);
      QApplication::sendEvent(s.canvas, &release);
      return s.world.requests.back().has_throw_model();
    };
    QVERIFY(!throws());
    robotcontrol::SimulationStatus status;
    status.set_running(true);
    status.add_models("ball");
    s.world.push("simulation", std::make_shared<robotcontrol::SimulationStatus>(status));
    QVERIFY(s.step());
    QVERIFY(throws());
    const auto& thrown = s.world.requests.back().throw_model();
    QCOMPARE(thrown.model(), std::string("ball"));
    QVERIFY(thrown.velocity().x() > 2 && std::abs(thrown.velocity().y()) < 1);
  }

  void whatCannotBeDoneIsSaid() {
    HandBench s;
    s.select("ball");
    s.action("sceneEraseAction").trigger();
    QVERIFY(child<SceneHands>(s.view, "sceneHands").notice().contains(QStringLiteral("no scene of a file")));
  }

  void thePaletteListsShapesAndIsDragged() {
    HandBench s;
    QTest::keyClick(s.canvas, Qt::Key_Insert);
    auto& palette = child<ScenePalette>(s.view, "scenePalette");
    QVERIFY(palette.isVisible());
    QVERIFY(palette.count() >= 6);
    QCOMPARE(palette.findItems(QStringLiteral("Wall"), Qt::MatchExactly).size(), 1);
    QMimeData nothing;
    QVERIFY(ScenePalette::kindIn(nothing).isEmpty());
  }
};

const GuiTest<SceneHandsTest> kSceneHandsTest;

}  // namespace widgets::test

#include "SceneHandsTest.moc"
