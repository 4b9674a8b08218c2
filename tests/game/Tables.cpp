// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/game/Tables.h"

#include <bit>
#include <cmath>

#include "tests/game/View.h"

namespace game {
namespace {

/// How far a color's class reaches in the chroma channels; twice as far in Y.
constexpr double kReach = 12;
constexpr std::uint8_t kLabels[] = {View::kOrange, View::kBlue, View::kWhite, View::kGreen};

/// For each cell of an axis the labels whose color is near in this channel: bit i for kLabels[i].
std::vector<unsigned> near(int side, std::uint8_t robotlink::YCbCr::*channel, double reach) {
  std::vector<unsigned> labels;
  for (int cell = 0; cell < side; ++cell) {
    const double value = (cell + 0.5) * 256 / side;
    unsigned bits = 0;
    for (std::size_t i = 0; i < std::size(kLabels); ++i)
      bits |= std::abs(value - colorOf(kLabels[i]).*channel) < reach ? 1U << i : 0U;
    labels.push_back(bits);
  }
  return labels;
}

/// Calls add(label) for each cell of a table, in the order of a file; 0: it is of none of the game's colors.
template <typename Add>
void visit(int ySide, int side, bool crFirst, double reach, Add add) {
  using robotlink::YCbCr;
  const auto ys = near(ySide, &YCbCr::y, 2 * reach);
  const auto firsts = near(side, crFirst ? &YCbCr::cr : &YCbCr::cb, reach);
  const auto seconds = near(side, crFirst ? &YCbCr::cb : &YCbCr::cr, reach);
  for (const unsigned y : ys) {
    for (const unsigned first : firsts) {
      for (const unsigned second : seconds) {
        const unsigned labels = y & first & second;
        add(labels == 0 ? std::uint8_t{0} : kLabels[std::countr_zero(labels)]);
      }
    }
  }
}

/// A file of one byte a cell.
ForeignTable numbered(ForeignTable about, int ySide, int side, bool crFirst,
                      const std::map<std::uint8_t, int>& bytes) {
  visit(ySide, side, crFirst, kReach,
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
  visit(64, 64, false, kReach, [&](std::uint8_t label) {
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
  visit(64, 64, false, kReach, [&](std::uint8_t label) { file.cells[cell++] = label; });
  return file;
}

colortool::ColorTableFile roughTable() {
  colortool::ColorTableFile file = table();
  std::size_t cell = 0;
  visit(64, 64, false, 1.5 * kReach, [&](std::uint8_t label) {
    // At the rim of their colors cells are of the class of black, too.
    constexpr unsigned kBlack = 6;
    if (file.cells[cell] == 0 && label != 0)
      file.cells[cell] = static_cast<std::uint8_t>(colortool::ColorTableFile::kSeveral |
                                                   (1U << (label - 1U)) | (1U << (kBlack - 1U)));
    ++cell;
  });
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
