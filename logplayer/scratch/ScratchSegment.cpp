// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/scratch/ScratchSegment.h"

#include <algorithm>
#include <utility>

#include "logplayer/base/LogWriter.h"

namespace logplayer {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

/// Small chunks, since few messages of many streams are read.
constexpr std::size_t kScratchChunkBytes = 256U << 10U;
/// How many messages are written at a time.
constexpr std::size_t kMessagesAtOnce = 32;
constexpr std::size_t kScratchCacheBytes = 16U << 20U;

}  // namespace

ScratchSegment::ScratchSegment(std::vector<StreamMessage> messages)
    : messages_(std::make_shared<const std::vector<StreamMessage>>(std::move(messages))),
      stretch_{Instant::max(), Instant::min()} {
  for (const StreamMessage& message : *messages_) {
    auto& times = times_.try_emplace(message.path, Times{message.time, message.time}).first->second;
    times = {std::min(times.from, message.time), std::max(times.to, message.time)};
    stretch_ = {std::min(stretch_.from, message.time), std::max(stretch_.to, message.time)};
    shares_[message.path] += message.bytes;
  }
}

Result<void> ScratchSegment::write(const std::filesystem::path& file) {
  const auto all = std::exchange(messages_, nullptr);
  // Other threads may be reading the messages.
  std::vector<const StreamMessage*> messages;
  messages.reserve(all->size());
  for (const StreamMessage& message : *all) messages.push_back(&message);
  std::ranges::stable_sort(messages, {}, [](const StreamMessage* message) { return message->time; });
  mcap::Writer::Options options;
  options.compression = mcap::Compression::kLz4;
  options.crc = false;
  options.sync = false;
  options.chunkBytes = kScratchChunkBytes;
  const auto writer = LogWriter::create(file, options);
  if (!writer) return tl::unexpected(writer.error());
  file_ = file;
  for (std::size_t at = 0; at < messages.size(); at += kMessagesAtOnce) {
    std::vector<StreamMessage> some;
    for (std::size_t i = at; i < std::min(at + kMessagesAtOnce, messages.size()); ++i)
      some.push_back(*messages[i]);
    if (auto written = (*writer)->write(some); !written) return written;
  }
  return (*writer)->container().close();
}

Result<void> ScratchSegment::open() {
  if (log_) return {};
  auto opened = LogFile::open(file_, {.cacheBytes = kScratchCacheBytes, .progress = {}});
  if (!opened) return tl::unexpected(opened.error());
  log_ = std::move(*opened);
  return {};
}

std::optional<StreamMessage> ScratchSegment::latest(const std::string& stream, Instant time) {
  if (!file_.empty()) return open() ? log_->latest(stream, time) : std::nullopt;
  const StreamMessage* newest = nullptr;
  if (messages_ == nullptr) return std::nullopt;
  for (const StreamMessage& message : *messages_) {
    if (message.path == stream && message.time <= time && (newest == nullptr || newest->time <= message.time))
      newest = &message;
  }
  return newest != nullptr ? std::optional(*newest) : std::nullopt;
}

Result<void> ScratchSegment::read(Instant from, Instant to, std::vector<StreamMessage>& out) {
  const auto isMeant = [&](const StreamMessage& message) {
    return message.time > from && message.time <= to;
  };
  if (file_.empty()) {
    if (messages_ != nullptr)
      std::copy_if(messages_->begin(), messages_->end(), std::back_inserter(out), isMeant);
    return {};
  }
  if (auto opened = open(); !opened) return opened;
  LogFile::Cursor cursor(log_, {});
  cursor.seek(from);
  while (auto message = cursor.next()) {
    if (message->time > to) break;
    if (isMeant(*message)) out.push_back(std::move(*message));
  }
  return {};
}

}  // namespace logplayer
