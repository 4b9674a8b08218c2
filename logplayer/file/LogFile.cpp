// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogFile.h"

#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "logplayer/base/LogChannels.h"
#include "logplayer/base/Plural.h"
#include "logplayer/file/ContainerFile.h"
#include "logplayer/mcap/read/MessageCursor.h"
#include "robotlink/session/LatchedMessages.h"

namespace logplayer {

using mcap::MessagePosition;
using robotlink::Instant;
using robotlink::StreamMessage;

namespace {

constexpr MessagePosition kStart{Instant::min(), 0, 0, 0};

}  // namespace

struct LogFile::Implementation {
  Implementation(std::filesystem::path given, std::unique_ptr<mcap::Reader> opened, ContainerFile file)
      : path(std::move(given)),
        container(std::move(file)),
        reader(std::move(opened)),
        channels(std::make_unique<LogChannels>(*reader)) {
    readOnly = container.conversion() != nullptr || ::access(path.c_str(), W_OK) != 0;
    listStreams();
  }

  void listStreams();
  std::uint64_t countOf(std::uint16_t id);
  Stream describe(const std::string& streamPath, const std::vector<std::uint16_t>& ids);
  std::optional<StreamMessage> read(const MessagePosition& position);
  std::optional<MessagePosition> next(MessagePosition than, const std::vector<std::uint16_t>& ids);
  std::optional<MessagePosition> previous(MessagePosition than, const std::vector<std::uint16_t>& ids);
  std::vector<std::uint16_t> idsOf(const std::vector<std::string>& paths) const;

  const std::filesystem::path path;
  const ContainerFile container;
  bool readOnly = false;
  std::vector<Stream> streams;
  Instant begin, end;

  std::mutex mutex;  // protects the members below
  std::unique_ptr<mcap::Reader> reader;
  std::unique_ptr<LogChannels> channels;
  std::set<MessagePosition> unreadable;
};

robotlink::Result<std::shared_ptr<LogFile>> LogFile::open(const std::filesystem::path& file,
                                                          const Options& options) {
  auto container = ContainerFile::of(file, options.progress);
  if (!container) return tl::unexpected(container.error());
  mcap::Reader::Options reading;
  reading.cacheBytes = options.cacheBytes;
  reading.progress = options.progress;
  auto reader = mcap::Reader::open(container->path(), std::move(reading));
  if (!reader) return tl::unexpected(reader.error());
  return of(file, std::move(*container), std::move(*reader));
}

std::shared_ptr<LogFile> LogFile::of(const std::filesystem::path& file, ContainerFile container,
                                     std::unique_ptr<mcap::Reader> reader) {
  return std::shared_ptr<LogFile>(
      new LogFile(std::make_unique<Implementation>(file, std::move(reader), std::move(container))));
}

LogFile::LogFile(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

LogFile::~LogFile() = default;

// ---- Contents

void LogFile::Implementation::listStreams() {
  bool any = false;
  const auto include = [&](const Stream& stream) {
    begin = any ? std::min(begin, stream.first) : stream.first;
    end = any ? std::max(end, stream.last) : stream.last;
    any = true;
  };
  for (const auto& [streamPath, ids] : channels->streams()) {
    Stream stream = describe(streamPath, ids);
    if (stream.count > 0) streams.push_back(std::move(stream));
  }
  // Latched messages may be much older than the recording, and messages of the world may outlast its robots.
  for (const Stream& stream : streams) {
    if (stream.path.find('/') != std::string::npos && !robotlink::isLatched(stream.path, stream.type)) {
      include(stream);
    }
  }
  if (any) return;
  for (const Stream& stream : streams) include(stream);
}

std::uint64_t LogFile::Implementation::countOf(std::uint16_t id) {
  if (!channels->cutShort(id)) return reader->statistics().channelMessageCounts.at(id);
  const auto times = reader->times(id);
  return static_cast<std::uint64_t>(
      std::upper_bound(times.begin(), times.end(), channels->completeUntil(id)) - times.begin());
}

LogFile::Stream LogFile::Implementation::describe(const std::string& streamPath,
                                                  const std::vector<std::uint16_t>& ids) {
  Stream stream;
  stream.path = streamPath;
  stream.type = channels->type(ids.back()).name();
  stream.encoding = channels->type(ids.back()).encoding();
  for (const std::uint16_t id : ids) {
    const std::uint64_t count = countOf(id);
    stream.count += count;
    if (!channels->type(id).isDecoded()) stream.undecoded += count;
  }
  if (const auto first = next(kStart, ids)) stream.first = first->time;
  if (const auto last = previous({Instant::max(), ~std::uint64_t{0}, ~std::uint64_t{0}, 0xFFFF}, ids)) {
    stream.last = last->time;
  }
  return stream;
}

const std::filesystem::path& LogFile::path() const {
  return implementation_->path;
}
bool LogFile::readOnly() const {
  return implementation_->readOnly;
}
const std::vector<LogFile::Stream>& LogFile::streams() const {
  return implementation_->streams;
}
Instant LogFile::begin() const {
  return implementation_->begin;
}
Instant LogFile::end() const {
  return implementation_->end;
}

std::vector<LogFile::Stream> LogFile::countBytes(const Progress& progress) {
  Implementation& self = *implementation_;
  std::map<std::string, std::uint64_t> bytes;
  std::uint64_t seen = 0;
  bool wanted = true;
  {
    const std::lock_guard lock(self.mutex);
    const std::uint64_t all = std::max<std::uint64_t>(1, self.reader->statistics().messageCount);
    self.reader->readAll([&](const mcap::Message& message) {
      const auto channel = self.reader->channels().find(message.channelId);
      if (channel != self.reader->channels().end() &&
          message.logTime <= self.channels->completeUntil(message.channelId)) {
        bytes[channel->second.topic] += message.data.size();
      }
      if (++seen % 1024 == 0 && progress) {
        wanted = progress(std::min(1.0, static_cast<double>(seen) / static_cast<double>(all)));
      }
      return wanted;
    });
  }
  if (!wanted) return {};
  std::vector<Stream> counted = self.streams;
  for (Stream& stream : counted) stream.bytes = bytes[stream.path];
  return counted;
}

std::vector<std::string> LogFile::robots() const {
  const std::set<std::string> robots = implementation_->channels->robots();
  return {robots.begin(), robots.end()};
}

bool LogFile::complete() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->reader->complete();
}

std::vector<mcap::Damage> LogFile::damage() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->reader->damage();
}

