// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugContext.h"

#include <algorithm>
#include <deque>
#include <iterator>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {

using robotcontrol::KeyMode;

namespace {

using Messages = std::vector<SharedDebugMessage>;

struct CompleteFrame {
  Messages messages;
  std::size_t bytes = 0;
};

/// About the bytes of a message on a wire. Counting them costs less than writing them; of images and tables,
/// which are large, next to nothing.
std::size_t wireSizeOf(const SharedDebugMessage& message) {
  constexpr std::size_t kAround = 24;  // the timestamp, and the fields' numbers and lengths
  return kAround + message.path.size() + message.content->ByteSizeLong();
}

foxglove::Log::Level logLevel(Level level) {
  switch (level) {
    case Level::kDebug:
      return foxglove::Log::DEBUG;
    case Level::kInfo:
      return foxglove::Log::INFO;
    case Level::kWarning:
      return foxglove::Log::WARNING;
    case Level::kError:
      break;
  }
  return foxglove::Log::ERROR;
}

}  // namespace

struct DebugContext::Frame {
  Instant now;
  std::uint64_t number = 0;
  // Messages of the current frame, which is not complete yet.
  Messages messages;
  struct Begun {
    int key;
    google::protobuf::Message* content;
  };
  // The drawings and images of the frame; one message per key.
  std::vector<Begun> begun;
  std::deque<CompleteFrame> complete;
  std::size_t completeBytes = 0;
};

DebugContext::DebugContext(std::string process, const Clock& clock, Options options)
    : process_(std::move(process)),
      clock_(clock),
      options_(options),
      states_(DebugKey::all().size()),
      frame_(std::make_unique<Frame>()) {
  DebugKey::seal();
  frame_->now = clock_.now();
}

DebugContext::~DebugContext() = default;

bool DebugContext::dueNow(int key) {
  State& state = states_[static_cast<std::size_t>(key)];
  switch (state.kind) {
    case KeyMode::ALWAYS:
      return true;
    case KeyMode::N_TIMES:
      if (++state.count >= state.n) state.kind = KeyMode::OFF;
      return true;
    case KeyMode::EVERY_N:
      if (++state.count < state.n) return false;
      state.count = 0;
      return true;
    case KeyMode::EVERY_MS: {
      // After the time has gone back (a simulation was reset), the last use counts as long ago.
      const Duration since = frame_->now - state.last;
      if (state.count > 0 && since >= Duration::zero() && since < std::chrono::milliseconds(state.n))
        return false;
      state.count = 1;
      state.last = frame_->now;
      return true;
    }
    default:
      return false;
  }
}

void DebugContext::setMode(int key, const KeyMode& mode) {
  if (key < 0 || static_cast<std::size_t>(key) >= states_.size() || !KeyMode::Kind_IsValid(mode.kind()))
    return;
  const bool never = mode.kind() == KeyMode::OFF || (mode.kind() == KeyMode::N_TIMES && mode.n() == 0);
  State state;
  state.kind = static_cast<std::uint8_t>(never ? KeyMode::OFF : mode.kind());
  state.n = never || mode.kind() == KeyMode::ALWAYS ? 0 : mode.n();
  states_[static_cast<std::size_t>(key)] = state;
}

KeyMode DebugContext::mode(int key) const {
  KeyMode mode;
  if (key < 0 || static_cast<std::size_t>(key) >= states_.size()) return mode;
  const State& state = states_[static_cast<std::size_t>(key)];
  mode.set_kind(static_cast<KeyMode::Kind>(state.kind));
  mode.set_n(state.n);
  return mode;
}

void DebugContext::beginFrame(Instant now, std::uint64_t number) {
  frame_->now = now;
  frame_->number = number;
}

Instant DebugContext::frameTime() const {
  return frame_->now;
}

void DebugContext::take(DebugContext& other, const std::string& prefix, const std::string& author) {
  for (SharedDebugMessage& message : other.frame_->messages) {
    if (const auto* text = message.as<foxglove::Log>(); text != nullptr && message.path == streams::kLog) {
      auto signedText = std::make_shared<foxglove::Log>(*text);
      // The source follows the name of the process, which the other context does not need to know.
      const std::string source = text->name().substr(std::min(text->name().find('/'), text->name().size()));
      signedText->set_name(process_ + source + " (" + author + ")");
      message.content = std::move(signedText);
    } else {
      message.path.insert(0, prefix);
    }
    frame_->messages.push_back(std::move(message));
  }
  other.frame_->messages.clear();
  other.frame_->begun.clear();
}

