// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/OtherTeams.h"

#include <fmt/format.h>

namespace colortool {
namespace {

constexpr std::array<NumberedTable::Class, 11> kRunswiftClasses = {{{0, "orange", {255, 128, 0}},
                                                                    {1, "beaconBlue", {40, 165, 235}},
                                                                    {2, "beaconGreen", {0, 200, 120}},
                                                                    {3, "beaconYellow", {250, 215, 0}},
                                                                    {4, "beaconPink", {250, 90, 160}},
                                                                    {5, "robotBlue", {15, 30, 130}},
                                                                    {6, "robotRed", {200, 15, 25}},
                                                                    {7, "fieldGreen", {0, 130, 50}},
                                                                    {8, "robotGrey", {140, 140, 140}},
                                                                    {9, "white", {235, 235, 235}},
                                                                    {10, "black", {45, 45, 50}}}};

constexpr std::array<NumberedTable::Class, 10> kNUbotsClasses = {{{1, "white", {235, 235, 235}},
                                                                  {2, "green", {0, 130, 50}},
                                                                  {3, "shadow_object", {70, 70, 90}},
                                                                  {4, "pink", {250, 90, 160}},
                                                                  {5, "pink_orange", {250, 100, 90}},
                                                                  {6, "orange", {255, 105, 0}},
                                                                  {7, "yellow_orange", {255, 165, 0}},
                                                                  {8, "yellow", {250, 215, 0}},
                                                                  {9, "blue", {40, 165, 235}},
                                                                  {10, "shadow_blue", {15, 30, 130}}}};

constexpr std::array<NumberedTable::Class, 7> kUPennClasses = {{{1, "orange", {255, 128, 0}},
                                                                {2, "yellow", {255, 255, 0}},
                                                                {4, "cyan", {0, 128, 255}},
                                                                {8, "field", {0, 128, 0}},
                                                                {16, "white", {204, 204, 204}},
                                                                {32, "robotBlue", {64, 153, 255}},
                                                                {64, "robotPink", {255, 90, 200}}}};

}  // namespace

// rUNSWift 2005 (robot/vision/CorrectedImage.h): their "u" is Cr, and 127 means no class.
constexpr NumberedTable kRunswiftTable{
    "color-table.runswift", "a table of rUNSWift 2005", {128, 128, 128}, true, 127, kRunswiftClasses};
// NUbots 2013 (LookUpTable.h).
constexpr NumberedTable kNUbotsTable{"color-table.nubots", "a table of the NUbots", {128, 128, 128}, false, 0,
                                     kNUbotsClasses};
// UPennalizers (Tools/Matlab/colortable).
constexpr NumberedTable kUPennTable{
    "color-table.upenn", "a table of the UPennalizers", {64, 64, 64}, false, 0, kUPennClasses};

ColorClasses NumberedTable::classes() const {
  std::vector<NamedColor> named;
  for (const Class& one : known) named.push_back({std::string(one.name), one.rgb});
  return ColorClasses(std::move(named));
}

robotlink::Result<CellGrid> parseNumberedTable(const NumberedTable& format, std::string_view bytes,
                                               const std::string& file) {
  const auto wrong = [&](std::string text) {
    return robotlink::failure(std::string(format.id), std::move(text), {file, 0, 0});
  };
  if (bytes.size() != format.bytes())
    return wrong(fmt::format("{} has {} bytes, this has {}", format.title, format.bytes(), bytes.size()));
  constexpr int kUnknown = -1;
  std::array<int, 256> numbers{};
  numbers.fill(kUnknown);
  numbers[format.none] = ColorClasses::kNone;
  for (std::size_t i = 0; i < format.known.size(); ++i)
    numbers[format.known[i].byte] = static_cast<int>(i) + 1;
  CellGrid grid{format.sides, format.crFirst, {}};
  grid.classes.reserve(bytes.size());
  for (const char byte : bytes) {
    const auto value = static_cast<std::uint8_t>(byte);
    if (numbers[value] == kUnknown) {
      return wrong(fmt::format("this is not {}: byte {} is {}, which is not one of its classes", format.title,
                               grid.classes.size(), int{value}));
    }
    grid.classes.push_back(static_cast<std::uint8_t>(numbers[value]));
  }
  return grid;
}

}  // namespace colortool
