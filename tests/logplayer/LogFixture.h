// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "foxglove/Scene.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Debugging.pb.h"
#include "tests/TestFolder.h"

namespace logplayer::tests {

using robotlink::Instant;
using robotlink::StreamMessage;

inline Instant at(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

inline StreamMessage plot(const std::string& path, double time, double value, const std::string& process = {},
                          std::uint64_t frame = 0) {
  auto message = std::make_shared<robotcontrol::PlotValue>();
  message->set_value(value);
  return {path, at(time), message, process, frame};
}

inline StreamMessage frameInfo(const std::string& robot, const std::string& process, double time,
                               std::uint64_t number) {
  auto info = std::make_shared<robotcontrol::FrameInfo>();
  info->set_process(process);
  info->set_number(number);
  return {robot + "/frames/" + process, at(time), info, process, number};
}

/// A log file that is written and then damaged.
class LogFixture {
 public:
  LogFixture() : folder_(TestFolder::Where::kDisk) {}
  std::filesystem::path path(const std::string& name = "log.mcap") const { return folder_ / name; }
  std::unique_ptr<LogWriter> write(const std::string& name = "log.mcap",
                                   mcap::Writer::Options options = {}) const {
    return std::move(*LogWriter::create(path(name), std::move(options)));
  }
  void truncate(std::uintmax_t bytes) const { std::filesystem::resize_file(path(), bytes); }
  void flipByte(std::streamoff offset) const {
    std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(offset);
    const char byte = static_cast<char>(file.get());
    file.seekp(offset);
    file.put(static_cast<char>(~byte));
  }

 private:
  TestFolder folder_;
};

}  // namespace logplayer::tests
