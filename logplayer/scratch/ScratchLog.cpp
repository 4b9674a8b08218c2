// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/scratch/ScratchLog.h"

#include <algorithm>
#include <utility>

#include "robotlink/session/History.h"

namespace logplayer {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;
using robotlink::Stretch;

namespace {

/// How many files are kept open after they were read.
constexpr std::size_t kOpenFiles = 8;

}  // namespace

ScratchLog::ScratchLog(Options options)
    : options_(std::move(options)),
      limit_(options_.bytes),
      worker_([this](std::monostate, const std::stop_token&) { work(); }) {}

ScratchLog::~ScratchLog() {
  clear();
}

void ScratchLog::add(std::vector<StreamMessage> messages, Stretch held) {
  if (messages.empty()) return;
  bool isAfterHole = false;
  {
    const std::lock_guard lock(mutex_);
    if (isStopped_ || limit_ == 0) return;
    isAfterHole = followQueue(held.from);
    if (losingFrom_) {
      // The messages that were valid at the beginning of the hole are needed for the last instants before it.
      std::erase_if(messages, [&](const StreamMessage& message) { return message.time > *losingFrom_; });
      held = {*losingFrom_, *losingFrom_};
    }
  }
  if (messages.empty()) return;
  Entry entry{std::make_shared<ScratchSegment>(std::move(messages)), nullptr};
  entry.messages = entry.segment->messages();
  entry.isAfterHole = isAfterHole;
  for (const auto& [stream, bytes] : entry.segment->shares()) entry.waiting += bytes;
  entry.held = {std::max(held.from, entry.segment->stretch().from), held.to};
  {
    const std::lock_guard lock(mutex_);
    if (isStopped_) return;
    entries_.push_back(std::move(entry));
  }
  worker_.post({});
}

std::uint64_t ScratchLog::waiting() const {
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.waiting;
  return sum;
}

bool ScratchLog::followQueue(Instant from) {
  const std::uint64_t waits = waiting();
  if (losingFrom_) {
    const bool isOver = waits <= options_.waiting / 2;
    if (isOver) losingFrom_.reset();
    return isOver;
  }
  if (waits == 0 || waits < options_.waiting) return false;
  losingFrom_ = from;
  problem_ = {
      "history.slow",
      "The disk is too slow for the robots' data: a part of the history is lost, until the disk has caught "
      "up.",
      {},
      {}};
  return false;
}

void ScratchLog::forgetAfter(Instant time) {
  {
    const std::lock_guard lock(mutex_);
    if (entries_.empty() || time >= entries_.back().held.to) return;
  }
  // Messages that follow could not be told from those to be forgotten.
  clear();
}

void ScratchLog::clear() {
  const std::lock_guard lock(mutex_);
  drop();
}

void ScratchLog::setLimit(std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  limit_ = bytes;
  // The messages that were not added since then would be missing in between.
  if (std::exchange(isStopped_, false) || bytes == 0) drop();
  trim();
}

std::uint64_t ScratchLog::limit() const {
  const std::lock_guard lock(mutex_);
  return limit_;
}

void ScratchLog::drop() {
  std::error_code ignored;
  for (const Entry& entry : entries_) {
    if (entry.written > 0) std::filesystem::remove(entry.segment->file(), ignored);
  }
  entries_.clear();
  losingFrom_.reset();
}

void ScratchLog::request(Instant at) {
  {
    const std::lock_guard lock(mutex_);
    requested_ = at;
  }
  worker_.post({});
}

std::optional<Stretch> ScratchLog::stretch() const {
  const std::lock_guard lock(mutex_);
  if (entries_.empty()) return std::nullopt;
  return Stretch{entries_.front().held.from, entries_.back().held.to};
}

std::vector<Stretch> ScratchLog::holes() const {
  const std::lock_guard lock(mutex_);
  std::vector<Stretch> all;
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    if (entries_[i].isAfterHole) all.push_back({entries_[i - 1].held.to, entries_[i].held.from});
  }
  return all;
}

std::vector<ScratchLog::Piece> ScratchLog::pieces() const {
  const std::lock_guard lock(mutex_);
  std::vector<Piece> all;
  for (const Entry& entry : entries_)
    all.push_back({entry.held, {entry.segment, &entry.segment->times()}, entry.file, entry.messages});
  return all;
}

bool ScratchLog::hasRoom() const {
  const std::lock_guard lock(mutex_);
  return waiting() <= options_.waiting / 2;
}

bool ScratchLog::isLosing() const {
  const std::lock_guard lock(mutex_);
  return losingFrom_ && waiting() > options_.waiting / 2;
}

std::uint64_t ScratchLog::bytes() const {
  const std::lock_guard lock(mutex_);
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.written;
  return sum;
}

