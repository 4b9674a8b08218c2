// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/SceneTreeModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "robotcontrol/World.pb.h"

namespace widgets::test {
namespace {

using robotcontrol::WorldObject;

class SceneTreeModelTest : public testing::Test {
 protected:
  WorldObject& add(const char* path, const char* parent, WorldObject::Kind kind = WorldObject::MODEL) {
    auto& object = *objects.add_objects();
    object.set_path(path);
    object.set_parent(parent);
    object.set_name(std::string(path).substr(std::string(path).rfind('/') + 1));
    object.set_kind(kind);
    return object;
  }
  robotcontrol::WorldPort& addPort(const char* path, bool isActuator = false) {
    auto& port = *add(path, "red1", isActuator ? WorldObject::ACTUATOR : WorldObject::SENSOR).mutable_port();
    port.set_path(path);
    port.set_is_actuator(isActuator);
    return port;
  }
  void show() { model.setObjects(std::make_shared<const robotcontrol::WorldObjects>(objects)); }
  static void read(robotcontrol::PortReading& reading, const char* port,
                   std::initializer_list<double> values) {
    reading.set_port(port);
    for (const double value : values) reading.add_values(value);
  }
  void showReadings() { model.setReadings(std::make_shared<const robotcontrol::PortReadings>(readings)); }
  std::string value(const char* path) const {
    return model.indexOf(path).siblingAtColumn(SceneTreeModel::kValue).data().toString().toStdString();
  }
  /// The names below an object, or at the root.
  std::vector<std::string> below(const char* path = nullptr) const {
    const QModelIndex parent = path == nullptr ? QModelIndex() : model.indexOf(path);
    std::vector<std::string> names;
    for (int row = 0; row < model.rowCount(parent); ++row)
      names.push_back(model.index(row, 0, parent).data().toString().toStdString());
    return names;
  }

