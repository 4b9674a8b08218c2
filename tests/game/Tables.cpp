// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/game/Tables.h"

#include <algorithm>
#include <cmath>

#include "tests/game/View.h"

namespace game {
namespace {

constexpr std::uint8_t kLabels[] = {View::kOrange, View::kBlue, View::kWhite, View::kGreen};

/// The label of a color; 0 if it is none of the game's.
std::uint8_t labelOf(double y, double cb, double cr, double reach) {
  for (const std::uint8_t label : kLabels) {
    const robotlink::YCbCr color = colorOf(label);
    if (std::abs(y - color.y) < 2 * reach && std::abs(cb - color.cb) < reach &&
        std::abs(cr - color.cr) < reach)
      return label;
  }
  return 0;
}

/// Calls add(label) for each cell of a table, in the order of a file.
template <typename Add>
void visit(int ySide, int side, bool crFirst, Add add) {
  for (int y = 0; y < ySide; ++y) {
    for (int first = 0; first < side; ++first) {
      for (int second = 0; second < side; ++second) {
        const double a = (first + 0.5) * 256 / side, b = (second + 0.5) * 256 / side;
        add(labelOf((y + 0.5) * 256 / ySide, crFirst ? b : a, crFirst ? a : b, 12));
      }
    }
  }
}

/// A file of one byte a cell.
ForeignTable numbered(ForeignTable about, int ySide, int side, bool crFirst,
                      const std::map<std::uint8_t, int>& bytes) {
  visit(ySide, side, crFirst,
        [&](std::uint8_t label) { about.bytes.push_back(static_cast<char>(bytes.at(label))); });
  return about;
}

void addRun(std::string& bytes, std::uint32_t length, std::uint8_t cell) {
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xFFU));
  if (length != 0) bytes.push_back(static_cast<char>(cell));
}

ForeignTable ofBHuman() {
  ForeignTable written{
      "c64", "default.c64", "", {{1, "orange"}, {3, "blue"}, {4, "white"}, {5, "green"}}, ""};
  std::uint32_t length = 0;
  std::uint8_t last = 0;
  visit(64, 64, false, [&](std::uint8_t label) {
    if (label != last && length > 0) {
      addRun(written.bytes, length, last);
      length = 0;
    }
    last = label;
    ++length;
  });
  addRun(written.bytes, length, last);
  addRun(written.bytes, 0, 0);
  return written;
}

}  // namespace

colortool::ColorTableFile table() {
  colortool::ColorTableFile file;
  std::size_t cell = 0;
  visit(64, 64, false, [&](std::uint8_t label) { file.cells[cell++] = label; });
  return file;
}

colortool::ColorTableFile roughTable() {
  colortool::ColorTableFile file = table();
  std::size_t cell = 0;
  for (int y = 0; y < 64; ++y) {
    for (int cb = 0; cb < 64; ++cb) {
      for (int cr = 0; cr < 64; ++cr, ++cell) {
        const std::uint8_t wide = labelOf(4 * y + 2, 4 * cb + 2, 4 * cr + 2, 18);
        // On the way from one cell to the other they were of the class of black, too.
        constexpr unsigned kBlack = 6;
        if (file.cells[cell] == 0 && wide != 0)
          file.cells[cell] = static_cast<std::uint8_t>(colortool::ColorTableFile::kSeveral |
                                                       (1U << (wide - 1U)) | (1U << (kBlack - 1U)));
      }
    }
  }
  return file;
}

std::vector<ForeignTable> foreignTables() {
  std::vector<ForeignTable> tables;
  tables.push_back(ofBHuman());
  tables.push_back(
      numbered({"nubots", "nubots.lut", "", {{1, "orange"}, {3, "blue"}, {4, "white"}, {5, "green"}}, ""},
               128, 128, false, {{0, 0}, {1, 6}, {3, 9}, {4, 1}, {5, 2}}));
  tables.push_back(numbered({"runswift",
                             "runswift.cal",
                             "",
                             {{1, "orange"}, {3, "beaconBlue"}, {4, "white"}, {5, "fieldGreen"}},
                             ""},
                            128, 128, true, {{0, 127}, {1, 0}, {3, 1}, {4, 9}, {5, 7}}));
  tables.push_back(
      numbered({"upenn", "upenn.raw", "", {{1, "orange"}, {3, "cyan"}, {4, "white"}, {5, "field"}}, ""}, 64,
               64, false, {{0, 0}, {1, 1}, {3, 4}, {4, 16}, {5, 8}}));
  tables.push_back(numbered({"tekkotsu",
                             "tekkotsu.tm",
                             "TMAP\nYUV'8\n32 64 64\n",
                             {{1, "orange"}, {3, "goal"}, {4, "lines"}, {5, "carpet"}},
                             "1 (255 128 0) \"orange\"\n2 (0 80 255) \"goal\"\n3 (255 255 255) \"lines\"\n"
                             "4 (0 160 40) \"carpet\"\n"},
                            32, 64, false, {{0, 0}, {1, 1}, {3, 2}, {4, 3}, {5, 4}}));
  return tables;
}

}  // namespace game
