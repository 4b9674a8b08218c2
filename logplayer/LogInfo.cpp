// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/LogInfo.h"

#include <algorithm>

#include "foxglove/Image.pb.h"
#include "logplayer/base/DamageReport.h"
#include "logplayer/bookmarks/BookmarkStorage.h"
#include "logplayer/file/ContainerFile.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {
namespace {

using robotlink::Result;

constexpr double kOpeningShareOfInfo = 0.5;  // of the progress; the rest is counting

const char* nameOf(mcap::Compression compression) {
  switch (compression) {
    case mcap::Compression::kLz4:
      return "lz4";
    case mcap::Compression::kZstd:
      return "zstd";
    case mcap::Compression::kNone:
      break;
  }
  return "none";
}

void describeContainer(mcap::Reader& reader, LogInfo& info) {
  info.library = reader.header().library;
  for (const auto& chunk : reader.chunks()) {
    ++info.chunks;
    ++info.compressions[nameOf(chunk.compression)];
    info.compressedBytes += chunk.compressedBytes;
    info.uncompressedBytes += chunk.uncompressedBytes;
  }
  info.attachments = reader.attachmentNames();
  info.metadata = reader.metadata();
}

void count(const LogFile::Stream& stream, LogInfo& info) {
  const double length = robotlink::seconds(stream.last - stream.first);
  const double rate = stream.count > 1 && length > 0 ? static_cast<double>(stream.count - 1) / length : 0;
  info.streams.push_back({stream.path, stream.type, stream.encoding, stream.undecoded, stream.count,
                          stream.bytes, rate, stream.first, stream.last});
  info.messages += stream.count;
  if (stream.holds(foxglove::RawImage::descriptor()->full_name()) ||
      stream.holds(foxglove::CompressedImage::descriptor()->full_name())) {
    info.images += stream.count - stream.undecoded;
  }
  const auto frames = stream.path.find(std::string("/") + robotlink::streams::kFrames);
  if (!stream.holds(robotcontrol::FrameInfo::descriptor()->full_name()) || frames == std::string::npos)
    return;
  const std::string process = stream.path.substr(stream.path.rfind('/') + 1);
  info.framesOf[stream.path.substr(0, frames) + "/" + process] = stream.count;
  if (process != "platform") info.frames += stream.count;
}

Result<void> describeStreams(LogFile& log, const LogFile::Progress& progress, LogInfo& info) {
  bool givenUp = false;
  const auto streams = log.countBytes([&](double share) {
    givenUp = progress && !progress(kOpeningShareOfInfo + (1 - kOpeningShareOfInfo) * share);
    return !givenUp;
  });
  if (givenUp) return robotlink::failure("log.given-up", "canceled");
  for (const LogFile::Stream& stream : streams) count(stream, info);
  info.begin = log.begin();
  info.end = log.end();
  info.robots = log.robots();
  info.complete = log.complete();
  info.damage = log.damage();
  const auto damaged = describeDamage(info.file, info.complete, info.damage);
  info.losses.insert(info.losses.end(), damaged.begin(), damaged.end());
  return {};
}

}  // namespace

Result<LogInfo> readLogInfo(const std::filesystem::path& file, const LogFile::Progress& progress) {
  const auto opening = [&](double share) { return !progress || progress(kOpeningShareOfInfo * share); };
  const auto container = ContainerFile::of(file, opening);
  if (!container) return tl::unexpected(container.error());
  mcap::Reader::Options options;
  options.progress = opening;
  auto reader = mcap::Reader::open(container->path(), options);
  if (!reader) return tl::unexpected(reader.error());
  LogInfo info;
  info.file = file;
  std::error_code error;
  info.fileBytes = std::filesystem::file_size(file, error);
  if (const ImportReport* conversion = container->conversion()) {
    info.format = conversion->format;
    info.notUnderstood = conversion->notUnderstood;
    if (!conversion->damage.empty()) info.losses.push_back(file.string() + ": " + conversion->damage);
  } else {
    info.format = "MCAP";
    describeContainer(**reader, info);
  }
  const auto stored = storedBookmarksOf(file, container->conversion() != nullptr ? nullptr : reader->get());
  if (!stored) return tl::unexpected(stored.error());
  // Reuses the open reader: an incomplete file is scanned only once.
  const auto log = LogFile::of(container->path(), *container, std::move(*reader));
  if (const auto described = describeStreams(*log, progress, info); !described) {
    return tl::unexpected(described.error());
  }
  info.bookmarks = stored->bookmarks();
  if (stored->problem) info.losses.push_back(stored->problem->describe());
  return info;
}

}  // namespace logplayer