void DebugContext::endFrame() {
  auto& info = add<robotcontrol::FrameInfo>(streams::kFrames + process_);
  assign(*info.mutable_timestamp(), frame_->now);
  info.set_process(process_);
  info.set_number(frame_->number);
  CompleteFrame complete{std::exchange(frame_->messages, {}), 0};
  frame_->begun.clear();
  for (const SharedDebugMessage& message : complete.messages) complete.bytes += wireSizeOf(message);
  frame_->completeBytes += complete.bytes;
  frame_->complete.push_back(std::move(complete));
  while (frame_->completeBytes > options_.maxQueueBytes) {
    const CompleteFrame& oldest = frame_->complete.front();
    dropped_ += oldest.messages.size();
    frame_->completeBytes -= oldest.bytes;
    frame_->complete.pop_front();
  }
}

SharedDebugMessage& DebugContext::package(const std::string& path, PackagePtr package) {
  return frame_->messages.emplace_back(SharedDebugMessage{path, frame_->now, std::move(package)});
}

/// A key has one type of contents.
template <typename T>
T& DebugContext::contentFor(const DebugKey& key) {
  for (const Frame::Begun& begun : frame_->begun) {
    if (begun.key == key.index()) return static_cast<T&>(*begun.content);
  }
  T& content = add<T>(key.stream());
  frame_->begun.push_back({key.index(), &content});
  return content;
}

bool DebugContext::hasQueue() const {
  return !frame_->complete.empty();
}

std::shared_ptr<SharedDebugQueue> DebugContext::takeQueue() {
  auto queue = std::make_shared<SharedDebugQueue>();
  queue->process = process_;
  queue->dropped = dropped_;
  for (CompleteFrame& frame : frame_->complete) {
    queue->messages.insert(queue->messages.end(), std::make_move_iterator(frame.messages.begin()),
                           std::make_move_iterator(frame.messages.end()));
  }
  frame_->complete.clear();
  frame_->completeBytes = 0;
  return queue;
}

ImageDrawing DebugContext::imageDrawing(const ImageDrawingKey& key) {
  return ImageDrawing(contentFor<foxglove::ImageAnnotations>(key), frame_->now);
}

foxglove::SceneEntity& DebugContext::entityFor(const DebugKey& key, const std::string& frame) {
  foxglove::SceneUpdate& update = contentFor<foxglove::SceneUpdate>(key);
  if (update.entities_size() > 0) return *update.mutable_entities(0);
  foxglove::SceneEntity& entity = *update.add_entities();
  assign(*entity.mutable_timestamp(), frame_->now);
  entity.set_frame_id(frame);
  entity.set_id(key.name());
  return entity;
}

SceneDrawing DebugContext::fieldDrawing(const FieldDrawingKey& key) {
  return SceneDrawing(entityFor(key, "field"));
}

SceneDrawing DebugContext::robotDrawing(const RobotDrawingKey& key) {
  return SceneDrawing(entityFor(key, robot_));
}

void DebugContext::image(const ImageKey& key, const ImageView& image) {
  if (!image.empty()) assign(contentFor<foxglove::RawImage>(key), image, frame_->now, robot_);
}

void DebugContext::plot(const PlotKey& key, double value, const char* unit) {
  plot(key, "", value, unit);
}

void DebugContext::plot(const PlotKey& key, const char* curve, double value, const char* unit) {
  std::string path = key.stream();
  if (*curve != '\0') path.append("/").append(curve);
  auto& plotted = add<robotcontrol::PlotValue>(path);
  assign(*plotted.mutable_timestamp(), frame_->now);
  plotted.set_value(value);
  plotted.set_unit(unit);
}

void DebugContext::text(Level level, std::string_view source, std::string text) {
  auto& log = add<foxglove::Log>(streams::kLog);
  assign(*log.mutable_timestamp(), frame_->now);
  log.set_level(logLevel(level));
  log.set_message(validUtf8(std::move(text)));
  log.set_name(process_ + "/" + std::string(source));
}

}  // namespace robotlink
