// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/NamedColorTable.h"

#include <gmock/gmock.h>

#include <fstream>

#include "colortool/image/ClassPresets.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace {

using colortool::ColorClasses;
using colortool::NamedColorTable;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr char kFirstLine[] = "robotcontrol-color-classes 1\n";

class NamedColorTableTest : public testing::Test {
 protected:
  NamedColorTable saved(const ColorClasses& classes, std::uint8_t cell) const {
    NamedColorTable table;
    table.classes = classes;
    table.file.cells[1000] = cell;
    EXPECT_TRUE(table.save(file_));
    return table;
  }
  void name(const std::string& text) const { std::ofstream(beside_) << text; }
  std::string refusal() const {
    const auto loaded = NamedColorTable::load(file_);
    return loaded ? "" : robotlink::describe(loaded.error());
  }
  static ColorClasses preset(const char* name) { return colortool::findClassPreset(name)->classes(); }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "t.c64", beside_ = folder_ / "t.c64.classes";
};

TEST_F(NamedColorTableTest, keepsItsNamesAndColorsBesideTheTable) {
  const NamedColorTable table = saved(preset("2002"), 9);
  const auto again = NamedColorTable::load(file_);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->classes, table.classes);
  EXPECT_EQ(again->file, table.file);
  EXPECT_THAT(robotlink::readFile(beside_).value(),
              testing::StartsWith(std::string(kFirstLine) + "orange #ff6900\nyellow #fad700\n"));
}

TEST_F(NamedColorTableTest, ofTheKnownFilesNeedsNoNames) {
  saved(preset("2002"), 1);
  ASSERT_TRUE(std::filesystem::exists(beside_));
  saved(preset("bhuman2009"), 3);
  EXPECT_FALSE(std::filesystem::exists(beside_)) << "the old names are not the table's";
  EXPECT_EQ(NamedColorTable::load(file_)->classes, preset("bhuman2009"));
}

TEST_F(NamedColorTableTest, namesOfOneAnotherDoNotLoseClassesPastThePreset) {
  NamedColorTable table = saved(preset("bhuman2009"), 10);
  const auto loaded = NamedColorTable::load(file_);
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->classes.size(), 11);
  EXPECT_EQ(loaded->classes.name(8), "robotBlue");
  EXPECT_EQ(loaded->classes.name(10), "class 10");
  EXPECT_NE(loaded->classes.shownColor(9), loaded->classes.shownColor(10));
}

TEST_F(NamedColorTableTest, takesNamesWithSpacesAndBlankLines) {
  saved(preset("bhuman2009"), 1);
  name(std::string(kFirstLine) + "\n  sky blue\t#0102fF \r\nball #FF0000");
  const auto loaded = NamedColorTable::load(file_);
  ASSERT_TRUE(loaded) << refusal();
  EXPECT_THAT(loaded->classes.names(), ElementsAre("sky blue", "ball"));
  EXPECT_EQ(loaded->classes.shownColor(1), (robotlink::Rgb{1, 2, 255}));
}

TEST_F(NamedColorTableTest, brokenNamesAreToldWithTheirLines) {
  saved(preset("bhuman2009"), 2);
  name("");
  EXPECT_THAT(refusal(), HasSubstr("t.c64.classes:1: the file is empty"));
  name("orange #ff0000\n");
  EXPECT_THAT(refusal(), HasSubstr("t.c64.classes:1: this is not a file of color classes"));
  name(std::string(kFirstLine) + "orange\ngreen #00ff00\nred #12345\ngreen #000000\nnone #000000\n#ff0000\n");
  const std::string all = refusal();
  EXPECT_THAT(all, HasSubstr("t.c64.classes:2: a class is expected here: its name and its color"));
  EXPECT_THAT(all, HasSubstr("t.c64.classes:4: a class is expected here"));
  EXPECT_THAT(all, HasSubstr("t.c64.classes:5: the class 'green' appears here for the second time"));
  EXPECT_THAT(all, HasSubstr("t.c64.classes:6: 'none' stands for pixels of no class"));
  EXPECT_THAT(all, HasSubstr("t.c64.classes:7: a class is expected here"));
  name(std::string(kFirstLine) + "green #00ff00\n");
  EXPECT_THAT(refusal(), HasSubstr("1 classes are named here, but the table has cells of class 2"));
  name(std::string(kFirstLine) + std::string(70'000, '\n'));
  EXPECT_NE(refusal(), "");
}

TEST_F(NamedColorTableTest, manyErrorsAndManyClassesAreCutShort) {
  std::string many = kFirstLine, wrong = kFirstLine;
  for (int i = 1; i <= 200; ++i) {
    many += "c" + std::to_string(i) + " #000000\n";
    wrong += "?\n";
  }
  const auto room = colortool::parseColorClasses(many, "f");
  ASSERT_FALSE(room);
  EXPECT_THAT(room.error().front().describe(), HasSubstr("f:129: there are more than 127 classes"));
  EXPECT_EQ(room.error().size(), 20U);
  EXPECT_EQ(colortool::parseColorClasses(wrong, "f").error().size(), 20U);
}

TEST_F(NamedColorTableTest, anOldTableKeepsItsNamesIfTheNewOneCannotBeWritten) {
  saved(preset("2002"), 1);
  const std::string before = robotlink::readFile(beside_).value();
  std::filesystem::remove(file_);
  std::filesystem::create_directories(file_ / "in the way");
  NamedColorTable table;
  table.classes = colortool::chooseClasses(std::vector<std::string>{"a", "b"}).value();
  EXPECT_FALSE(table.save(file_));
  EXPECT_EQ(robotlink::readFile(beside_).value(), before);
  std::filesystem::remove(beside_);
  EXPECT_FALSE(table.save(file_));
  EXPECT_FALSE(std::filesystem::exists(beside_));
}

TEST_F(NamedColorTableTest, moreClassesThanTheFormatHasAreRefused) {
  std::vector<std::string> names;
  for (int i = 1; i <= 128; ++i) names.push_back("c" + std::to_string(i));
  NamedColorTable table;
  table.classes = colortool::chooseClasses(names).value();
  const auto result = table.save(file_);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text, HasSubstr("has room for 127 classes, not for 128"));
  EXPECT_TRUE(folder_.files().empty());
}

}  // namespace
