// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertiesModel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "robotcontrol/World.pb.h"

namespace widgets::test {
namespace {

/// A box with a mass, a size and a text, of which a file has the first two.
class PropertiesModelTest : public testing::Test {
 protected:
  PropertiesModelTest() {
    box.set_name("box");
    box.set_is_movable(true);
    addNumbers("mass", {2.5}, "kg", {"link[body]", "inertial", "mass"});
    addNumbers("size", {1, 2, 3}, "m", {"link[body]", "size"});
    auto& shape = *box.add_properties();
    shape.set_name("shape");
    shape.set_text("cylinder");
    QObject::connect(&model, &PropertiesModel::refused, &model,
                     [this](const QString& reason) { refusals.push_back(reason.toStdString()); });
  }
  void addNumbers(const char* name, std::initializer_list<double> values, const char* unit,
                  std::initializer_list<const char*> element) {
    auto& property = *box.add_properties();
    property.set_name(name);
    for (const double value : values) property.add_values(value);
    property.set_unit(unit);
    property.set_file("/scenes/box.sdf");
    for (const char* step : element) property.add_element(step);
  }
  void show(bool isWritable = true) { model.show(&box, std::nullopt, isWritable); }
  QModelIndex cell(int row, int column = PropertiesModel::kValue) const { return model.index(row, column); }
  std::string text(int row, int column = PropertiesModel::kValue) const {
    return cell(row, column).data().toString().toStdString();
  }
  std::string tip(int row) const { return cell(row).data(Qt::ToolTipRole).toString().toStdString(); }
  bool isEditable(int row) const { return model.flags(cell(row)).testFlag(Qt::ItemIsEditable); }
  bool type(int row, const char* typed) { return model.setData(cell(row), QString::fromUtf8(typed)); }