std::string LogFile::damageText() const {
  const std::lock_guard lock(implementation_->mutex);
  const auto& damage = implementation_->reader->damage();
  std::string text;
  if (const auto lost = implementation_->reader->cutOffBytes(); lost > 0) {
    text = "the file was cut short while it was open: " + plural(lost, "byte") + " are gone from its end";
  } else if (!implementation_->reader->complete())
    text = "the file was not closed: its end may be missing";
  if (!damage.empty()) {
    std::uint64_t bytes = 0;
    for (const auto& place : damage) bytes += place.bytes;
    text += (text.empty() ? "" : "; ") + plural(damage.size(), "damaged place") + " (" +
            plural(bytes, "byte") + "), first at byte " + std::to_string(damage.front().offset) + ": " +
            damage.front().what;
  }
  if (const auto count = implementation_->unreadable.size(); count > 0) {
    text += (text.empty() ? "" : "; ") + plural(count, "message") + " could not be read";
  }
  return text;
}

// ---- Searching and reading

std::optional<StreamMessage> LogFile::Implementation::read(const MessagePosition& position) {
  auto message = channels->read(position);
  if (!message) unreadable.insert(position);
  return message;
}

std::optional<MessagePosition> LogFile::Implementation::next(MessagePosition than,
                                                             const std::vector<std::uint16_t>& ids) {
  auto found = reader->next(than, ids);
  while (found && channels->hidden(*found)) found = reader->next(*found, ids);
  return found;
}

std::optional<MessagePosition> LogFile::Implementation::previous(MessagePosition than,
                                                                 const std::vector<std::uint16_t>& ids) {
  auto found = reader->previous(than, ids);
  while (found && channels->hidden(*found)) found = reader->previous(*found, ids);
  return found;
}

std::vector<std::uint16_t> LogFile::Implementation::idsOf(const std::vector<std::string>& paths) const {
  std::vector<std::uint16_t> ids;
  if (paths.empty()) {
    for (const auto& [streamPath, those] : channels->streams())
      ids.insert(ids.end(), those.begin(), those.end());
  }
  for (const std::string& streamPath : paths) {
    const auto& those = channels->of(streamPath);
    ids.insert(ids.end(), those.begin(), those.end());
  }
  return ids;
}

