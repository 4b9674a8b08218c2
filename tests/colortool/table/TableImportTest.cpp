// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of other teams, made up here; ImportedTablesTest reads the real ones.
#include "colortool/table/TableImport.h"

#include <bzlib.h>
#include <gmock/gmock.h>

#include <fstream>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/Bzip2.h"
#include "colortool/table/ColorTable.h"
#include "colortool/table/TekkotsuTable.h"
#include "tests/TestFolder.h"

namespace {

using colortool::ColorTable;
using colortool::ImportedTable;
using colortool::TableFormat;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t k64 = std::size_t{64} * 64 * 64, k128 = 8 * k64;

std::size_t at128(int y, int first, int second) {
  return (static_cast<std::size_t>(y) * 128 + static_cast<std::size_t>(first)) * 128 +
         static_cast<std::size_t>(second);
}
std::size_t at64(int y, int cb, int cr) {
  return (static_cast<std::size_t>(y) * 64 + static_cast<std::size_t>(cb)) * 64 +
         static_cast<std::size_t>(cr);
}
std::string bytes128(char fill) {
  return std::string(k128, fill);
}
std::string compressed(std::string bytes) {
  std::string out(bytes.size() + bytes.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  EXPECT_EQ(
      BZ2_bzBuffToBuffCompress(out.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()), 9, 0, 0),
      BZ_OK);
  out.resize(size);
  return out;
}
ImportedTable parsed(const std::string& bytes, std::optional<TableFormat> format = {}) {
  const auto imported = colortool::parseTable(bytes, "f", format);
  EXPECT_TRUE(imported) << robotlink::describe(imported.error());
  return imported.value_or(ImportedTable());
}
std::string importRefusal(const std::string& bytes, std::optional<TableFormat> format = {}) {
  const auto imported = colortool::parseTable(bytes, "f", format);
  return imported ? "" : robotlink::describe(imported.error());
}
int cellOf(const ImportedTable& imported, int y, int cb, int cr) {
  return imported.table.file.cells[at64(y, cb, cr)];
}

TEST(TableImport, cellsOfTwiceAsManyASideTakeTheClassOfMost) {
  std::string bytes = bytes128(0);
  for (int i = 0; i < 8; ++i)
    bytes[at128(20 + i / 4, 40 + i / 2 % 2, 60 + i % 2)] = 6;                         // all of (10, 20, 30)
  for (int i = 0; i < 5; ++i) bytes[at128(2 + i / 4, 4 + i / 2 % 2, 6 + i % 2)] = 8;  // five of (1, 2, 3)
  for (int i = 0; i < 4; ++i) bytes[at128(100, 100 + i / 2, 100 + i % 2)] = 2;        // half of (50, 50, 50)
  bytes[at128(0, 0, 0)] = 9;                                                          // one of (0, 0, 0)
  const ImportedTable imported = parsed(bytes);
  EXPECT_EQ(imported.format, TableFormat::kNUbots);
  EXPECT_EQ(imported.sides, (std::array{128, 128, 128}));
  EXPECT_EQ(cellOf(imported, 10, 20, 30), 6);
  EXPECT_EQ(cellOf(imported, 1, 2, 3), 8);
  EXPECT_EQ(cellOf(imported, 50, 50, 50), 2);
  EXPECT_EQ(cellOf(imported, 0, 0, 0), 0);
  EXPECT_EQ(imported.mixedCells, 3U);
  EXPECT_EQ(std::ranges::count(imported.table.file.cells, 0), static_cast<std::ptrdiff_t>(k64) - 3);
  EXPECT_EQ(imported.table.classes.name(8), "yellow");
}

TEST(TableImport, rUnswiftHasCrBeforeCbAndANoneOfItsOwn) {
  std::string bytes = bytes128(127);
  for (int i = 0; i < 8; ++i) bytes[at128(20 + i / 4, 60 + i / 2 % 2, 40 + i % 2)] = 0;
  const ImportedTable imported = parsed(bytes);
  EXPECT_EQ(imported.format, TableFormat::kRunswift);
  EXPECT_EQ(imported.table.classes.name(cellOf(imported, 10, 20, 30)), "orange");
  EXPECT_EQ(std::ranges::count(imported.table.file.cells, 0), static_cast<std::ptrdiff_t>(k64) - 1);
  EXPECT_EQ(imported.mixedCells, 0U);
}

TEST(TableImport, masksOfSeveralClassesAreKept) {
  std::string bytes(k64, '\0');
  bytes[at64(10, 20, 30)] = 8;
  bytes[at64(1, 2, 3)] = 16 + 2;
  bytes[at64(63, 63, 63)] = static_cast<char>(0x80 + 4);
  bytes[at64(0, 0, 1)] = static_cast<char>(0x80);
  const ImportedTable imported = parsed(bytes);
  EXPECT_EQ(imported.format, TableFormat::kUPenn);
  EXPECT_EQ(imported.table.classes.name(cellOf(imported, 10, 20, 30)), "field");
  EXPECT_EQ(cellOf(imported, 1, 2, 3), 0x80 + 0b1'0010);
  EXPECT_EQ(cellOf(imported, 63, 63, 63), 3) << "class 8 has no room beside another one";
  EXPECT_EQ(imported.reducedCells, 1U);
  EXPECT_EQ(imported.table.classes.name(cellOf(imported, 0, 0, 1)), "class 8");
}

TEST(TableImport, coarseCellsOfTekkotsuAreSpread) {
  std::string bytes = "TMAP\nYUV'8\n16 64 64\n" + std::string(std::size_t{16} * 64 * 64, '\0');
  bytes[20 + (std::size_t{5} * 64 + 20) * 64 + 30] = 2;
  const auto colors = colortool::parseTekkotsuColors(
      "0 (1 2 3) \"unclassified\" 8 1.00\n\n# ours\n2 (255 128 0) \"orange ball\" 8 0.75\r\n", "c");
  ASSERT_TRUE(colors);
  EXPECT_THAT(colors->names(), ElementsAre("class 1", "orange ball"));
  EXPECT_EQ(colors->shownColor(2), (robotlink::Rgb{255, 128, 0}));
  const auto imported = colortool::parseTable(bytes, "f", {}, *colors);
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->format, TableFormat::kTekkotsu);
  EXPECT_EQ(imported->sides, (std::array{16, 64, 64}));
  for (int y = 0; y < 64; ++y) EXPECT_EQ(cellOf(*imported, y, 20, 30), y / 4 == 5 ? 2 : 0) << y;
  EXPECT_EQ(imported->mixedCells, 0U);
  EXPECT_EQ(parsed(bytes).table.classes.names(), (std::vector<std::string>{"class 1", "class 2"}));
}

TEST(TableImport, colorsAreFoundBesideTheirMap) {
  const TestFolder folder;
  std::string bytes = "TMAP\nYUV8\n1 2 4\n" + std::string(8, '\1');
  std::ofstream(folder / "map.tm") << bytes;
  const auto firstName = [&](const colortool::TableImportOptions& options = {}) {
    const auto imported = colortool::importTable(folder / "map.tm", options);
    return imported ? imported->table.classes.name(1) : robotlink::describe(imported.error());
  };
  EXPECT_EQ(firstName(), "class 1");
  std::ofstream(folder / "default.col") << "1 (0 0 0) \"the only one\"\n";
  EXPECT_EQ(firstName(), "the only one");
  std::ofstream(folder / "other.col") << "1 (0 0 0) \"another\"\n";
  EXPECT_EQ(firstName(), "class 1") << "which of them is not known";
  EXPECT_EQ(firstName({{}, folder / "other.col"}), "another");
  std::ofstream(folder / "map.col") << "1 (0 0 0) \"of the same name\"\n";
  EXPECT_EQ(firstName(), "of the same name");
  std::filesystem::rename(folder / "map.col", folder / "map.COL");
  EXPECT_EQ(firstName(), "of the same name") << "capitals or not";
  std::filesystem::rename(folder / "map.COL", folder / "map.col");
  std::ofstream(folder / "map.col") << "1 (0 0 0)\n";
  EXPECT_THAT(firstName(), HasSubstr("map.col:1: the class's name is expected after its color"));
  EXPECT_THAT(firstName({{}, folder / "no.col"}), HasSubstr("no.col"));
}

TEST(TableImport, ourOwnTablesKeepTheirNames) {
  const TestFolder folder;
  colortool::NamedColorTable table;
  table.classes = colortool::findClassPreset("2002")->classes();
  table.file.cells[5] = 3;
  ASSERT_TRUE(table.save(folder / "t.c64"));
  const auto imported = colortool::importTable(folder / "t.c64");
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->format, TableFormat::kC64);
  EXPECT_EQ(imported->table.classes, table.classes);
  EXPECT_EQ(imported->table.file, table.file);
  std::ofstream(folder / "t.c64.classes") << "something else\n";
  EXPECT_THAT(robotlink::describe(colortool::importTable(folder / "t.c64").error()),
              HasSubstr("t.c64.classes:1:"));
}