std::map<std::string, std::uint64_t> ScratchLog::shares() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::uint64_t> sums;
  for (const Entry& entry : entries_) {
    for (const auto& [stream, bytes] : entry.segment->shares()) sums[stream] += bytes;
  }
  return sums;
}

std::optional<robotlink::Error> ScratchLog::takeProblem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, std::nullopt);
}

std::filesystem::path ScratchLog::folder() const {
  const std::lock_guard lock(mutex_);
  return path_;
}

void ScratchLog::work() {
  while (true) {
    std::optional<Instant> at;
    std::deque<Entry> entries;
    {
      const std::lock_guard lock(mutex_);
      at = std::exchange(requested_, std::nullopt);
      if (at) entries = entries_;
    }
    // A request that a thread waits for comes first.
    if (at)
      worker_.publish(read(*at, entries));
    else if (!writeNext())
      return;
  }
}

bool ScratchLog::writeNext() {
  std::shared_ptr<ScratchSegment> segment;
  {
    const std::lock_guard lock(mutex_);
    const auto next =
        std::ranges::find_if(entries_, [](const Entry& entry) { return entry.messages != nullptr; });
    if (next == entries_.end()) return false;
    segment = next->segment;
  }
  const Result<std::uint64_t> written = write(*segment);
  const std::lock_guard lock(mutex_);
  const auto entry =
      std::ranges::find_if(entries_, [&](const Entry& each) { return each.segment == segment; });
  std::error_code ignored;
  if (entry == entries_.end() || !written) std::filesystem::remove(segment->file(), ignored);
  if (entry == entries_.end()) return true;
  if (!written) {
    stop(written.error().text);
    return true;
  }
  entry->waiting = 0;
  entry->written = *written;
  entry->file = segment->file();
  entry->messages.reset();
  trim();
  return true;
}

Result<std::uint64_t> ScratchLog::write(ScratchSegment& segment) {
  if (!folder_) {
    auto made = ScratchFolder::make();
    if (!made) return tl::unexpected(made.error());
    folder_.emplace(std::move(*made));
    const std::lock_guard lock(mutex_);
    path_ = folder_->path();
  }
  std::error_code error;
  const auto space = std::filesystem::space(folder_->path(), error);
  if (!error && space.available < options_.reserve) {
    return robotlink::failure("history.full", "the disk is full", {folder_->path().string(), 0, 0});
  }
  if (options_.beforeWrite) options_.beforeWrite();
  const auto file = folder_->path() / (std::to_string(++files_) + ".mcap");
  if (auto written = segment.write(file); !written) return tl::unexpected(written.error());
  return std::max<std::uint64_t>(1, std::filesystem::file_size(file, error));
}

void ScratchLog::trim() {
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.written;
  std::error_code ignored;
  while (sum > limit_ && !entries_.empty() && entries_.front().written > 0) {
    std::filesystem::remove(entries_.front().segment->file(), ignored);
    sum -= entries_.front().written;
    entries_.pop_front();
  }
}

void ScratchLog::stop(const std::string& why) {
  std::erase_if(entries_, [](const Entry& entry) { return entry.messages != nullptr; });
  isStopped_ = true;
  losingFrom_.reset();
  problem_ = {"history.disk",
              "The history is no longer written to disk: " + why +
                  ". From now on, only what fits into memory is kept.",
              {why},
              {}};
}

ScratchLog::Part ScratchLog::read(Instant at, const std::deque<Entry>& entries) const {
  Part part{at, {at, at}, {}};
  if (entries.empty()) return part;
  // Only the part between the surrounding holes is complete.
  Instant first = entries.front().held.from, last = entries.back().held.to;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (!entries[i].isAfterHole) continue;
    if (entries[i].held.from > at) {
      last = entries[i - 1].held.to;
      break;
    }
    first = entries[i].held.from;
  }
  part.stretch = {std::clamp(at - robotlink::History::kBefore, first, last),
                  std::clamp(at + robotlink::History::kBehind, first, last)};
  const auto [from, to] = part.stretch;
  // The messages of a stream are in the order of the entries, so that the last one that begins in time has
  // the newest.
  std::map<std::string, ScratchSegment*> newest;
  for (const Entry& entry : entries) {
    for (const auto& [stream, times] : entry.segment->times()) {
      if (times.from <= from) newest[stream] = entry.segment.get();
    }
  }
  for (const auto& [stream, segment] : newest) {
    if (auto message = segment->latest(stream, from)) part.messages.push_back(std::move(*message));
  }
  std::size_t open = 0;
  for (const Entry& entry : entries) {
    const Stretch& has = entry.segment->stretch();
    // Messages that cannot be read are left out, like those that were lost with a file.
    if (has.to > from && has.from <= to)
      (void)entry.segment->read(from, to, part.messages);
    else if (++open > kOpenFiles)
      entry.segment->close();
  }
  std::ranges::stable_sort(part.messages, {}, &StreamMessage::time);
  return part;
}

}  // namespace logplayer
