// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RecordingFile.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"

namespace logplayer {

using robotcontrol::ControlRecording;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

/// Half of what may be lost in a crash; the other half is for the queue and the disk.
constexpr robotlink::Duration kChunkAge = std::chrono::milliseconds(500);

std::string realTime(const char* format, bool utc) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  if (utc) {
    gmtime_r(&now, &parts);
  } else {
    localtime_r(&now, &parts);
  }
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &parts)};
}

mcap::Compression compressionOf(ControlRecording::Compression compression) {
  switch (compression) {
    case ControlRecording::LZ4:
      return mcap::Compression::kLz4;
    case ControlRecording::ZSTD:
      return mcap::Compression::kZstd;
    default:
      return mcap::Compression::kNone;
  }
}

/// `path` itself, or with the first free number appended to its stem.
std::filesystem::path numbered(const std::filesystem::path& path, int first) {
  std::error_code error;
  if (first < 2 && !std::filesystem::exists(path, error)) return path;
  for (int number = std::max(first, 2);; ++number) {
    auto candidate = path;
    candidate.replace_filename(path.stem().string() + "-" + std::to_string(number) +
                               path.extension().string());
    if (!std::filesystem::exists(candidate, error)) return candidate;
  }
}

}  // namespace

RecordingFile::RecordingFile(std::filesystem::path path, Options options, std::unique_ptr<LogWriter> writer)
    : path_(std::move(path)),
      options_(std::move(options)),
      writer_(std::move(writer)),
      started_(realTime("%Y-%m-%dT%H:%M:%SZ", true)) {}

Result<std::unique_ptr<RecordingFile>> RecordingFile::create(const std::filesystem::path& path,
                                                             const Options& options) {
  mcap::Writer::Options container;
  container.compression = compressionOf(options.compression);
  container.chunkAge = kChunkAge;
  container.library = options.software;
  auto writer = LogWriter::create(path, container);
  if (!writer) return tl::unexpected(writer.error());
  return std::unique_ptr<RecordingFile>(new RecordingFile(path, options, std::move(*writer)));
}

Result<void> RecordingFile::writeHeld(robotlink::Instant time) {
  if (held_.empty()) return {};
  for (StreamMessage& message : held_) {
    message.time = time;
    message.frame = 0;  // the message belongs to no frame of this file
  }
  const auto written = writer_->write(held_);
  messages_ += held_.size();
  held_.clear();
  return written;
}

StreamMessage RecordingFile::coded(const StreamMessage& message) const {
  const auto* image = dynamic_cast<const foxglove::RawImage*>(message.value.get());
  if (image == nullptr) return message;
  // Images with one channel may contain classes, which JPEG would change.
  const bool exact = options_.imageCoding == ControlRecording::PNG || image->encoding() == "mono8";
  const auto compressed = exact ? pngImage(*image) : jpegImage(*image);
  if (!compressed) return message;  // unsupported formats are recorded unchanged
  StreamMessage result = message;
  result.value = *compressed;
  return result;
}

Result<void> RecordingFile::write(const RecordedFrame& frame) {
  if (frame.messages.empty()) return {};
  if (const auto held = writeHeld(frame.messages.front().time); !held) return held;
  messages_ += frame.messages.size();
  if (options_.imageCoding == ControlRecording::AS_IS) return writer_->write(frame.messages);
  std::vector<StreamMessage> messages;
  messages.reserve(frame.messages.size());
  for (const StreamMessage& message : frame.messages) messages.push_back(coded(message));
  return writer_->write(messages);
}

Result<void> RecordingFile::close(const DroppedMessages& dropped) {
  if (!held_.empty()) {
    if (const auto written = writeHeld(held_.front().time); !written) return written;
  }
  const mcap::Metadata metadata{"robotcontrol.recording",
                                {{"dropped_messages", std::to_string(dropped.messages)},
                                 {"dropped_bytes", std::to_string(dropped.bytes)},
                                 {"software", options_.software},
                                 {"started", started_}}};
  if (const auto added = writer_->container().addMetadata(metadata); !added) return added;
  return writer_->container().close();
}

Result<std::filesystem::path> newRecordingPath(const std::filesystem::path& requested,
                                               const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::path in = requested;
  if (requested.empty()) {
    in = folder;
    std::filesystem::create_directories(in, error);
    if (error) {
      return robotlink::failure(
          "recording.folder",
          "the folder for recordings cannot be made (" + error.message() + "); choose another one",
          {in.string(), 0, 0}, {in.string()});
    }
  } else if (!std::filesystem::is_directory(requested, error)) {
    return requested;
  }
  return numbered(in / realTime("robotcontrol-%Y%m%d-%H%M%S.mcap", false), 1);
}

std::filesystem::path nextRecordingPath(const std::filesystem::path& before) {
  return numbered(before, 2);
}

}  // namespace logplayer
