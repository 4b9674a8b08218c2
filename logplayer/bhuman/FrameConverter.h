// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/bhuman/MessageQueueReader.h"
#include "logplayer/bhuman/Payloads.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer::bhuman {

/// Converts the messages of a queue to streams of a robot, frame by frame: the data between ProcessBegin and
/// ProcessFinished is published at the time of its image, joint data or sensor data (the first of these that
/// it contains), or else at the time of the previous frame of the process; its FrameInfo comes last. Frames
/// are counted from 1 for each process. A time far from those of both neighboring frames is replaced. One
/// thread.
class FrameConverter {
 public:
  /// The messages of one frame.
  using Frame = std::vector<robotlink::StreamMessage>;
  /// Receives complete frames in the order of the queue.
  using FrameSink = std::function<robotlink::Result<void>(Frame)>;
  /// Receives what is wrong with a message, and its offset in the file.
  using Trouble = std::function<void(std::uint64_t offset, const std::string& text)>;
  /// Number of messages by kind.
  using Counts = std::map<std::string, std::uint64_t>;

  /// `robot`: the first part of the paths of all streams.
  FrameConverter(std::string robot, FrameSink sink, Trouble trouble);

  /// Processes the next message; fails if the sink fails.
  robotlink::Result<void> add(const QueueMessage& message);
  /// Call this after the last message: delivers the frames that are still held back. Fails if the sink
  /// fails.
  robotlink::Result<void> finish();

  /// Messages that were converted, and messages that were left out.
  const Counts& imported() const { return imported_; }
  const Counts& notUnderstood() const { return notUnderstood_; }

 private:
  /// The data of one frame, converted from its messages.
  struct Contents {
    /// Name of the process; empty if the ProcessBegin is missing.
    std::string process;
    /// Offset of the first message in the file.
    std::uint64_t offset = 0;
    std::optional<CameraImage> image;
    std::optional<CameraPlace> place;
    std::optional<CameraOptics> optics;
    std::optional<JointAngles> joints;
    std::optional<SensorReadings> sensors;
    std::optional<std::vector<Reading>> keys;
    std::optional<robotlink::Pose2> odometry;
    std::vector<std::string> texts;

    bool empty() const;
    /// The time that the data states, if any.
    std::optional<robotlink::Instant> time() const;
  };

  /// Adds a message to contents_; returns whether it was understood.
  robotlink::Result<bool> take(const QueueMessage& message);
  robotlink::Result<bool> takeImage(const QueueMessage& message, robotlink::Result<CameraImage> image);
  /// Handles ProcessBegin.
  robotlink::Result<bool> begin(const QueueMessage& message);
  /// Stores a value. If the frame already has one of its kind, a ProcessBegin was lost, and a new frame
  /// begins.
  template <typename Value>
  robotlink::Result<bool> put(std::optional<Value> Contents::*slot, std::optional<Value> value);
  /// Ends the current frame.
  robotlink::Result<void> close();
  /// Delivers the frames before the first known time.
  robotlink::Result<void> convertUntimed();
  /// Delivers the frame with the doubtful time. `next`: the time of the frame after it, if known, which can
  /// confirm it.
  robotlink::Result<void> convertDoubtful(std::optional<robotlink::Instant> next);
  /// Delivers a frame; `stated`: its own time, if that can be trusted.
  robotlink::Result<void> convert(const Contents& contents, std::optional<robotlink::Instant> stated);

  /// Converts the data of a frame to messages.
  Frame messagesOf(const Contents& contents, robotlink::Instant time);
  /// convertCamera(), convertBody() and convertTexts() append the messages of one kind of data.
  void convertCamera(const Contents& contents, robotlink::Instant time, Frame& frame);
  void convertBody(const Contents& contents, robotlink::Instant time, Frame& frame);
  void convertTexts(const Contents& contents, robotlink::Instant time, Frame& frame);

  std::string robot_;
  FrameSink sink_;
  Trouble trouble_;
  Counts imported_, notUnderstood_;
  Contents contents_;
  /// Frames before the first known time, to be delivered at that time.
  std::vector<Contents> untimed_;
  /// A frame whose time is far from that of the previous frame.
  std::optional<Contents> doubtful_;
  /// Time of the last frame of any process.
  std::optional<robotlink::Instant> lastTime_;
  /// Time of the last frame of each process.
  std::map<std::string, robotlink::Instant> timeOfProcess_;
  /// Number of frames of each process.
  std::map<std::string, std::uint64_t> frames_;
  /// The last optics that were logged, for the following camera poses.
  CameraOptics optics_;
  /// Whether the last camera pose was valid; a text is published when this changes.
  bool placeValid_ = true;
};

}  // namespace logplayer::bhuman
