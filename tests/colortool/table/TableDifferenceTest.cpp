// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/TableDifference.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "colortool/table/NamedColorTable.h"
#include "tests/game/Data.h"

namespace colortool {
namespace {

using Change = TableDifference::Change;

const ColorClasses kComparedClasses({{"orange", {255, 128, 0}}, {"green", {0, 160, 40}}});

/// Cells of row y = 1, cb = 2, from cr = `first` on.
ColorTable tableWith(std::initializer_list<std::uint8_t> cells, int first = 0) {
  ColorTable table;
  for (const std::uint8_t cell : cells) table.setCell(1, 2, first++, cell);
  return table;
}
std::size_t differentCell(int cr) {
  return (std::size_t{1} * 64 + 2) * 64 + static_cast<std::size_t>(cr);
}

TEST(TableDifference, countsWhatBecameOfEachClass) {
  const TableDifference difference(tableWith({1, 1, 1, 2, 0}), kComparedClasses, tableWith({1, 2, 0, 2, 2}),
                                   kComparedClasses);
  EXPECT_EQ(difference.changed(), 3U);
  EXPECT_EQ(difference.count(1, 2), 1U);
  EXPECT_EQ(difference.count(1, 0), 1U);
  EXPECT_EQ(difference.count(0, 2), 1U);
  EXPECT_EQ(difference.count(2, 1), 0U);
  EXPECT_EQ(difference.ofClass(1), (TableDifference::OfClass{3, 1, 0, 2}));
  EXPECT_EQ(difference.ofClass(2), (TableDifference::OfClass{1, 3, 2, 0}));
  EXPECT_EQ(difference.ofClass(0),
            (TableDifference::OfClass{ColorTable::kCellCount - 4, ColorTable::kCellCount - 4, 1, 1}));
}

TEST(TableDifference, saysWhichCellsChanged) {
  const TableDifference difference(tableWith({1, 1, 1, 2, 0}, 60 - 1), kComparedClasses,
                                   tableWith({1, 2, 0, 2, 2}, 60 - 1), kComparedClasses);
  const auto expect = [](const CellSet& cells, std::initializer_list<int> wanted) {
    EXPECT_EQ(cells.size(), wanted.size());
    for (const int cr : wanted) EXPECT_TRUE(cells.contains(differentCell(cr))) << cr;
  };
  expect(difference.cells(), {60, 61, 63});
  expect(difference.cells(2, Change::kGained), {60, 63});
  expect(difference.cells(2, Change::kLost), {});
  expect(difference.cells(1, Change::kLost), {60, 61});
  expect(difference.cells(1, Change::kAny), {60, 61});
  expect(difference.cells(0, Change::kAny), {61, 63});
}

TEST(TableDifference, classesAreThoseOfTheSameName) {
  const ColorClasses others({{"pink", {250, 90, 160}}, {"green", {1, 1, 1}}, {"orange", {2, 2, 2}}});
  // Before: pink, green, orange, green. After: none, green, orange, orange.
  const TableDifference difference(tableWith({1, 2, 3, 2}), others, tableWith({0, 2, 1, 1}),
                                   kComparedClasses);
  ASSERT_EQ(difference.classes().names(), (std::vector<std::string>{"orange", "green", "pink"}));
  EXPECT_EQ(difference.classes().shownColor(2), (robotlink::Rgb{0, 160, 40})) << "as they are shown now";
  EXPECT_EQ(difference.changed(), 2U);
  EXPECT_EQ(difference.count(3, 0), 1U);
  EXPECT_EQ(difference.count(2, 1), 1U);
  EXPECT_EQ(difference.ofClass(3), (TableDifference::OfClass{1, 0, 0, 1}));
}

TEST(TableDifference, numbersWithoutAClassAreNone) {
  const TableDifference difference(tableWith({1, 9, 200}), kComparedClasses, tableWith({1, 0, 2}),
                                   kComparedClasses);
  EXPECT_EQ(difference.changed(), 1U);
  EXPECT_EQ(difference.count(0, 2), 1U);
}

/// The parameter is the source of a team's tables.
class TwoTables : public testing::TestWithParam<std::string> {};

TEST_P(TwoTables, differInCellsThatOneLostAndAnotherGained) {
  const auto folder = game::dataOf(GetParam()) / "colour/bhuman2009/tables";
  std::vector<ColorTable> tables;
  std::vector<ColorClasses> classes;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the real tables are not in " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".c64") continue;
    const auto loaded = NamedColorTable::load(entry.path());
    ASSERT_TRUE(loaded) << entry.path();
    tables.push_back(
        ColorTable::translated(loaded->file.singleClasses(), classNumbers(loaded->classes, loaded->classes)));
    classes.push_back(loaded->classes);
  }
  ASSERT_EQ(tables.size(), 2U);
  const TableDifference difference(tables[0], classes[0], tables[1], classes[1]);
  std::uint64_t gained = 0, lost = 0;
  for (int i = 0; i < difference.classes().size(); ++i) {
    const auto sum = difference.ofClass(i);
    EXPECT_EQ(sum.before + sum.gained - sum.lost, sum.after);
    EXPECT_EQ(difference.cells(i, Change::kGained).size(), sum.gained);
    EXPECT_EQ(difference.cells(i, Change::kLost).size(), sum.lost);
    gained += sum.gained;
    lost += sum.lost;
  }
  EXPECT_GT(difference.changed(), 1000U);
  EXPECT_EQ(gained, difference.changed());
  EXPECT_EQ(lost, difference.changed());
  EXPECT_EQ(difference.cells().size(), difference.changed());
}

INSTANTIATE_TEST_SUITE_P(Data, TwoTables, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
}  // namespace colortool