  robotcontrol::WorldObjects objects;
  robotcontrol::PortReadings readings;
  SceneTreeModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

using Below = std::vector<std::string>;

TEST_F(SceneTreeModelTest, childrenMayComeBeforeTheirParents) {
  add("red1/head", "red1", WorldObject::LINK);
  add("red1/head/camera", "red1/head", WorldObject::SENSOR);
  add("red1", "", WorldObject::ROBOT);
  add("red1/leg", "red1", WorldObject::LINK);
  show();
  EXPECT_EQ(below(), Below{"red1"});
  EXPECT_EQ(below("red1"), (Below{"head", "leg"}));
  EXPECT_EQ(model.parent(model.indexOf("red1/head/camera")), model.indexOf("red1/head"));
  EXPECT_EQ(model.index(0, SceneTreeModel::kKind).data().toString(), QStringLiteral("robot"));
}

TEST_F(SceneTreeModelTest, objectsOfUnknownParentsLieAtTheRoot) {
  add("red1/head", "red1");
  show();
  EXPECT_EQ(below(), Below{"head"});
}

TEST_F(SceneTreeModelTest, ofAPathThatIsThereTwiceTheFirstObjectCounts) {
  add("box", "", WorldObject::MODEL);
  add("box", "", WorldObject::BALL);
  show();
  EXPECT_EQ(model.rowCount(), 1);
  EXPECT_EQ(model.object(std::string("box"))->kind(), WorldObject::MODEL);
}

TEST_F(SceneTreeModelTest, objectsThatAreTheirOwnAncestorsLieAtTheRoot) {
  add("self", "self");
  add("a", "b");
  add("b", "a");
  add("child", "self");
  show();
  EXPECT_EQ(model.indexOf("self").parent(), QModelIndex());
  int count = 0;
  std::vector<QModelIndex> open{{}};
  while (!open.empty()) {
    const QModelIndex parent = open.back();
    open.pop_back();
    for (int row = 0; row < model.rowCount(parent); ++row, ++count)
      open.push_back(model.index(row, 0, parent));
  }
  EXPECT_EQ(count, 4) << "each is shown, once";
}

TEST_F(SceneTreeModelTest, aSensorHasItsValuesWithTheirUnit) {
  addPort("red1/angle").set_unit("rad");
  addPort("red1/accel").set_unit("m/s²");
  addPort("red1/laser");
  addPort("red1/none");
  show();
  EXPECT_EQ(value("red1/angle"), "–");
  read(*readings.add_readings(), "red1/angle", {0.5});
  read(*readings.add_readings(), "red1/accel", {0.1, -0.20001, 9.81234});
  read(*readings.add_readings(), "red1/laser", {1, 2, 3, 4, 5});
  read(*readings.add_readings(), "red1/none", {});
  showReadings();
  EXPECT_EQ(value("red1/angle"), "0.5 rad");
  EXPECT_EQ(value("red1/accel"), "0.1 -0.2 9.812 m/s²");
  EXPECT_EQ(value("red1/laser"), "5 values");
  EXPECT_EQ(value("red1/none"), "");
  model.setReadings(nullptr);
  EXPECT_EQ(value("red1/angle"), "–");
}

TEST_F(SceneTreeModelTest, aCameraHasTheSizeOfItsImages) {
  auto& camera = addPort("red1/camera");
  camera.set_image_stream("red1/camera/image");
  for (const int length : {160, 208, 3}) camera.add_shape(length);
  addPort("red1/plain").set_image_stream("red1/plain/image");
  show();
  EXPECT_EQ(value("red1/camera"), "208 × 160");
  EXPECT_EQ(value("red1/plain"), "–") << "its size is not known";
}

TEST_F(SceneTreeModelTest, anActuatorHasAValueWhileItIsHeld) {
  addPort("red1/motor", true).set_unit("rad");
  show();
  EXPECT_EQ(value("red1/motor"), "");
  read(*readings.add_held(), "red1/motor", {1.5});
  showReadings();
  EXPECT_EQ(value("red1/motor"), "1.5 rad, held");
}

TEST_F(SceneTreeModelTest, onlyValuesThatWereOrAreThereAreAnnounced) {
  addPort("red1/a");
  addPort("red1/b");
  addPort("red1/c");
  show();
  read(*readings.add_readings(), "red1/a", {1});
  read(*readings.add_readings(), "unknown", {1});
  showReadings();
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  readings.clear_readings();
  read(*readings.add_readings(), "red1/b", {1});
  showReadings();
  ASSERT_EQ(changes.count(), 2);
  for (const auto& change : changes)
    EXPECT_EQ(change[0].toModelIndex().column(), int{SceneTreeModel::kValue});
  EXPECT_EQ(model.reading("red1/a"), nullptr);
}

TEST_F(SceneTreeModelTest, actuatorsBelowAnObjectAreFoundInTheOrderOfTheTree) {
  add("red1", "", WorldObject::ROBOT);
  addPort("red1/first", true);
  addPort("red1/sensor");
  add("red1/arm", "red1", WorldObject::LINK);
  addPort("red1/last", true);
  objects.add_objects()->CopyFrom(objects.objects(1));
  auto& deep = *objects.mutable_objects()->rbegin();
  deep.set_path("red1/arm/deep");
  deep.set_name("deep");
  deep.set_parent("red1/arm");
  show();
  Below names;
  for (const auto* actuator : model.actuatorsOf(model.indexOf("red1"))) names.push_back(actuator->name());
  EXPECT_EQ(names, (Below{"first", "deep", "last"}));
  EXPECT_TRUE(model.actuatorsOf(model.indexOf("red1/sensor")).empty());
  EXPECT_TRUE(model.actuatorsOf({}).empty());
}

TEST_F(SceneTreeModelTest, toolTipsSayTypeRangeAndUnitOfAPort) {
  auto& port = addPort("red1/motor", true);
  port.set_type("angle");
  port.set_minimum(-1.5);
  port.set_maximum(0.25);
  port.set_unit("rad");
  addPort("red1/touch").set_type("contact");
  add("box", "");
  show();
  const auto tip = [this](const char* path) {
    return model.indexOf(path).data(Qt::ToolTipRole).toString().toStdString();
  };
  EXPECT_EQ(tip("red1/motor"), "red1/motor (actuator)\nangle: -1.5 … 0.25 rad");
  EXPECT_EQ(tip("red1/touch"), "red1/touch (sensor)\ncontact") << "both 0: the range is not known";
  EXPECT_EQ(tip("box"), "box (model)");
  EXPECT_EQ(model.indexOf("red1/touch").data(SceneTreeModel::kFilterRole).toString(),
            QStringLiteral("red1/touch contact sensor"));
}

TEST_F(SceneTreeModelTest, numbersThatDifferHaveTheirOwnRangesAndUnits) {
  auto& port = addPort("car/drive", true);
  port.set_type("motion");
  port.set_minimum(-3);
  port.set_maximum(3);
  port.set_unit("m/s, rad");
  port.add_shape(2);
  auto& object = *objects.mutable_objects()->rbegin();
  for (const auto& [name, sign] : {std::pair("minimum", -1), std::pair("maximum", 1)}) {
    auto& limits = *object.add_properties();
    limits.set_name(name);
    limits.add_values(3 * sign);
    limits.add_values(0.7 * sign);
  }
  show();
  EXPECT_EQ(model.indexOf("car/drive").data(Qt::ToolTipRole).toString(),
            QStringLiteral("car/drive (actuator)\nmotion: -3 … 3 m/s; -0.7 … 0.7 rad"));
}

TEST_F(SceneTreeModelTest, whatBecameOfACommandIsNotWhatIsHeld) {
  addPort("red1/motor", true);
  show();
  read(*readings.add_readings(), "red1/motor", {1, 0});
  showReadings();
  EXPECT_EQ(value("red1/motor"), "");
  EXPECT_EQ(model.held("red1/motor"), nullptr);
  ASSERT_NE(model.reading("red1/motor"), nullptr);
  EXPECT_EQ(model.reading("red1/motor")->values(1), 0);
}

TEST_F(SceneTreeModelTest, theSameMessageKeepsTheTreeAndNoneEmptiesIt) {
  add("box", "");
  const auto shown = std::make_shared<const robotcontrol::WorldObjects>(objects);
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  model.setObjects(shown);
  model.setObjects(shown);
  EXPECT_EQ(resets.count(), 1);
  model.setObjects(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_FALSE(model.indexOf("box").isValid());
  EXPECT_EQ(model.object(std::string("box")), nullptr);
  EXPECT_EQ(model.object(QModelIndex()), nullptr);
}

TEST_F(SceneTreeModelTest, aKindThatIsNotKnownHasNoName) {
  add("new", "", static_cast<WorldObject::Kind>(999));
  show();
  EXPECT_EQ(model.index(0, SceneTreeModel::kKind).data().toString(), QString());
}

}  // namespace
}  // namespace widgets::test