  robotcontrol::WorldObject box;
  PropertiesModel model;
  std::vector<std::string> refusals;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

constexpr ObjectPose kPose{1, -2, 0.05, 0.1, 0, -1.5};

TEST_F(PropertiesModelTest, aPoseComesFirstInMetersAndRadians) {
  model.show(&box, kPose, true);
  ASSERT_EQ(model.rowCount(), 9);
  EXPECT_EQ(text(1, PropertiesModel::kName), "y");
  EXPECT_EQ(text(1), "-2.0000");
  EXPECT_EQ(text(2, PropertiesModel::kUnit), "m");
  EXPECT_EQ(text(3, PropertiesModel::kUnit), "rad");
  EXPECT_EQ(text(5, PropertiesModel::kName), "heading");
  EXPECT_EQ(text(6, PropertiesModel::kName), "mass");
}

TEST_F(PropertiesModelTest, whatAFileHasIsEditableAndTheRestIsNot) {
  show();
  EXPECT_EQ(text(1), "1 2 3");
  EXPECT_EQ(text(2), "cylinder");
  EXPECT_TRUE(isEditable(0));
  EXPECT_FALSE(isEditable(2));
  EXPECT_FALSE(model.flags(cell(0, PropertiesModel::kUnit)).testFlag(Qt::ItemIsEditable));
  EXPECT_EQ(tip(0), "Double click to change it in /scenes/box.sdf");
  EXPECT_EQ(tip(2), "cylinder (cannot be changed here: no single number in the scene's files sets it)");
  show(false);
  EXPECT_FALSE(isEditable(0));
  EXPECT_FALSE(type(0, "3"));
}

TEST_F(PropertiesModelTest, aTextOfAFileIsEdited) {
  auto& color = *box.add_properties();
  color.set_name("palette_color");
  color.set_text("orange");
  color.set_file("/scenes/box.sdf");
  color.add_element("robotcontrol:color");
  show();
  EXPECT_TRUE(type(3, " blue "));
  EXPECT_FALSE(type(3, " "));
  ASSERT_EQ(model.edits().size(), 1U);
  EXPECT_EQ(model.edits()[0].value, "blue");
}

TEST_F(PropertiesModelTest, anEditIsKeptForItsElement) {
  show();
  QSignalSpy changes(&model, &PropertiesModel::editsChanged);
  EXPECT_TRUE(type(0, " 3.25 "));
  EXPECT_TRUE(type(1, "1  2.5 3e0"));
  EXPECT_EQ(changes.count(), 2);
  const auto edits = model.edits();
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[0].file, "/scenes/box.sdf");
  EXPECT_EQ(edits[0].element, (std::vector<std::string>{"link[body]", "inertial", "mass"}));
  EXPECT_EQ(edits[0].value, "3.25");
  EXPECT_EQ(edits[1].value, "1 2.5 3");
  show();
  EXPECT_EQ(text(0), "3.25");
  EXPECT_TRUE(cell(0).data(Qt::FontRole).isValid()) << "it is not in the file yet";
  EXPECT_EQ(tip(0).rfind("Not in the file yet", 0), 0U) << tip(0);
}

TEST_F(PropertiesModelTest, theLastEditOfAnElementCounts) {
  show();
  type(0, "3");
  type(0, "4");
  ASSERT_EQ(model.edits().size(), 1U);
  EXPECT_EQ(model.edits()[0].value, "4");
  model.addEdit({"/scenes/box.sdf", {"link[body]", "inertial", "mass"}, "5"});
  ASSERT_EQ(model.edits().size(), 1U);
  EXPECT_EQ(model.edits()[0].value, "5");
}

TEST_F(PropertiesModelTest, whatIsAsItWasIsNoEdit) {
  show();
  EXPECT_TRUE(type(0, "2.5"));
  EXPECT_TRUE(model.edits().empty());
}

TEST_F(PropertiesModelTest, whatCannotBeIsRefusedWithTheReason) {
  show();
  for (const char* typed : {"", "heavy", "1 2", "0", "nan"}) EXPECT_FALSE(type(0, typed)) << typed;
  ASSERT_EQ(refusals.size(), 5U);
  EXPECT_EQ(refusals[3], "mass must be above 0 and at most 100000 kg");
  EXPECT_TRUE(model.edits().empty());
  EXPECT_FALSE(model.setData(cell(0, PropertiesModel::kName), QStringLiteral("1")));
  EXPECT_FALSE(model.setData(cell(0), 1, Qt::CheckStateRole));
}

TEST_F(PropertiesModelTest, takenEditsAreShownUntilTheFileHasThem) {
  show();
  type(0, "3");
  QSignalSpy changes(&model, &PropertiesModel::editsChanged);
  EXPECT_EQ(model.takeEdits().size(), 1U);
  EXPECT_EQ(changes.count(), 1);
  EXPECT_TRUE(model.edits().empty());
  show();
  EXPECT_EQ(text(0), "3");
  EXPECT_FALSE(cell(0).data(Qt::FontRole).isValid());
  model.forgetTaken();
  show();
  EXPECT_EQ(text(0), "2.5");
}

TEST_F(PropertiesModelTest, aNewEditComesBeforeATakenOne) {
  show();
  type(0, "3");
  (void)model.takeEdits();
  show();
  type(0, "4");
  show();
  EXPECT_EQ(text(0), "4");
  model.clearEdits();
  show();
  EXPECT_EQ(text(0), "3");
}

TEST_F(PropertiesModelTest, anEditedPoseIsAnnouncedAndNotKeptForTheFile) {
  model.show(&box, kPose, true);
  std::vector<std::pair<int, double>> edited;
  QObject::connect(&model, &PropertiesModel::poseEdited, &model,
                   [&](int index, double value) { edited.emplace_back(index, value); });
  EXPECT_TRUE(type(1, "3.5"));
  EXPECT_TRUE(type(5, "-0.25"));
  EXPECT_EQ(edited, (std::vector<std::pair<int, double>>{{1, 3.5}, {5, -0.25}}));
  EXPECT_TRUE(model.edits().empty());
  EXPECT_EQ(tip(1), "Double click to move the object");
}

TEST_F(PropertiesModelTest, whatCannotBeMovedKeepsItsPose) {
  box.set_is_movable(false);
  model.show(&box, kPose, true);
  EXPECT_FALSE(isEditable(0));
  EXPECT_EQ(tip(0), "It moves with the object it belongs to");
}

TEST_F(PropertiesModelTest, partsAreNamedBehindTheirProperties) {
  robotcontrol::WorldObject link, solid, visible;
  const auto part = [](robotcontrol::WorldObject& of, const char* name, auto kind) {
    of.set_name(name);
    of.set_kind(kind);
    of.add_properties()->set_name("friction");
  };
  part(link, "body", robotcontrol::WorldObject::LINK);
  part(solid, "hull", robotcontrol::WorldObject::SOLID);
  part(visible, "hull", robotcontrol::WorldObject::SHAPE);
  const std::array<const robotcontrol::WorldObject*, 3> parts{&link, &solid, &visible};
  model.show(nullptr, std::nullopt, true, parts);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(0, PropertiesModel::kName), "friction (body)");
  EXPECT_EQ(text(1, PropertiesModel::kName), "friction (solid hull)");
  EXPECT_EQ(text(2, PropertiesModel::kName), "friction (visible hull)");
}

TEST_F(PropertiesModelTest, namesAreWordsAndUnknownOnesStayAsTheyAre) {
  box.clear_properties();
  for (const char* name : {"center_of_mass", "something_new"}) box.add_properties()->set_name(name);
  show();
  EXPECT_EQ(text(0, PropertiesModel::kName), "center of mass");
  EXPECT_EQ(text(1, PropertiesModel::kName), "something_new");
}

TEST_F(PropertiesModelTest, whatMotorsAndSensorsHaveIsSaidInWords) {
  box.clear_properties();
  for (const char* name : {"angles", "axis_in_link", "azimuth", "elevation", "maximum_force",
                           "maximum_torque", "opening_angle", "opening_angles", "wheel_radius"})
    box.add_properties()->set_name(name);
  show();
  for (int row = 0; row < box.properties_size(); ++row)
    EXPECT_FALSE(text(row, PropertiesModel::kName).find('_') != std::string::npos)
        << box.properties(row).name();
}

TEST_F(PropertiesModelTest, otherNumbersKeepTheRowsAndAnotherObjectDoesNot) {
  model.show(&box, kPose, true);
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  ObjectPose moved = kPose;
  moved[0] = 7;
  model.show(&box, moved, true);
  EXPECT_EQ(text(0), "7.0000");
  EXPECT_EQ(resets.count(), 0);
  model.show(nullptr, std::nullopt, true);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(resets.count(), 1);
}

}  // namespace
}  // namespace widgets::test