TEST(TableImport, compressedTablesAreRead) {
  std::string bytes(k64, '\0');
  bytes[at64(10, 20, 30)] = 8;
  EXPECT_EQ(parsed(compressed(bytes)).table.file, parsed(bytes).table.file);
}

TEST(TableImport, whatIsNoCompressedTableIsRefused) {
  const std::string good = compressed(std::string(k64, '\0'));
  EXPECT_THAT(importRefusal(good.substr(0, good.size() - 1)),
              HasSubstr("this bzip2 file is damaged: at byte"));
  EXPECT_THAT(importRefusal(good.substr(0, good.size() - 1)), HasSubstr("it ends too early"));
  EXPECT_THAT(importRefusal(good + "x"), HasSubstr("there is extra data after its end"));
  std::string damaged = good;
  damaged[10] ^= 1;
  EXPECT_THAT(importRefusal(damaged), HasSubstr("its contents do not fit together"));
  EXPECT_THAT(importRefusal(compressed(std::string((4U << 20U) + 1, 'a'))),
              HasSubstr("becomes larger than 4194304 bytes"));
  EXPECT_THAT(importRefusal(compressed(std::string(4U << 20U, 'a'))),
              HasSubstr("not a color table of a known format"));
  EXPECT_FALSE(colortool::decompressBzip2("", 10, "f"));
}

