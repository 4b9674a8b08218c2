// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/NumberReader.h"

#include <algorithm>

namespace logplayer {
namespace {

using robotlink::Instant;

/// What is read here is read once.
constexpr std::size_t kNumberCacheBytes = 16U << 20U;

}  // namespace

NumberReader::NumberReader(std::filesystem::path file, std::size_t maxWaiting)
    : file_(std::move(file)),
      maxWaiting_(maxWaiting),
      worker_([this](std::monostate, const std::stop_token& stop) { work(stop); }) {}

NumberReader::~NumberReader() = default;

void NumberReader::read(const std::set<LogNumber>& numbers) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(readings_, [&](const auto& reading) {
      const bool goes = !numbers.contains(reading.first);
      if (goes) waiting_ -= reading.second.waiting.size();
      return goes;
    });
    for (const LogNumber& number : numbers) {
      const auto [reading, isNew] = readings_.try_emplace(number);
      if (!isNew) continue;
      reading->second.id = ++lastId_;
      if (auto path = robotlink::FieldPath::parse(number.field)) reading->second.path = std::move(*path);
    }
  }
  worker_.post({});
}

NumberReader::News NumberReader::take() {
  News news;
  {
    const std::lock_guard lock(mutex_);
    news.failure = failure_;
    Instant reached = end_;
    bool isReading = false;
    for (auto& [number, reading] : readings_) {
      if (!reading.waiting.empty()) news.points[number] = std::exchange(reading.waiting, {});
      if (reading.isComplete) {
        news.complete.push_back(number);
        continue;
      }
      isReading = true;
      reached = std::min(reached, std::max(reading.reached, begin_));
    }
    const double length = robotlink::seconds(end_ - begin_);
    if (isReading) news.progress = length > 0 ? robotlink::seconds(reached - begin_) / length : 0;
    waiting_ = 0;
  }
  taken_.notify_all();
  return news;
}

void NumberReader::work(const std::stop_token& stop) {
  if (!open(stop)) return;
  while (!stop.stop_requested()) {
    Pass pass = nextPass();
    if (pass.readings.empty()) return;
    run(pass, stop);
  }
}

bool NumberReader::open(const std::stop_token& stop) {
  if (log_) return true;
  LogFile::Options options;
  options.cacheBytes = kNumberCacheBytes;
  options.progress = [&stop](double) { return !stop.stop_requested(); };
  auto opened = LogFile::open(file_, options);
  if (!opened && stop.stop_requested()) return false;
  const std::lock_guard lock(mutex_);
  if (!opened) {
    failure_ = opened.error();
    return false;
  }
  log_ = std::move(*opened);
  begin_ = log_->begin();
  end_ = log_->end();
  return true;
}

NumberReader::Pass NumberReader::nextPass() const {
  const std::lock_guard lock(mutex_);
  Pass pass;
  pass.from = Instant::max();
  for (const auto& [number, reading] : readings_) {
    if (!reading.isComplete) pass.from = std::min(pass.from, reading.reached);
  }
  for (const auto& [number, reading] : readings_) {
    if (reading.isComplete) continue;
    if (reading.reached == pass.from) {
      pass.readings.emplace(number, Reading{reading.id, reading.path});
    } else {
      pass.until = std::min(pass.until, reading.reached);
    }
  }
  return pass;
}

void NumberReader::run(Pass& pass, const std::stop_token& stop) {
  std::multimap<std::string, Reading*> ofStream;
  std::set<std::string> streams;
  for (auto& [number, reading] : pass.readings) {
    ofStream.emplace(number.stream, &reading);
    streams.insert(number.stream);
  }
  LogFile::Cursor cursor(log_, {streams.begin(), streams.end()});
  if (pass.from > Instant::min()) cursor.seek(pass.from);
  Instant reached = pass.from;
  std::size_t count = 0;
  while (const auto next = cursor.nextTime()) {
    if (*next >= pass.until) break;
    // Messages of one time are read together, so that it is known what was read.
    if (*next > reached) {
      reached = *next;
      const bool isDue = ++count % kInstants == 0 || stop.stop_requested();
      if (isDue && !publish(pass, reached, stop)) return;
    }
    const auto message = cursor.next();
    if (!message || message->time >= pass.until) break;
    const auto [first, last] = ofStream.equal_range(message->path);
    for (auto at = first; at != last; ++at) {
      Reading& reading = *at->second;
      const auto value = reading.path ? reading.path->valueIn(*message->value) : std::nullopt;
      if (value && value->number)
        reading.waiting.push_back({robotlink::seconds(message->time), *value->number});
    }
  }
  publish(pass, pass.until, stop);
}

bool NumberReader::publish(Pass& pass, Instant reached, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  for (auto& [number, part] : pass.readings) {
    const auto found = readings_.find(number);
    Points points = std::exchange(part.waiting, {});
    if (found == readings_.end() || found->second.id != part.id) continue;
    Reading& reading = found->second;
    waiting_ += points.size();
    reading.waiting.insert(reading.waiting.end(), points.begin(), points.end());
    reading.reached = reached;
    reading.isComplete = reached == Instant::max();
  }
  taken_.wait(lock, stop, [this] { return waiting_ <= maxWaiting_; });
  return !stop.stop_requested();
}

}  // namespace logplayer
