// SPDX-License-Identifier: GPL-3.0-or-later
// Motions as robots' motion compilers read them.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "robotlink/motions/MotionReader.h"
#include "tests/fuzz/FuzzTarget.h"

namespace motion_file_fuzz {

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto motion = robotlink::readMotion(text, "fuzz.mof");
  if (motion || !motion.error().empty()) return 0;
  std::fputs("a refusal has no errors\n", stderr);
  std::abort();
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ROBOTCONTROL_SOURCE_DIR "/resources/motions")) {
    if (entry.path().extension() == ".mof") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds{
      "motion_id = wave\njoints = a b\nlabel start\n10 20 1 100\ntransition next start start\n"};
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

const FuzzRegistration kTarget({"motion_file", &fuzzSeeds, &runInput});

}  // namespace motion_file_fuzz