std::optional<StreamMessage> LogFile::latest(const std::string& stream, Instant time) {
  Implementation& self = *implementation_;
  const std::lock_guard lock(self.mutex);
  const auto& ids = self.channels->of(stream);
  std::optional<MessagePosition> found;
  for (const std::uint16_t id : ids) {
    const auto candidate = self.reader->latest(id, std::min(time, self.channels->completeUntil(id)));
    if (candidate && (!found || *found < *candidate)) found = candidate;
  }
  for (; found; found = self.previous(*found, ids)) {
    if (auto message = self.read(*found)) return message;
  }
  return std::nullopt;
}

std::optional<Instant> LogFile::timeAfter(const std::string& stream, Instant time) {
  Implementation& self = *implementation_;
  const std::lock_guard lock(self.mutex);
  const auto found =
      self.next({time, ~std::uint64_t{0}, ~std::uint64_t{0}, 0xFFFF}, self.channels->of(stream));
  return found ? std::optional(found->time) : std::nullopt;
}

std::vector<Instant> LogFile::times(const std::string& stream) {
  Implementation& self = *implementation_;
  const std::lock_guard lock(self.mutex);
  std::vector<Instant> times;
  for (const std::uint16_t id : self.channels->of(stream)) {
    const auto those = self.reader->times(id);
    const auto shown = std::upper_bound(those.begin(), those.end(), self.channels->completeUntil(id));
    const auto before = static_cast<std::ptrdiff_t>(times.size());
    times.insert(times.end(), those.begin(), shown);
    std::inplace_merge(times.begin(), times.begin() + before, times.end());
  }
  return times;
}

// ---- Cursor

struct LogFile::Cursor::Implementation {
  Implementation(std::shared_ptr<LogFile> opened, const std::vector<std::string>& streams)
      : file(std::move(opened)), log(*file->implementation_), messages(*log.reader, log.idsOf(streams)) {}

  /// Moves to the next message that is shown, unless it is there already. Only with the file's mutex locked.
  bool advance() {
    while (!ahead && !atEnd) {
      atEnd = !messages.next();
      ahead = !atEnd && !log.channels->hidden(messages.position());
    }
    return ahead;
  }

  std::shared_ptr<LogFile> file;
  LogFile::Implementation& log;
  mcap::MessageCursor messages;
  bool ahead = false;  // the current message of `messages` was not returned yet
  bool atEnd = false;
  std::map<std::string, std::uint64_t> unread;
};

LogFile::Cursor::Cursor(std::shared_ptr<LogFile> file, const std::vector<std::string>& streams)
    : implementation_(std::make_unique<Implementation>(std::move(file), streams)) {}

LogFile::Cursor::~Cursor() {
  // A cursor shares chunks with the file's cache, so it is destroyed under the file's mutex.
  if (!implementation_) return;
  const std::shared_ptr<LogFile> file = implementation_->file;
  const std::lock_guard lock(file->implementation_->mutex);
  implementation_.reset();
}
LogFile::Cursor::Cursor(Cursor&&) noexcept = default;
LogFile::Cursor& LogFile::Cursor::operator=(Cursor&& other) noexcept {
  std::swap(implementation_, other.implementation_);
  return *this;
}

void LogFile::Cursor::seek(Instant time) {
  implementation_->messages.seek({time, 0, 0, 0});
  implementation_->ahead = implementation_->atEnd = false;
}

std::optional<Instant> LogFile::Cursor::nextTime() {
  const std::lock_guard lock(implementation_->log.mutex);
  return implementation_->advance() ? std::optional(implementation_->messages.message().logTime)
                                    : std::nullopt;
}

std::optional<StreamMessage> LogFile::Cursor::next() {
  Implementation& self = *implementation_;
  const std::lock_guard lock(self.log.mutex);
  while (self.advance()) {
    self.ahead = false;
    const mcap::MessageCursor& at = self.messages;
    if (auto message = at.readable() ? self.log.channels->read(at.message()) : std::nullopt) return message;
    self.log.unreadable.insert(at.position());
    ++self.unread[self.log.channels->path(at.message().channelId)];
  }
  return std::nullopt;
}

const std::map<std::string, std::uint64_t>& LogFile::Cursor::unread() const {
  return implementation_->unread;
}

}  // namespace logplayer
