// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of other teams: what those of real ones make of colors that real robots saw, and that people named;
// and what made ones of each format make of the colors of a game.
#include <gtest/gtest.h>

#include <fstream>

#include "colortool/image/ColorImage.h"
#include "colortool/table/ColorTable.h"
#include "colortool/table/TableImport.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/colortool/AiboPatches.h"
#include "tests/colortool/Disc.h"
#include "tests/game/Data.h"
#include "tests/game/Tables.h"
#include "tests/game/View.h"

namespace {

using colortool::ColorTable;
using colortool::ImportedTable;
using colortool::TableFormat;

const std::filesystem::path kData = ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour";

class ImportedTables : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kData))
      GTEST_SKIP() << "the real tables are not here: ../shared/data/colour";
  }
  static ImportedTable read(const std::string& name) {
    auto imported = colortool::importTable(kData / name);
    EXPECT_TRUE(imported) << robotlink::describe(imported.error());
    return imported.value_or(ImportedTable());
  }
  static std::string classOf(const ImportedTable& imported, robotlink::YCbCr color) {
    return imported.table.classes.name(imported.table.file.cells[ColorTable::cellOf(color)]);
  }
  /// The share of labeled pixels of an Aibo's color that a table calls `name`.
  static double share(const ImportedTable& imported, const std::vector<AiboPixel>& pixels,
                      const std::string& label, const std::string& name) {
    double all = 0, found = 0;
    for (const AiboPixel& pixel : pixels) {
      if (pixel.label != label) continue;
      ++all;
      if (classOf(imported, pixel.color) == name) ++found;
    }
    return all == 0 ? 0 : found / all;
  }
};

TEST_F(ImportedTables, ofTheNUbotsCallsABrightOrangeOrange) {
  const ImportedTable imported = read("nubots2013_default_RC2013.lut.bz2");
  EXPECT_EQ(imported.format, TableFormat::kNUbots);
  EXPECT_EQ(classOf(imported, robotlink::toYCbCr({255, 110, 0})), "orange");
  EXPECT_EQ(classOf(imported, robotlink::toYCbCr({230, 200, 20})), "yellow");
  EXPECT_EQ(classOf(imported, robotlink::toYCbCr({0, 150, 60})), "green");
  EXPECT_EQ(classOf(imported, robotlink::toYCbCr({0, 0, 255})), "none");
  EXPECT_LT(imported.mixedCells, 2500U);
}

TEST_F(ImportedTables, ofTheUPennalizersKnowsItsCarpetAndItsLines) {
  const ImportedTable imported = read("upenn_Germany2016_10am_Top_64bitmask.raw.bz2");
  EXPECT_EQ(imported.format, TableFormat::kUPenn);
  EXPECT_EQ(std::ranges::count(imported.table.file.cells, 4), 421);
  EXPECT_EQ(imported.reducedCells, 0U);
  EXPECT_EQ(classOf(imported, {97, 137, 86}), "field");
  EXPECT_EQ(classOf(imported, {174, 129, 110}), "white");
  EXPECT_EQ(classOf(imported, {20, 128, 128}), "none");
}

TEST_F(ImportedTables, ofRunswiftNamesTheColorsThatItsRobotsSaw) {
  const auto pixels = readAiboPatches();
  if (pixels.empty()) GTEST_SKIP() << "the labeled pixels are not here, or xz is not";
  const ImportedTable imported = read("runswift2005_tightnnmc_128.cal.bz2");
  EXPECT_EQ(imported.format, TableFormat::kRunswift);
  EXPECT_GT(share(imported, pixels, "yellow", "beaconYellow"), 0.99);
  EXPECT_GT(share(imported, pixels, "pink", "beaconPink"), 0.97);
  EXPECT_GT(share(imported, pixels, "lightblue", "beaconBlue"), 0.99);
  EXPECT_GT(share(imported, pixels, "red", "robotRed"), 0.99);
  EXPECT_GT(share(imported, pixels, "white", "white"), 0.93);
  EXPECT_GT(share(imported, pixels, "blue", "none"), 0.9) << "a tight table";
}

TEST_F(ImportedTables, ofTekkotsuNamesTheColorsThatOtherAibosSaw) {
  const auto pixels = readAiboPatches();
  if (pixels.empty()) GTEST_SKIP() << "the labeled pixels are not here, or xz is not";
  const ImportedTable imported = read("ers7/tekkotsu_7general.tm");
  EXPECT_EQ(imported.format, TableFormat::kTekkotsu);
  EXPECT_GT(share(imported, pixels, "yellow", "yellow"), 0.99);
  EXPECT_GT(share(imported, pixels, "pink", "pink"), 0.97);
  EXPECT_GT(share(imported, pixels, "lightblue", "blue"), 0.99);
  EXPECT_GT(share(imported, pixels, "green", "green"), 0.98);
  EXPECT_GT(share(imported, pixels, "white", "unsaturated"), 0.99);
}

