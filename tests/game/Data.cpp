// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/game/Data.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "logplayer/images/ImageCoding.h"
#include "tests/TestFolder.h"
#include "tests/game/Log.h"
#include "tests/game/Tables.h"

namespace game {
namespace fs = std::filesystem;
namespace {

void writeBytes(const fs::path& file, const auto& bytes) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void writeViews(const fs::path& folder) {
  std::ofstream times(folder / "timestamps_ms.txt");
  for (int number = 0; number < View::kCount; ++number) {
    char stem[8];
    std::snprintf(stem, sizeof stem, "%03d", number);
    const View& view = View::at(number);
    writeBytes(folder / "yuyv" / (std::string(stem) + ".yuyv"), view.quads);
    times << Log::imageMs(number) << '\n';
    // Three of them, as somebody has the patience to draw; the last shows no ball.
    if (number % 5 == 0 || number + 1 == View::kCount) {
      if (number == 10) continue;
      writeBytes(folder / "labels" / (std::string(stem) + ".png"),
                 logplayer::encodePng(view.labels.view()).value());
    }
  }
}

void writeData(const fs::path& root) {
  const fs::path color = root / "colour", game = color / "bhuman2009";
  for (const char* name : {"yuyv", "labels", "tables"}) fs::create_directories(game / name);
  fs::create_directories(root / "logs");
  Log::write(root / "logs/bhuman2009.log");
  writeViews(game);
  for (const ForeignTable& table : foreignTables()) {
    writeBytes((table.format == "c64" ? game / "tables" : color) / table.name, table.bytes);
    if (!table.colors.empty()) writeBytes(color / "tekkotsu.col", table.colors);
  }
  writeBytes(game / "tables/simulator_scenes.c64", roughTable().bytes());
}

}  // namespace

fs::path dataOf(const std::string& source) {
  if (source == "real") return fs::path(ROBOTCONTROL_SOURCE_DIR) / "../shared/data";
  static const TestFolder folder;
  static const bool written = (writeData(folder.path()), true);
  if (!written || source != "made") throw std::runtime_error("there are no data called " + source);
  return folder.path();
}

std::vector<std::string> labeledStems(const fs::path& data) {
  std::vector<std::string> stems;
  for (const auto& entry : fs::directory_iterator(data / "colour/bhuman2009/labels")) {
    if (entry.path().extension() == ".png") stems.push_back(entry.path().stem());
  }
  std::ranges::sort(stems);
  return stems;
}

}  // namespace game
