// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how long it takes to decode the messages that ros_messages.mjs has written into a folder: NAME
// NANOSECONDS, the best of several rounds. compare_decoding.sh runs both.
//
// Usage: robotlink_ros_benchmark FOLDER
#include <google/protobuf/message.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "robotlink/ros/RosType.h"

namespace {

using robotlink::ros::RosType;

std::string contentsOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The best time of a message, in ns.
double measure(const std::shared_ptr<const RosType>& type, std::span<const std::uint8_t> bytes) {
  constexpr int kRounds = 20, kMessages = 2000;
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kMessages; ++i)
      if (!RosType::read(type, bytes)) return -1;
    const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - begin;
    best = std::min(best, passed.count() / kMessages);
  }
  return best;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
    std::filesystem::path file = entry.path();
    if (file.extension() != ".cdr") continue;
    const std::string bytes = contentsOf(file);
    const std::string definition = contentsOf(file.replace_extension(".msg"));
    const auto type = RosType::of(contentsOf(file.replace_extension(".type")), "ros2msg", definition, "cdr");
    if (!type) return 1;
    const double time = measure(*type, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    std::printf("%s %.0f\n", file.stem().c_str(), time);
  }
  return 0;
}