TEST_F(ImportedTables, ofTekkotsuSortsTheImagesOfARealAibo) {
  const ImportedTable imported = read("ers7/tekkotsu_7general.tm");
  struct Thing {
    const char *image, *name;
    int x, y, radius;
  };
  for (const Thing& thing :
       {Thing{"sample-image", "blue", 154, 190, 7}, Thing{"sample-image", "pink", 218, 183, 6},
        Thing{"test2", "pink", 130, 70, 10}, Thing{"test3", "orange", 140, 85, 8},
        Thing{"test4", "blue", 125, 55, 10}, Thing{"test5", "yellow", 79, 100, 10},
        Thing{"test5", "orange", 136, 60, 5}, Thing{"test5", "green", 40, 140, 8}}) {
    const auto bytes = robotlink::readFile(kData / "ers7" / (std::string(thing.image) + "_yuv.png"));
    ASSERT_TRUE(bytes);
    const auto image =
        logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
    ASSERT_TRUE(image);
    int all = 0, found = 0;
    colortool::test::visitDisc(image->width, image->height, thing.x, thing.y, thing.radius,
                               [&](int x, int y) {
                                 // The three channels of the file are Y, Cb and Cr.
                                 const std::uint8_t* pixel = image->row(y) + std::ptrdiff_t{3} * x;
                                 ++all;
                                 if (classOf(imported, {pixel[0], pixel[1], pixel[2]}) == thing.name) ++found;
                               });
    EXPECT_GE(found, 0.9 * all) << thing.image << " at " << thing.x << ", " << thing.y << ": " << thing.name;
  }
}

TEST_F(ImportedTables, ofBHumanIsTheSameFile) {
  for (const char* name : {"default.c64", "simulator_scenes.c64"}) {
    const auto file = kData / "bhuman2009/tables" / name;
    const ImportedTable imported = read(std::string("bhuman2009/tables/") + name);
    EXPECT_EQ(imported.format, TableFormat::kC64);
    EXPECT_EQ(imported.table.file.bytes(), robotlink::readFile(file).value());
  }
}

/// The parameter is the number of a table.
class ForeignTables : public testing::TestWithParam<std::size_t> {
 protected:
  static const game::ForeignTable& written() {
    static const auto tables = game::foreignTables();
    return tables.at(GetParam());
  }
  /// The table, from its file.
  ImportedTable read() const {
    std::ofstream(folder_ / written().name, std::ios::binary) << written().bytes;
    if (!written().colors.empty()) std::ofstream(folder_ / "tekkotsu.col") << written().colors;
    auto imported = colortool::importTable(folder_ / written().name);
    EXPECT_TRUE(imported) << robotlink::describe(imported.error());
    return imported.value_or(ImportedTable());
  }
  TestFolder folder_;
};

TEST_P(ForeignTables, nameTheColorsOfTheImagesThatTheyAreFor) {
  const ImportedTable imported = read();
  EXPECT_EQ(colortool::tableFormats()[static_cast<std::size_t>(imported.format)].name, written().format);
  EXPECT_EQ(imported.reducedCells, 0U);
  std::map<std::uint8_t, std::pair<int, int>> found;  // of each label: right ones, and all
  for (const int number : {0, 5, 11}) {
    const game::View& view = game::View::at(number);
    for (std::size_t i = 0; i < view.labels.data.size(); ++i) {
      const std::uint8_t label = view.labels.data[i];
      if (label == game::View::kEdge) continue;
      const auto* quad = &view.quads[4 * i];
      const auto cell = ColorTable::cellOf({quad[2], quad[1], quad[3]});
      const std::string name = imported.table.classes.name(imported.table.file.cells[cell]);
      auto& [right, all] = found[label];
      right += name == (label == 0 ? "none" : written().classNames.at(label)) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_EQ(found.size(), 5U) << "four classes, and what is none";
  for (const auto& [label, counts] : found) EXPECT_EQ(counts.first, counts.second) << int{label};
}

TEST_P(ForeignTables, areReadAgainFromTheFileThatTheyBecome) {
  const ImportedTable imported = read();
  ASSERT_TRUE(imported.table.save(folder_ / "own.c64"));
  const auto again = colortool::importTable(folder_ / "own.c64");
  ASSERT_TRUE(again) << robotlink::describe(again.error());
  EXPECT_EQ(again->table.file, imported.table.file);
  EXPECT_EQ(again->table.classes, imported.table.classes);
  if (written().format == "c64") {
    EXPECT_EQ(imported.table.file.bytes(), written().bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ForeignTables, testing::Range(std::size_t{0}, std::size_t{5}),
                         [](const auto& number) { return game::foreignTables().at(number.param).format; });

}  // namespace
