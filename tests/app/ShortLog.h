// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Image.h"
#include "robotlink/packages/Conversions.h"

namespace app::test {

/// A log with fifty frames of red1/planner, a process that no layout contains: numbers 101 to 150, 40 ms
/// apart, with a gap of three seconds in the middle. Every second frame, beginning with the second, has an
/// image; two have a note.
struct ShortLog {
  static constexpr int kFrames = 50;
  static constexpr std::uint64_t kFirstNumber = 101;

  static robotlink::Instant time(int frame) {
    return robotlink::Instant(
        std::chrono::milliseconds(10'000 + 40 * frame + (frame >= kFrames / 2 ? 3000 : 0)));
  }
  static bool hasImage(int frame) { return frame % 2 == 1; }
  static bool hasNote(int frame) { return frame == 10 || frame == 40; }

  static robotlink::StreamMessage image(int frame) {
    robotlink::Image image(176, 144, robotlink::PixelFormat::kYuyv);
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image.view(), time(frame), "red1/camera");
    return {"red1/camera/image", time(frame), std::move(message), "platform"};
  }
  static robotlink::StreamMessage note(int frame) {
    auto message = std::make_shared<foxglove::Log>();
    message->set_message("frame " + std::to_string(frame));
    robotlink::assign(*message->mutable_timestamp(), time(frame));
    return {"red1/planner/notes", time(frame), std::move(message), "planner"};
  }
  static robotlink::StreamMessage info(int frame, const char* process, std::uint64_t number) {
    auto message = std::make_shared<robotcontrol::FrameInfo>();
    message->set_process(process);
    message->set_number(number);
    return {std::string("red1/frames/") + process, time(frame), std::move(message), process, number};
  }

  /// Writes the log; returns an error message, or an empty text.
  static std::string write(const std::filesystem::path& file) {
    std::filesystem::remove(file);
    auto writer = logplayer::LogWriter::create(file, {});
    if (!writer) return writer.error().describe();
    std::string wrong;
    const auto expect = [&wrong](const robotlink::Result<void>& done) {
      if (!done) wrong += done.error().describe() + "\n";
    };
    for (int frame = 0; frame < kFrames; ++frame) {
      const auto number = kFirstNumber + static_cast<std::uint64_t>(frame);
      if (hasImage(frame)) expect((*writer)->write({image(frame), info(frame, "platform", number)}));
      std::vector<robotlink::StreamMessage> reported{info(frame, "planner", number)};
      if (hasNote(frame)) reported.insert(reported.begin(), note(frame));
      for (auto& message : reported) message.frame = number;
      expect((*writer)->write(reported));
    }
    expect((*writer)->container().close());
    return wrong;
  }
};

}  // namespace app::test
