// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/Recorder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "logplayer/base/RecordedStreams.h"
#include "logplayer/record/FrameRing.h"
#include "logplayer/record/RecordingThread.h"
#include "logplayer/record/RingSaver.h"
#include "robotcontrol/Debugging.pb.h"

namespace logplayer {

using robotcontrol::ControlRecording;
using robotcontrol::RecordingStatus;
using robotlink::Result;
using robotlink::StreamMessage;
using SteadyClock = std::chrono::steady_clock;

namespace {

/// Messages of a queue share one memory block with those that are left out; if more than this would be kept
/// in vain, the others are copied.
constexpr std::size_t kWorthCopying = 64U << 10U;
constexpr double kMaxKept = 3600;  // s

void makeCopy(StreamMessage& message) {
  const std::shared_ptr<google::protobuf::Message> copy(message.value->New());
  copy->CopyFrom(*message.value);
  message.value = copy;
}

}  // namespace

struct Recorder::Implementation {
  explicit Implementation(Options given);
  ~Implementation();

  // These require `mutex` to be locked.
  void add(std::vector<StreamMessage> messages);
  RecordedFramePtr selected(std::vector<StreamMessage> messages) const;
  bool wants(const StreamMessage& message) const;
  bool triggers(const StreamMessage& message) const;
  void splitIfTimeGoesBack(const StreamMessage& last);
  void restart();
  void saveOnTrigger(robotlink::Instant time);
  void demandChanged();
  bool keeps() const { return live && ring.duration() > robotlink::Duration::zero(); }
  RecordingFile::Options how() const {
    return {status.image_coding(), status.compression(), options.software};
  }

  // These require `controlling` to be locked.
  void set(const ControlRecording& control);
  Result<std::shared_ptr<RecordingFile>> newFile(const std::string& path);
  Result<void> start(const std::string& path);
  Result<void> stop();
  Result<void> saveLast(const std::string& path);

  // These are called in the worker threads.
  void ended(const robotlink::Error& error, bool newest);
  void saved(const Result<std::filesystem::path>& result);
  void warn(const std::string& text) const {
    if (options.warn) options.warn(text);
  }

  const Options options;   // `folder` below replaces options.folder
  std::mutex controlling;  // serializes control()
  std::atomic<bool> active{false};
  std::atomic<std::uint64_t> demand{1};

  mutable std::mutex mutex;  // protects the members below
  FrameRing ring;
  bool live = true;
  robotlink::LatchedMessages held;
  RecordedStreams streams;
  std::filesystem::path folder;
  std::map<std::string, robotlink::Instant> newestOf;  // time of the newest FrameInfo, by path
  RecordingStatus status;                              // settings and results
  SteadyClock::time_point startedAt;
  std::optional<robotlink::Instant> triggeredAt;

