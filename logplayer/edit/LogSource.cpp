// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogSource.h"

#include <algorithm>
#include <iterator>

#include "logplayer/base/DamageReport.h"
#include "logplayer/base/LogChannels.h"
#include "logplayer/base/Plural.h"
#include "logplayer/bookmarks/BookmarkStorage.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {
namespace {

using mcap::Reader;
using robotlink::Instant;
using robotlink::Result;

// Maximum distance of a frame's messages from its FrameInfo.
constexpr robotlink::Duration kFrameSpan = std::chrono::seconds(1);
// Maximum number of incomplete frames of a process, in case their messages are interleaved.
constexpr std::size_t kOpenFrames = 8;

std::string framesPathOf(const mcap::Channel& channel) {
  const auto process = channel.metadata.find("process");
  if (process == channel.metadata.end() || process->second.empty()) return {};
  return robotlink::streams::robotOf(channel.topic) + "/" + robotlink::streams::kFrames + process->second;
}

std::string listed(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [kind, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  return text;
}

}  // namespace

LogSource::~LogSource() = default;
LogSource::LogSource(LogSource&&) noexcept = default;

Result<LogSource> LogSource::open(const std::filesystem::path& file, const LogFile::Progress& progress,
                                  std::size_t cacheBytes) {
  LogSource source;
  source.file_ = file;
  auto container = ContainerFile::of(file, progress);
  if (!container) return tl::unexpected(container.error());
  if (container->conversion()) source.noteConversion(*container->conversion());
  source.container_.emplace(std::move(*container));
  Reader::Options options;
  options.progress = progress;
  options.cacheBytes = cacheBytes;
  auto reader = Reader::open(source.container_->path(), options);
  if (!reader) return tl::unexpected(reader.error());
  source.reader_ = std::move(*reader);
  const bool converted = source.container_->conversion() != nullptr;
  auto stored = storedBookmarksOf(file, converted ? nullptr : source.reader_.get());
  if (!stored) return tl::unexpected(stored.error());
  source.bookmarks_ = stored->bookmarks();
  if (stored->problem) source.otherLosses_.push_back(stored->problem->describe());
  source.robots_ = LogChannels(*source.reader_).robots();
  source.choose({}, {}, {});
  return source;
}

void LogSource::noteConversion(const ImportReport& report) {
  if (!report.notUnderstood.empty()) {
    notes_.push_back(file_.string() + ": not understood of the " + report.format + ": " +
                     listed(report.notUnderstood));
  }
  if (!report.damage.empty()) otherLosses_.push_back(file_.string() + ": " + report.damage);
}

void LogSource::listProcesses() {
  processes_.clear();
  processOf_.clear();
  std::map<std::string, std::size_t> known;
  for (const auto& [id, channel] : reader_->channels()) {
    if (const std::string path = framesPathOf(channel); !path.empty() && channel.topic == path) {
      if (known.try_emplace(path, processes_.size()).second) processes_.emplace_back().frames = path;
    }
  }
  for (const auto& [id, channel] : reader_->channels()) {
    const auto found = known.find(framesPathOf(channel));
    if (found != known.end()) processOf_[id] = &processes_[found->second];
  }
}

void LogSource::choose(std::optional<Instant> from, std::optional<Instant> to, const StreamFilter& streams) {
  from_ = from;
  to_ = to;
  listProcesses();
  const StreamFilter notExcluded{{}, streams.exclude};
  channels_.clear();
  for (const auto& [id, channel] : reader_->channels()) {
    if (channel.topic == robotlink::streams::kBookmarks || !streams.has(channel.topic)) continue;
    channels_.push_back(id);
    if (const auto process = processOf_.find(id); process != processOf_.end()) {
      process->second->ends = notExcluded.has(process->second->frames);
    }
  }
  // FrameInfos show which frames are complete, even if they are not copied.
  for (const auto& [id, process] : processOf_) {
    const bool frameInfo = reader_->channels().at(id).topic == process->frames;
    if (frameInfo && std::find(channels_.begin(), channels_.end(), id) == channels_.end())
      channels_.push_back(id);
  }
  cursor_.emplace(*reader_, channels_);
  if (from) cursor_->seek({*from - kFrameSpan, 0, 0, 0});
  position_ = reader_->statistics().messageStart;
  ready_.clear();
  atEnd_ = channels_.empty();
}

std::vector<Reader::MessageData> LogSource::held() {
  std::vector<Reader::MessageData> result;
  if (!from_) return result;
  for (const std::uint16_t id : channels_) {
    const auto& channel = reader_->channels().at(id);
    const auto schema = reader_->schemas().find(channel.schemaId);
    const std::string type = schema == reader_->schemas().end() ? "" : schema->second.name;
    if (!isLatched(channel.topic, type)) continue;
    const auto position = reader_->latest(id, *from_ - robotlink::Duration(1));
    if (!position) continue;
    if (auto data = reader_->read(*position)) {
      result.push_back(std::move(*data));
    } else {
      ++unread_;
    }
  }
  return result;
}

bool LogSource::inRange(Instant time) const {
  return (!from_ || *from_ <= time) && (!to_ || time <= *to_);
}

std::optional<LogUnit> LogSource::next() {
  while (ready_.empty() && !atEnd_) {
    const bool more = cursor_->next();
    if (!more || (to_ && *to_ + kFrameSpan < cursor_->message().logTime)) {
      atEnd_ = true;
      // Damage after the range is not a loss.
      if (!more && !to_) {
        for (Process& process : processes_) forgetOpenFrames(process, 0);
      }
      break;
    }
    position_ = cursor_->message().logTime;
    if (cursor_->readable()) {
      place(cursor_->data());
    } else {
      ++unread_;
    }
  }
  if (ready_.empty()) return std::nullopt;
  LogUnit unit = std::move(ready_.front());
  ready_.pop_front();
  return unit;
}

void LogSource::place(Reader::MessageData data) {
  const auto found = processOf_.find(data.message.channelId);
  const std::uint32_t frame = data.message.sequence;
  const Instant time = data.message.logTime;
  const auto alone = [&] {
    std::vector<Reader::MessageData> messages;
    messages.push_back(std::move(data));
    ready_.push_back({time, false, std::move(messages)});
  };
  if (found == processOf_.end() || frame == 0) {
    if (inRange(time)) alone();
    return;
  }
  Process& process = *found->second;
  if (reader_->channels().at(data.message.channelId).topic == process.frames) {
    endFrame(process, std::move(data));
  } else if (process.done == frame) {
    if (process.doneKept) alone();
  } else {
    process.open[frame].push_back(std::move(data));
    forgetOpenFrames(process, kOpenFrames);
  }
}

void LogSource::endFrame(Process& process, Reader::MessageData frameInfo) {
  const std::uint32_t frame = frameInfo.message.sequence;
  const Instant time = frameInfo.message.logTime;
  auto open = process.open.extract(frame);
  process.done = frame;
  process.doneKept = inRange(time);
  if (!process.doneKept) return;
  LogUnit unit{time, !process.frames.ends_with("/platform"),
               open.empty() ? std::vector<Reader::MessageData>() : std::move(open.mapped())};
  if (process.ends) unit.messages.push_back(std::move(frameInfo));
  if (!unit.messages.empty()) ready_.push_back(std::move(unit));
}

void LogSource::forgetOpenFrames(Process& process, std::size_t maxOpen) {
  while (process.open.size() > maxOpen) {
    const auto oldest =
        std::min_element(process.open.begin(), process.open.end(), [](const auto& a, const auto& b) {
          return a.second.front().message.logTime < b.second.front().message.logTime;
        });
    if (inRange(oldest->second.front().message.logTime)) ++incompleteFrames_;
    process.open.erase(oldest);
  }
}

std::vector<std::string> LogSource::losses() const {
  const std::string name = file_.string() + ": ";
  std::vector<std::string> result = otherLosses_;
  const auto damaged = describeDamage(file_, reader_->complete(), reader_->damage());
  result.insert(result.end(), damaged.begin(), damaged.end());
  if (unread_ > 0) result.push_back(name + plural(unread_, "message") + " could not be read");
  if (incompleteFrames_ > 0) {
    result.push_back(name + plural(incompleteFrames_, "frame") + " left out, of which the end is missing");
  }
  return result;
}

}  // namespace logplayer
