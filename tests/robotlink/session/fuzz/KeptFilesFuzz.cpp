// SPDX-License-Identifier: GPL-3.0-or-later
// What the workbench keeps for a person: settings and presets of debug keys. Somebody may have edited them,
// or a disk damaged them.
#include <cmath>
#include <fstream>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/KeyPresets.h"
#include "robotlink/session/Settings.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace kept_files_fuzz {

using namespace robotlink;

namespace {

/// Anew: disks take their time with files that are written over.
void write(const std::filesystem::path& path, const std::uint8_t* data, std::size_t size) {
  std::filesystem::remove(path);
  std::filesystem::remove(path.string() + ".broken");
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

void checkSettings(const std::filesystem::path& path) {
  Settings settings(path);
  const auto loaded = settings.load();
  require(loaded || !loaded.error().text.empty(), "a refusal says why");
  for (const auto& [name, value] : settings.all()) {
    if (const auto* number = std::get_if<double>(&value))
      require(std::isfinite(*number), "numbers are finite");
  }
}

void checkPresets(const std::filesystem::path& folder) {
  const KeyPresets presets(folder);
  require(presets.names() == std::vector<std::string>{"fuzz"}, "there is the preset that was written");
  const auto keys = presets.load("fuzz");
  require(keys || !keys.error().text.empty(), "a refusal says why");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  static const TestFolder folder;
  write(folder / "fuzz.keys.json", data, size);
  checkPresets(folder.path());
  write(folder / "settings.json", data, size);
  checkSettings(folder / "settings.json");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      R"({"format": "robotcontrol-settings", "version": 1, "settings": {"speed": 2.5, "name": "a", "grid": true,
             "list": ["x", "y"]}})",
      R"({"format": "robotcontrol-debug-keys", "version": 1, "keys": {"ball-percept/circle": {"mode": "always"},
             "timing/tasks": {"mode": "every-n", "n": 12}, "x": {"mode": "every-ms", "n": 100}}})"};
}

const FuzzRegistration kTarget({"kept_files", &fuzzSeeds, &runInput});

}  // namespace kept_files_fuzz