TEST(TableImport, tablesThatLieAreRefusedWithTheirPlace) {
  EXPECT_THAT(importRefusal(""), StartsWith("f: this is not a color table of a known format (c64, "));
  EXPECT_THAT(importRefusal(std::string(k64 - 1, '\0')), HasSubstr("none has these 262143 bytes"));
  EXPECT_THAT(importRefusal("", TableFormat::kUPenn), HasSubstr("UPennalizers has 262144 bytes, this has 0"));
  EXPECT_THAT(importRefusal("", TableFormat::kNUbots), HasSubstr("NUbots has 2097152 bytes, this has 0"));
  EXPECT_THAT(importRefusal("", TableFormat::kTekkotsu), HasSubstr("at byte 0 the line TMAP is expected"));
  EXPECT_THAT(importRefusal("", TableFormat::kC64), HasSubstr("this is not a .c64 color table"));
  std::string bytes = bytes128(0);
  bytes[77777] = 11;
  EXPECT_THAT(importRefusal(bytes),
              HasSubstr("not a table of the NUbots: byte 77777 is 11, which is not one of its classes"));
  bytes[0] = 127;
  EXPECT_THAT(importRefusal(bytes), HasSubstr("not a table of rUNSWift 2005: byte 77777 is 11"));
}

TEST(TableImport, mapsThatLieAreRefusedWithTheirPlace) {
  EXPECT_THAT(importRefusal("TMAP\n"), HasSubstr("at byte 5 the line that says YUV is expected"));
  EXPECT_THAT(importRefusal("TMAP\nHSV8\n1 1 1\nx"),
              HasSubstr("at byte 5 the line that says YUV is expected"));
  for (const char* sizes : {"16 64", "0 64 64", "-1 1 1", "16 63 64", "256 1 1", "4294967297 1 1", "a b c"})
    EXPECT_THAT(importRefusal(std::string("TMAP\nYUV8\n") + sizes + "\n"),
                HasSubstr("at byte 10 three numbers of cells"))
        << sizes;
  EXPECT_THAT(importRefusal("TMAP\nYUV8\n1 1 1"), HasSubstr("at byte 10 three numbers of cells"));
  EXPECT_THAT(importRefusal("TMAP\nYUV8\n1 1 1 1\n"), HasSubstr("at byte 10 something follows"));
  EXPECT_THAT(importRefusal("TMAP\nYUV8\n1 2 1\nx"),
              HasSubstr("at byte 16 2 cells are expected, 1 x 2 x 1, but 1 bytes follow"));
  EXPECT_THAT(importRefusal("TMAP\nYUV8\n1 2 1\n\1\xF0"),
              HasSubstr("byte 17 has class 240, but a .c64 only has classes up to 127"));
}

TEST(TableImport, brokenColorsAreToldWithTheirLines) {
  const auto colors = colortool::parseTekkotsuColors(
      "orange\n1 255 128 0 \"a\"\n1 (0 0 256) \"a\"\n1 (0 0 0) a\n300 (0 0 0) \"a\"\n1 (0 0 0) \"a\"\n"
      "2 (0 0 0) \"a\"\n1 (0 0 0) \"b\"\n3 (0 0 0) \"none\"\n3 (0 0 0) \"\"\n",
      "c");
  ASSERT_FALSE(colors);
  EXPECT_EQ(
      robotlink::describe(colors.error()),
      "c:1: a line begins with the number of its class, 0 to 255\nc:2: the class's color is expected after "
      "its number, as in (255 128 0)\nc:3: the class's color is expected after its number, as in (255 128 "
      "0)\nc:4: the class's name is expected after its color, in quotes\nc:5: a line begins with the number "
      "of its class, 0 to 255\nc:7: 'a' appears here for the second time\nc:8: class 1 appears here a second "
      "time\nc:9: 'none' stands for pixels of no class and cannot be one\nc:10: a class needs a name");
  EXPECT_FALSE(colortool::parseTekkotsuColors("", "c"));
}

}  // namespace
