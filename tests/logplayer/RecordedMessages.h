// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "foxglove/Image.pb.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/record/RecordedFrame.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/StreamMessage.h"
#include "tests/TestFolder.h"

namespace logplayer::tests {

using robotlink::Instant;
using robotlink::StreamMessage;

inline Instant at(int ms) {
  return Instant(std::chrono::milliseconds(ms));
}

inline StreamMessage plot(const std::string& path, int ms, double value,
                          const std::string& process = "cognition", std::uint64_t frame = 0) {
  auto plotted = std::make_shared<robotcontrol::PlotValue>();
  plotted->set_value(value);
  return {path, at(ms), plotted, process, frame};
}

inline StreamMessage table(const std::string& path, int ms, const std::string& key) {
  auto keys = std::make_shared<robotcontrol::KeyTable>();
  keys->add_keys()->set_name(key);
  return {path, at(ms), keys, "debug", 1};
}

/// A gray image with this number of bytes of pixels, in rows of 1000.
inline StreamMessage image(const std::string& path, int ms, int bytes,
                           const std::string& process = "platform", std::uint64_t frame = 0) {
  auto picture = std::make_shared<foxglove::RawImage>();
  picture->set_width(1000);
  picture->set_height(static_cast<std::uint32_t>(bytes / 1000));
  picture->set_step(1000);
  picture->set_encoding("mono8");
  picture->set_data(std::string(static_cast<std::size_t>(bytes), 'x'));
  return {path, at(ms), picture, process, frame};
}

inline StreamMessage frameInfo(int ms, std::uint64_t number, const std::string& process = "cognition") {
  auto info = std::make_shared<robotcontrol::FrameInfo>();
  info->set_process(process);
  info->set_number(number);
  return {"red1/frames/" + process, at(ms), info, process, number};
}

inline RecordedFramePtr frameOf(std::vector<StreamMessage> messages) {
  auto frame = std::make_shared<RecordedFrame>();
  for (StreamMessage& message : messages) {
    if (message.bytes == 0) message.bytes = robotlink::sizeOf(message);
    frame->bytes += message.bytes;
    frame->largest = std::max(frame->largest, message.bytes);
  }
  frame->messages = std::move(messages);
  return frame;
}

using ::TestFolder;

/// The contents of a log file, read by means of its container only.
struct ReadLog {
  struct Entry {
    std::string path, process, type;
    Instant time;
    std::uint32_t frame = 0;
    std::string data;
    bool operator==(const Entry&) const = default;
  };
  /// In the order of the file.
  std::vector<Entry> entries;
  /// The metadata at the end of the file.
  std::map<std::string, std::string> recording;
  bool complete = false;
  std::size_t damages = 0;
  std::string error;

  std::vector<std::string> paths() const {
    std::vector<std::string> result;
    for (const Entry& entry : entries) result.push_back(entry.path);
    return result;
  }
  std::size_t count(const std::string& path) const {
    return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(),
                                                  [&](const Entry& entry) { return entry.path == path; }));
  }
};

inline ReadLog readLog(const std::filesystem::path& file) {
  ReadLog log;
  auto reader = mcap::Reader::open(file, {});
  if (!reader) {
    log.error = reader.error().describe();
    return log;
  }
  (*reader)->readAll([&](const mcap::Message& message) {
    const mcap::Channel& channel = (*reader)->channels().at(message.channelId);
    const auto process = channel.metadata.find("process");
    log.entries.push_back({channel.topic, process == channel.metadata.end() ? "" : process->second,
                           (*reader)->schemas().at(channel.schemaId).name, message.logTime, message.sequence,
                           std::string(message.data.begin(), message.data.end())});
    return true;
  });
  for (const auto& metadata : (*reader)->metadata()) {
    if (metadata.name == "robotcontrol.recording") log.recording = metadata.values;
  }
  log.complete = (*reader)->complete();
  log.damages = (*reader)->damage().size();
  return log;
}

}  // namespace logplayer::tests