  RingSaver saver;  // declared last: saver and writer use the other members
  RecordingThread writer;
};

Recorder::Implementation::Implementation(Options given)
    : options(std::move(given)),
      ring(options.keptBytes),
      folder(options.folder),
      saver([this](const auto& result) { saved(result); }),
      writer({options.queueBytes, [this](const auto& error, bool newest) { ended(error, newest); },
              options.warn}) {}

Recorder::Implementation::~Implementation() {
  writer.close();
}

Recorder::Recorder(Options options) : implementation_(std::make_unique<Implementation>(std::move(options))) {}
Recorder::~Recorder() = default;

// ---- Messages

void Recorder::add(std::vector<StreamMessage> frame) {
  std::erase_if(frame, [](const StreamMessage& message) { return !message.value || message.path.empty(); });
  if (frame.empty()) return;
  for (StreamMessage& message : frame) {
    if (message.bytes == 0) message.bytes = robotlink::sizeOf(message);
  }
  const std::lock_guard lock(implementation_->mutex);
  implementation_->add(std::move(frame));
}

void Recorder::Implementation::add(std::vector<StreamMessage> messages) {
  splitIfTimeGoesBack(messages.back());
  const robotlink::Instant time = messages.back().time;
  const bool triggered =
      std::any_of(messages.begin(), messages.end(), [this](const auto& m) { return triggers(m); });
  for (const StreamMessage& message : messages) held.take(message);
  if (!active.load(std::memory_order_relaxed)) return;
  if (const RecordedFramePtr frame = selected(std::move(messages))) {
    if (keeps()) ring.add(frame);
    if (status.recording()) writer.push(frame);
  }
  if (triggered) saveOnTrigger(time);
}

bool Recorder::Implementation::wants(const StreamMessage& message) const {
  if (streams.contains(message.path)) return true;
  return robotlink::isLatched(message) && !streams.excludes(message.path);
}

/// The part of a frame that is to be recorded; null if there is none. A FrameInfo is kept with any other
/// message.
RecordedFramePtr Recorder::Implementation::selected(std::vector<StreamMessage> messages) const {
  const bool ended = dynamic_cast<const robotcontrol::FrameInfo*>(messages.back().value.get()) != nullptr;
  auto frame = std::make_shared<RecordedFrame>();
  std::size_t leftOut = 0;
  for (StreamMessage& message : messages) {
    const bool endsFrame = ended && &message == &messages.back();
    if (!wants(message) && !(endsFrame && !frame->messages.empty())) {
      leftOut += message.bytes;
      continue;
    }
    frame->bytes += message.bytes;
    frame->largest = std::max(frame->largest, message.bytes);
    frame->holds = frame->holds || robotlink::isLatched(message);
    frame->messages.push_back(std::move(message));
  }
  if (frame->messages.empty()) return nullptr;
  if (leftOut > kWorthCopying && leftOut > frame->bytes) {
    for (StreamMessage& message : frame->messages) makeCopy(message);
  }
  return frame;
}

void Recorder::Implementation::splitIfTimeGoesBack(const StreamMessage& last) {
  if (dynamic_cast<const robotcontrol::FrameInfo*>(last.value.get()) == nullptr) return;
  const auto known = newestOf.find(last.path);
  if (known == newestOf.end() || last.time >= known->second) {
    newestOf[last.path] = last.time;
    return;
  }
  restart();
  newestOf[last.path] = last.time;
}

void Recorder::Implementation::restart() {
  newestOf.clear();
  triggeredAt.reset();
  ring.restart(held);
  if (status.recording()) writer.openNext(how(), held.all());
}

bool Recorder::Implementation::triggers(const StreamMessage& message) const {
  return !status.trigger().empty() && fits(message.path, status.trigger());
}

/// Saves again only when everything that was saved before has left the ring; a trigger during a save is
/// ignored.
void Recorder::Implementation::saveOnTrigger(robotlink::Instant time) {
  if (!keeps()) return;
  if (triggeredAt && time - *triggeredAt < ring.duration()) return;
  if (saver.start({nullptr, folder, how(), ring.contents()})) triggeredAt = time;
}

void Recorder::restart() {
  const std::lock_guard lock(implementation_->mutex);
  implementation_->held.clear();
  implementation_->restart();
}

void Recorder::setLive(bool live) {
  const std::lock_guard lock(implementation_->mutex);
  if (implementation_->live == live) return;
  implementation_->live = live;
  implementation_->ring.restart(implementation_->held);
  implementation_->demandChanged();
}

void Recorder::forget(const std::string& robot) {
  const std::lock_guard lock(implementation_->mutex);
  implementation_->held.forget(robot);
}

bool Recorder::active() const {
  return implementation_->active.load(std::memory_order_relaxed);
}

bool Recorder::wants(const std::string& path) const {
  const std::lock_guard lock(implementation_->mutex);
  if (!active()) return false;
  const std::string& trigger = implementation_->status.trigger();
  return implementation_->streams.contains(path) || (!trigger.empty() && fits(path, trigger));
}

std::uint64_t Recorder::demand() const {
  return implementation_->demand.load(std::memory_order_relaxed);
}

void Recorder::Implementation::demandChanged() {
  active.store(status.recording() || keeps(), std::memory_order_relaxed);
  demand.fetch_add(1, std::memory_order_relaxed);
}

// ---- Control

void Recorder::setFolder(const std::filesystem::path& folder) {
  const std::lock_guard lock(implementation_->mutex);
  implementation_->folder = folder;
}

Result<void> Recorder::control(const ControlRecording& control) {
  Implementation& self = *implementation_;
  const std::lock_guard controlling(self.controlling);
  if (control.has_keep_last() && !(control.keep_last() >= 0 && control.keep_last() <= kMaxKept)) {
    return robotlink::failure("recording.keep", "between 0 and 3600 seconds can be kept in memory");
  }
  self.set(control);
  switch (control.action()) {
    case ControlRecording::START:
      return self.start(control.path());
    case ControlRecording::STOP:
      return self.stop();
    case ControlRecording::SAVE_LAST:
      return self.saveLast(control.path());
    default:
      return {};
  }
}

void Recorder::Implementation::set(const ControlRecording& control) {
  const std::lock_guard lock(mutex);
  if (control.has_selection()) {
    *status.mutable_selection() = control.selection();
    streams = RecordedStreams(control.selection());
  }
  if (control.has_image_coding()) status.set_image_coding(control.image_coding());
  if (control.has_compression()) status.set_compression(control.compression());
  if (control.has_trigger()) status.set_trigger(control.trigger());
  if (control.has_keep_last()) {
    const bool before = ring.duration() > robotlink::Duration::zero();
    status.set_keep_last(control.keep_last());
    ring.keep(robotlink::fromSeconds(control.keep_last()));
    if (!before) ring.restart(held);
  }
  demandChanged();
}

Result<std::shared_ptr<RecordingFile>> Recorder::Implementation::newFile(const std::string& requested) {
  RecordingFile::Options chosen;
  std::filesystem::path in;
  {
    const std::lock_guard lock(mutex);
    chosen = how();
    in = folder;
  }
  const auto path = newRecordingPath(requested, in);
  if (!path) return tl::unexpected(path.error());
  auto made = RecordingFile::create(*path, chosen);
  if (!made) return tl::unexpected(made.error());
  return std::shared_ptr<RecordingFile>(std::move(*made));
}

Result<void> Recorder::Implementation::start(const std::string& path) {
  {
    const std::lock_guard lock(mutex);
    if (status.recording()) {
      const std::string running = writer.progress().path.string();
      return robotlink::failure("recording.running",
                                "a recording into " + running + " is already running; stop it first", {},
                                {running});
    }
  }
  auto made = newFile(path);
  if (!made) return tl::unexpected(made.error());
  const std::lock_guard lock(mutex);
  status.set_recording(true);
  status.clear_failure();
  startedAt = SteadyClock::now();
  writer.open(std::move(*made), held.all());
  demandChanged();
  return {};
}

Result<void> Recorder::Implementation::stop() {
  const std::lock_guard lock(mutex);
  if (!status.recording()) return robotlink::failure("recording.none", "nothing is being recorded");
  writer.close();
  status.set_seconds(std::chrono::duration<double>(SteadyClock::now() - startedAt).count());
  status.set_recording(false);
  demandChanged();
  return {};
}

Result<void> Recorder::Implementation::saveLast(const std::string& path) {
  FrameRing::Contents contents;
  {
    const std::lock_guard lock(mutex);
    if (ring.duration() == robotlink::Duration::zero()) {
      return robotlink::failure("recording.nothing-kept",
                                "nothing is kept in memory to save; choose how many seconds first");
    }
    if (!live) {
      return robotlink::failure(
          "recording.nothing-kept",
          "a log is not kept in memory, because it is a file already; cut a range out of it instead");
    }
    if (ring.empty()) {
      return robotlink::failure("recording.nothing-kept", "nothing was published yet; let the robot run");
    }
    contents = ring.contents();
  }
  auto made = newFile(path);
  if (!made) return tl::unexpected(made.error());
  const std::filesystem::path file = (*made)->path();
  if (saver.start({*made, {}, {}, std::move(contents)})) return {};
  made->reset();
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  return robotlink::failure("recording.saving",
                            "the last seconds are still being saved; try again when that is done");
}

// ---- Callbacks of the worker threads

void Recorder::Implementation::ended(const robotlink::Error& error, bool newest) {
  const std::string text = "The recording has ended: " + error.describe() + ".";
  {
    const std::lock_guard lock(mutex);
    status.set_failure(text);
    if (newest && status.recording()) {
      status.set_seconds(std::chrono::duration<double>(SteadyClock::now() - startedAt).count());
      status.set_recording(false);
      demandChanged();
    }
  }
  warn(text);
}

void Recorder::Implementation::saved(const Result<std::filesystem::path>& result) {
  std::string text;
  {
    const std::lock_guard lock(mutex);
    if (result) {
      status.set_saved_path(result->string());
      return;
    }
    text = "The last seconds were not saved: " + result.error().describe();
    status.set_failure(text);
  }
  warn(text);
}

// ---- Status

RecordingStatus Recorder::status() const {
  const Implementation& self = *implementation_;
  const std::lock_guard lock(self.mutex);
  RecordingStatus status = self.status;
  if (status.recording()) {
    status.set_seconds(std::chrono::duration<double>(SteadyClock::now() - self.startedAt).count());
  }
  const RecordingThread::Progress progress = self.writer.progress();
  status.set_path(progress.path.string());
  status.set_messages(progress.messages);
  status.set_bytes(progress.bytes);
  status.set_queued_bytes(progress.queuedBytes);
  status.set_dropped_messages(progress.dropped.messages);
  status.set_dropped_bytes(progress.dropped.bytes);
  status.set_kept_seconds(robotlink::seconds(self.ring.span()));
  status.set_kept_bytes(self.ring.bytes());
  return status;
}

void Recorder::waitForRoom() {
  implementation_->writer.waitForRoom();
}

void Recorder::finish() {
  implementation_->writer.finish();
  implementation_->saver.finish();
}

}  // namespace logplayer
