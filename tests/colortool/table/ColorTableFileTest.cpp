// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/ColorTableFile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/game/Data.h"
#include "tests/game/Tables.h"

using colortool::ColorTableFile;

namespace {

/// Tables that others wrote; the parameter is their source.
class WrittenTables : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder())) GTEST_SKIP() << "the real tables are not at " << folder();
  }
  std::filesystem::path folder() const { return game::dataOf(GetParam()) / "colour/bhuman2009/tables"; }
};

std::ptrdiff_t cellsOf(const ColorTableFile& table, std::uint8_t cell) {
  return std::ranges::count(table.cells, cell);
}

/// Runs of text to the bytes of a file: {{length, cell}, ...}; a last length of 0 ends it.
std::string bytesOf(const std::vector<std::pair<std::uint32_t, int>>& runs) {
  std::string bytes;
  for (const auto& [length, cell] : runs) {
    for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xFFU));
    if (length != 0) bytes.push_back(static_cast<char>(cell));
  }
  return bytes;
}

std::string refusal(const std::string& bytes) {
  const auto table = ColorTableFile::parse(bytes, "some.c64");
  return table ? "" : table.error().describe();
}

}  // namespace

TEST_P(WrittenTables, areWrittenAgainToTheSameBytes) {
  for (const char* name : {"default.c64", "simulator_scenes.c64"}) {
    const auto bytes = robotlink::readFile(folder() / name);
    const auto table = ColorTableFile::load(folder() / name);
    ASSERT_TRUE(bytes && table) << name;
    EXPECT_EQ(table->bytes(), *bytes) << name;
  }
}

TEST_P(WrittenTables, haveTheClassesThatTheirTeamPainted) {
  const auto table = ColorTableFile::load(folder() / "default.c64");
  ASSERT_TRUE(table);
  const ColorTableFile known = game::table();
  const bool real = GetParam() == "real";
  EXPECT_EQ(cellsOf(*table, 1), real ? 1051 : cellsOf(known, 1));  // orange
  EXPECT_EQ(cellsOf(*table, 3), real ? 707 : cellsOf(known, 3));   // blue
  EXPECT_EQ(cellsOf(*table, 5), real ? 1059 : cellsOf(known, 5));  // green
  EXPECT_GT(cellsOf(*table, 5), 100);
}

TEST_P(WrittenTables, arePackedAgainToTheSameCells) {
  for (const char* name : {"default.c64", "simulator_scenes.c64"}) {
    const auto table = ColorTableFile::load(folder() / name);
    ASSERT_TRUE(table);
    const auto packed = ColorTableFile::pack(table->singleClasses(), table->masks());
    EXPECT_EQ(packed.file, *table) << name;
    EXPECT_EQ(packed.reducedCells + packed.emptiedCells, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Data, WrittenTables, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

TEST(ColorTableFile, cellsOfSeveralClassesSurviveAndBecomeTheFirstOfThem) {
  ColorTableFile table;
  table.cells[7] = ColorTableFile::kSeveral | 0b1000001;  // orange and red
  table.cells[8] = ColorTableFile::kSeveral | 0b0010000;  // green alone
  table.cells[9] = ColorTableFile::kSeveral;              // none at all
  table.cells[10] = 8;
  const auto again = ColorTableFile::parse(table.bytes(), "some.c64");
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, table);
  const std::vector<std::uint8_t> single = table.singleClasses();
  EXPECT_EQ(single[7], 1);
  EXPECT_EQ(single[8], 5);
  EXPECT_EQ(single[9], 0);
  EXPECT_EQ(single[10], 8);
}

TEST(ColorTableFile, isSavedAndLoaded) {
  const TestFolder folder;
  const auto file = folder / "saved.c64";
  ColorTableFile table;
  std::fill(table.cells.begin() + 100, table.cells.begin() + 5000, std::uint8_t{3});
  ASSERT_TRUE(table.save(file));
  const auto loaded = ColorTableFile::load(file);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(*loaded, table);
}

TEST(ColorTableFile, runsThatDoNotMakeATableAreRefusedWithTheirPlace) {
  constexpr auto kAll = static_cast<std::uint32_t>(ColorTableFile::kCellCount);
  EXPECT_EQ(refusal(bytesOf({{kAll, 2}, {0, 0}})), "");
  EXPECT_NE(refusal("").find("at byte 0 it ends within its runs"), std::string::npos) << refusal("");
  EXPECT_NE(refusal(bytesOf({{kAll - 1, 2}, {0, 0}})).find("its runs end after 262143 of 262144 cells"),
            std::string::npos);
  EXPECT_NE(refusal(bytesOf({{1, 2}, {kAll, 2}, {0, 0}})).find("at byte 5 there are more cells"),
            std::string::npos);
  EXPECT_NE(refusal(bytesOf({{0xFFFFFFFFU, 2}, {0, 0}})).find("at byte 0 there are more cells"),
            std::string::npos);
  EXPECT_NE(refusal(bytesOf({{kAll, 2}, {0, 0}}) + "x").find("at byte 9 there is extra data"),
            std::string::npos);
  EXPECT_NE(refusal(bytesOf({{kAll, 2}})).find("at byte 5 it ends within its runs"), std::string::npos);
  EXPECT_EQ(refusal("").rfind("some.c64", 0), 0U) << "the file is named first";
}

TEST(ColorTableFile, cutAnywhereIsRefused) {
  ColorTableFile table;
  for (std::size_t i = 0; i < 40; ++i) table.cells[1000 * i] = static_cast<std::uint8_t>(i % 9);
  const std::string whole = table.bytes();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(ColorTableFile::parse(whole.substr(0, length), "cut.c64")) << length;
}

TEST(ColorTableFile, cellsOfSeveralClassesArePackedAsTheirMask) {
  std::vector<std::uint8_t> winners(ColorTableFile::kCellCount);
  std::vector<std::uint16_t> masks(ColorTableFile::kCellCount);
  winners[1] = 5, masks[1] = 1U << 4U;
  winners[2] = 3, masks[2] = 0b100'0101;   // classes 1, 3 and 7
  winners[3] = 8, masks[3] = 0b1000'0001;  // class 8 has no room in a mask
  winners[4] = 2, masks[4] = 0x8002;       // nor has class 16
  winners[5] = 100;                        // a class that masks do not show
  winners[6] = 200;                        // one that the format does not
  const auto packed = ColorTableFile::pack(winners, masks);
  EXPECT_EQ(packed.reducedCells, 2U);
  EXPECT_EQ(packed.emptiedCells, 1U);
  const auto& cells = packed.file.cells;
  EXPECT_EQ((std::vector<std::uint8_t>(cells.begin(), cells.begin() + 8)),
            (std::vector<std::uint8_t>{0, 5, 0xC5, 8, 2, 100, 0, 0}));
  const auto again = ColorTableFile::parse(packed.file.bytes(), "f");
  ASSERT_TRUE(again);
  const auto read = again->masks();
  EXPECT_EQ((std::vector<std::uint16_t>(read.begin(), read.begin() + 6)),
            (std::vector<std::uint16_t>{0, 1U << 4U, 0b100'0101, 1U << 7U, 0b10, 0}));
}
