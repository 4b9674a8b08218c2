// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/NumberReader.h"

#include <algorithm>

namespace logplayer {
using robotlink::Instant;

NumberReader::NumberReader(std::filesystem::path file, std::size_t maxWaiting)
    : NumberReader(logSource(std::move(file)), maxWaiting) {}

NumberReader::NumberReader(std::unique_ptr<MessageSource> source, std::size_t maxWaiting)
    : source_(std::move(source)),
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
      if (!reading.texts.empty()) news.texts[number] = std::exchange(reading.texts, {});
      if (reading.problem) news.problems.emplace(number, *reading.problem);
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
  if (isOpen_) return true;
  const auto opened = source_->open([&stop](double) { return !stop.stop_requested(); });
  if (!opened && stop.stop_requested()) return false;
  const std::lock_guard lock(mutex_);
  if (!opened) {
    failure_ = opened.error();
    return false;
  }
  isOpen_ = true;
  begin_ = source_->stretch().from;
  end_ = source_->stretch().to;
  return true;
}

NumberReader::Pass NumberReader::nextPass() {
  const std::lock_guard lock(mutex_);
  std::erase_if(memories_, [this](const auto& memory) {
    return std::ranges::none_of(readings_,
                                [&](const auto& reading) { return reading.second.id == memory.first; });
  });
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

NumberReader::Memory& NumberReader::memoryOf(const LogNumber& number, Reading& reading) {
  const auto [memory, isNew] = memories_.try_emplace(reading.id);
  if (!isNew || !number.stream.empty()) return memory->second;
  auto bound = robotlink::BoundExpression::bind(number.field, source_->streams(), {});
  if (bound) {
    memory->second.expression = std::make_unique<robotlink::BoundExpression>(std::move(bound->front()));
  } else {
    reading.problem = bound.error();
  }
  return memory->second;
}

/// Takes the messages of a pass, and makes points of them.
class NumberReader::PassRun {
 public:
  PassRun(NumberReader& reader, Pass& pass) {
    for (auto& [number, reading] : pass.readings) {
      Memory& memory = reader.memoryOf(number, reading);
      if (!number.stream.empty()) ofStream_.emplace(number.stream, Part{&reading, &memory});
      if (!memory.expression) continue;
      const auto& needed = memory.expression->streams();
      for (const std::string& stream : std::set<std::string>(needed.begin(), needed.end()))
        ofStream_.emplace(stream, Part{&reading, &memory});
    }
  }
  std::vector<std::string> streams() const {
    std::set<std::string> all;
    for (const auto& [stream, part] : ofStream_) all.insert(stream);
    return {all.begin(), all.end()};
  }
  void take(const robotlink::StreamMessage& message) {
    const auto [first, last] = ofStream_.equal_range(message.path);
    for (auto at = first; at != last; ++at) {
      const Part& part = at->second;
      if (part.memory->expression) {
        const auto taken = part.memory->expression->take(message.path, *message.value);
        if (!taken) part.reading->problem = taken.error();
        if (std::ranges::find(changed_, part) == changed_.end()) changed_.push_back(part);
      } else if (part.reading->path) {
        add(part, message.time, part.reading->path->valueIn(*message.value));
      }
    }
  }
  /// Computes the expressions of which messages were taken, all of one time.
  void compute(Instant time) {
    for (const Part& part : changed_) add(part, time, part.memory->expression->valueOrText());
    changed_.clear();
  }

 private:
  struct Part {
    Reading* reading;
    Memory* memory;
    bool operator==(const Part&) const = default;
  };
  static void add(const Part& part, Instant time, const std::optional<robotlink::FieldValue>& value) {
    const auto number = value ? value->asNumber() : std::nullopt;
    if (!number) return;
    part.reading->waiting.push_back({robotlink::seconds(time), *number});
    Texts& known = part.memory->texts;
    if (!value->text || known.size() >= kMaxTexts || known.contains(*number)) return;
    known.emplace(*number, *value->text);
    part.reading->texts.emplace(*number, *value->text);
  }

  std::multimap<std::string, Part> ofStream_;
  std::vector<Part> changed_;
};

void NumberReader::run(Pass& pass, const std::stop_token& stop) {
  PassRun run(*this, pass);
  const auto streams = run.streams();
  // A cursor without streams would go through all.
  if (streams.empty()) {
    publish(pass, pass.until, stop);
    return;
  }
  const auto cursor = source_->read(streams, pass.from);
  Instant reached = pass.from;
  std::size_t count = 0;
  while (const auto next = cursor->nextTime()) {
    if (*next >= pass.until) break;
    // Messages of one time are read together, so that it is known what was read.
    if (*next > reached) {
      run.compute(reached);
      reached = *next;
      const bool isDue = ++count % kInstants == 0 || stop.stop_requested();
      if (isDue && !publish(pass, reached, stop)) return;
    }
    const auto message = cursor->next();
    if (!message || message->time >= pass.until) break;
    run.take(*message);
  }
  run.compute(reached);
  publish(pass, pass.until, stop);
}

bool NumberReader::publish(Pass& pass, Instant reached, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  for (auto& [number, part] : pass.readings) {
    const auto found = readings_.find(number);
    Points points = std::exchange(part.waiting, {});
    Texts texts = std::exchange(part.texts, {});
    if (found == readings_.end() || found->second.id != part.id) continue;
    Reading& reading = found->second;
    reading.texts.merge(texts);
    if (part.problem) reading.problem = part.problem;
    waiting_ += points.size();
    reading.waiting.insert(reading.waiting.end(), points.begin(), points.end());
    reading.reached = reached;
    reading.isComplete = reached == Instant::max();
  }
  taken_.wait(lock, stop, [this] { return waiting_ <= maxWaiting_; });
  return !stop.stop_requested();
}

}  // namespace logplayer
