// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of a simulated room, added, moved, changed and saved by hand, with the simulator.
#include <qtadvanceddocking/DockWidget.h>
#include <QComboBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>

#include "robotcontrol/World.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/objects/PropertiesModel.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/world/SceneSelection.h"

namespace app::test {
namespace {

/// A desk with a simulated room of its own.
struct RoomDesk : Desk {
  explicit RoomDesk(const std::filesystem::path& home)
      : Desk(home, Opens::kNothing), file(home / "rooms" / "hall.sdf") {
    const auto text =
        window.context().sceneLanguage->newRoom({.name = "hall", .doorway = true, .robot = {}}, file);
    if (!text) qFatal("no room: %s", text.error().text.c_str());
    std::filesystem::create_directories(file.parent_path());
    if (!robotlink::writeFileAtomically(file, *text)) qFatal("the room cannot be written");
    if (!run("simulation.open '" + file.string() + "'").isEmpty()) qFatal("the room cannot be opened");
  }
  /// Why a command fails; empty: it does not.
  QString run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    return done ? QString() : QString::fromStdString(done.error().describe());
  }
  google::protobuf::RepeatedPtrField<robotcontrol::WorldObject> objects() {
    const auto* all = workbench.session().store().latestAs<robotcontrol::WorldObjects>(
        "objects", workbench.session().timeline().newest());
    return all == nullptr ? google::protobuf::RepeatedPtrField<robotcontrol::WorldObject>() : all->objects();
  }
  /// An object; null: there is none.
  const robotcontrol::WorldObject* object(const std::string& path) {
    const auto* all = workbench.session().store().latestAs<robotcontrol::WorldObjects>(
        "objects", workbench.session().timeline().newest());
    if (all == nullptr) return nullptr;
    const auto found = std::ranges::find(all->objects(), path, &robotcontrol::WorldObject::path);
    return found == all->objects().end() ? nullptr : &*found;
  }
  bool has(const std::string& path) { return object(path) != nullptr; }
  /// The value of a property of the selected object in the view Properties; invalid: it has none.
  QModelIndex property(const QString& title) {
    const auto& model = *find<QTableView>("propertiesTable").model();
    for (int row = 0; row < model.rowCount(); ++row) {
      const QModelIndex name = model.index(row, widgets::PropertiesModel::kName);
      if (name.data().toString() == title) return name.siblingAtColumn(widgets::PropertiesModel::kValue);
    }
    return {};
  }
  std::string saved() const { return robotlink::readFile(file).value_or(""); }
  widgets::SceneBench& bench() { return *window.context().scenes; }

  const std::filesystem::path file;
};

}  // namespace

class SceneHandsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aDoorAndABoxAreAddedAndTheSimulationGoesOn() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    const std::string before = desk.saved();
    QCOMPARE(desk.run("simulation.step"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->steps() == 2, kWaitMs);
    QCOMPARE(desk.run("scene.insert sliding_door 0 0"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("sliding_door"), kWaitMs);
    QCOMPARE(desk.run("scene.insert box 1.5 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box"), kWaitMs);
    QVERIFY(desk.object("box")->is_movable());
    QVERIFY2(!desk.object("sliding_door")->is_movable(), "its frame is fixed to the world");
    QCOMPARE(desk.status()->steps(), 2U);
    QCOMPARE(desk.saved(), before);
    QCOMPARE(desk.run("scene.undo-edit"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.has("box"), kWaitMs);
    QCOMPARE(desk.run("scene.redo-edit"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box"), kWaitMs);
    QVERIFY(desk.bench().saveAll().has_value());
    QVERIFY(desk.saved().find("<uri>model://sliding_door</uri>") != std::string::npos);
    QCOMPARE(desk.run("scene.reload"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.loading(), kWaitMs);
    QVERIFY(desk.has("box"));
  }

  void aWallIsAddedWhoseSizeIsInTheText() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("scene.insert wall 1.3 -1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("wall"), kWaitMs);
    QVERIFY(!desk.object("wall")->is_movable());
    QVERIFY(widgets::sceneEdits(desk.window.context()).isOwn("wall"));
    QVERIFY(desk.bench().saveAll().has_value());
    QVERIFY(desk.saved().find("<size>2 0.1 1</size>") != std::string::npos);
    QVERIFY(desk.saved().find("<pose>1.3 -1 0.5 0 0 0</pose>") != std::string::npos);
    QVERIFY(desk.run("scene.insert wall 100000 0").contains(QStringLiteral("1000 m")));
  }

  void keysUndoAndRedoWhatWasDoneByHand() {
    RoomDesk desk(home_);
    desk.window.show();
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("view.show scene"), QString());
    QCOMPARE(desk.run("scene.insert box 1.5 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box"), kWaitMs);
    auto& canvas = desk.find<QWidget>("sceneCanvas");
    QTest::keyClick(&canvas, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.has("box"), kWaitMs);
    QTest::keyClick(&canvas, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box"), kWaitMs);
  }

  void whatDoesNotFitIsRefusedAndNothingChanges() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QVERIFY(desk.run("scene.insert burger 0 1.5").contains(QStringLiteral("inside")));
    QVERIFY(!desk.bench().hasUnsaved());
    QVERIFY(desk.run("scene.insert unicorn 0 0").contains(QStringLiteral("unicorn")));
    QVERIFY(!desk.run("scene.erase nobody").isEmpty());
  }

  void whatWouldStandInsideWhatIsThereNowIsTakenBack() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("scene.insert box 1 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box"), kWaitMs);
    const QString before = desk.bench().current()->text();
    const QSignalSpy reported(&desk.bench(), &widgets::SceneBench::reported);
    QCOMPARE(desk.run("scene.insert box 1 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!reported.isEmpty(), kWaitMs);
    QVERIFY(reported[0][0].toString().contains(QStringLiteral("there is no room for 'box2'")));
    QCOMPARE(desk.bench().current()->text(), before);
    // The box has gone, and with it what was in the way.
    QCOMPARE(desk.run("scene.place box 2 -1"), QString());
    const auto isAway = [&] {
      const auto* places = desk.workbench.session().store().latestAs<foxglove::FrameTransforms>(
          "transforms", desk.workbench.session().timeline().newest());
      return places != nullptr && std::ranges::any_of(places->transforms(), [](const auto& one) {
               return one.child_frame_id().starts_with("body:box/") && one.translation().x() > 1.9;
             });
    };
    QTRY_VERIFY_WITH_TIMEOUT(isAway(), kWaitMs);
    QCOMPARE(desk.run("scene.insert box 1 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("box2"), kWaitMs);
  }

  void viewsGoOnWithAnObjectUnderItsNewName() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("scene.insert camera 1.5 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("camera"), kWaitMs);
    std::string sensor;
    for (const auto& object : desk.objects())
      if (object.has_port() && object.model() == "camera") sensor = object.path();
    QVERIFY(!sensor.empty());
    for (const std::string& line :
         {std::string("view.show scene"), std::string("scene.follow camera heading"),
          std::string("scene.opacity camera 0.5"), "image.stream image '" + sensor + "'"})
      QCOMPARE(desk.run(line), QString());
    widgets::sceneSelection(desk.window.context()).select(sensor);
    QCOMPARE(desk.run("scene.rename camera eye"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("eye"), kWaitMs);
    const auto says = [&desk](const char* view, const char* text) {
      const QJsonObject state =
          qobject_cast<widgets::View*>(desk.window.docks().named(QLatin1String(view))->widget())->saveState();
      return QJsonDocument(state).toJson().contains(text);
    };
    QTRY_VERIFY(says("scene", "\"followed\": \"eye\""));
    QVERIFY(says("scene", "\"object\": \"eye\""));
    QVERIFY(says("image", "\"eye/"));
    QVERIFY(widgets::sceneSelection(desk.window.context()).object().starts_with("eye/"));
    // Undo gives it its name back.
    QCOMPARE(desk.run("scene.undo-edit"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("camera"), kWaitMs);
    QTRY_VERIFY(says("scene", "\"followed\": \"camera\""));
  }

  void theDoorIsMovedInTheText() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("scene.insert sliding_door 0 0.1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("sliding_door"), kWaitMs);
    widgets::sceneEdits(desk.window.context()).setPose("sliding_door", {0, 0, 0, 0, 0, 0});
    const auto isThere = [&] {
      const auto* door = desk.object("sliding_door");
      return door != nullptr && std::abs(door->pose_in_frame().position().y()) < 1e-9;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isThere(), kWaitMs);
    QVERIFY2(desk.bench().hasUnsaved(), "it is in the text");
  }

  void aPropertyIsChangedInTheRunningSceneAndSaved() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("wall_north"), kWaitMs);
    QCOMPARE(desk.run("scene.insert ball 1 1"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("ball/link:body"), kWaitMs);
    QCOMPARE(desk.run("view.show scene-properties"), QString());
    widgets::sceneSelection(desk.window.context()).select("ball/link:body");
    auto& table = desk.find<QTableView>("propertiesTable");
    const auto mass = [&desk] { return desk.property(QStringLiteral("mass")); };
    QTRY_VERIFY_WITH_TIMEOUT(mass().isValid(), kWaitMs);
    QCOMPARE(mass().data().toString(), QStringLiteral("0.3"));
    QVERIFY(!table.model()->setData(mass(), QStringLiteral("-3")));
    QVERIFY(table.model()->setData(mass(), QStringLiteral("0.7")));
    const auto isHeavier = [&] {
      const auto* link = desk.object("ball/link:body");
      return link != nullptr && link->properties(0).values(0) == 0.7;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isHeavier(), kWaitMs);
    QVERIFY(desk.saved().find("<mass>0.7</mass>") == std::string::npos);
    desk.find<QAction>("propertiesSaveAction").trigger();
    QVERIFY(desk.saved().find("<mass>0.7</mass>") != std::string::npos);
  }

  void whereALampIsIsAPropertyThatIsUndone() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("light:lamp"), kWaitMs);
    QCOMPARE(desk.run("view.show scene-properties"), QString());
    widgets::sceneSelection(desk.window.context()).select("light:lamp");
    const auto place = [&desk] { return desk.property(QStringLiteral("initial position")); };
    QTRY_VERIFY_WITH_TIMEOUT(place().isValid(), kWaitMs);
    auto& model = *desk.find<QTableView>("propertiesTable").model();
    QVERIFY(model.setData(place(), QStringLiteral("1 1 3 0 0 0.5")));
    const auto isThere = [&] {
      const auto* lamp = desk.object("light:lamp");
      return lamp != nullptr && lamp->pose_in_frame().position().x() == 1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isThere(), kWaitMs);
    QVERIFY(desk.object("light:lamp")->pose_in_frame().orientation().z() > 0.2);
    QVERIFY(widgets::sceneEdits(desk.window.context()).undo().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!isThere(), kWaitMs);
  }

  void lampsAndWallsAreMovedInTheText() {
    RoomDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && desk.has("light:lamp"), kWaitMs);
    auto& edits = widgets::sceneEdits(desk.window.context());
    QVERIFY(edits.isOwn("light:lamp") && edits.isOwn("wall_east"));
    edits.setPose("light:lamp", {1, 1, 3, 0, 0, 0});
    const auto isThere = [&] {
      const auto* lamp = desk.object("light:lamp");
      return lamp != nullptr && lamp->pose_in_frame().position().x() == 1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isThere(), kWaitMs);
    edits.setPose("left_of_doorway", {1, 1.25, 0.5, 0, 0, 0});
    QTRY_VERIFY_WITH_TIMEOUT(!edits.isBusy(), kWaitMs);
    QVERIFY(edits.undo().has_value() && edits.undo().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!isThere(), kWaitMs);
  }
};

const widgets::test::GuiTest<SceneHandsGuiTest> kSceneHandsGuiTest;

}  // namespace app::test

#include "SceneHandsGuiTest.moc"
