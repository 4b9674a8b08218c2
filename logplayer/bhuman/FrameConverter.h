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

/// Turns the messages of a queue into streams of a robot, frame by frame: what lies between ProcessBegin and
/// ProcessFinished is told at the time of its image, or of its joint data, or else at that of the frame
/// before it, its FrameInfo last. Frames count from 1 for each process. One thread.
class FrameConverter {
 public:
  using Frame = std::vector<robotlink::StreamMessage>;
  /// Takes frames that are complete, in the order of the queue.
  using FrameSink = std::function<robotlink::Result<void>(Frame)>;
  /// Is told what is wrong with a message, and where that is in the file.
  using Trouble = std::function<void(std::uint64_t offset, const std::string& text)>;
  using Counts = std::map<std::string, std::uint64_t>;

  FrameConverter(std::string robot, FrameSink sink, Trouble trouble);

  /// Fails as the sink does.
  robotlink::Result<void> add(const QueueMessage& message);
  /// What is still open is a frame, too.
  robotlink::Result<void> finish();

  const Counts& imported() const { return imported_; }
  const Counts& notUnderstood() const { return notUnderstood_; }

 private:
  /// What was read between two ProcessBegin.
  struct Contents {
    std::string process;       ///< empty: none has begun
    std::uint64_t offset = 0;  ///< of its first message, in the file
    std::optional<CameraImage> image;
    std::optional<CameraPlace> place;
    std::optional<CameraOptics> optics;
    std::optional<JointAngles> joints;
    std::optional<SensorReadings> sensors;
    std::optional<std::vector<Reading>> keys;
    std::optional<robotlink::Pose2> odometry;
    std::vector<std::string> texts;

    bool empty() const;
    std::optional<robotlink::Instant> time() const;
  };

  /// Whether it was understood.
  robotlink::Result<bool> take(const QueueMessage& message);
  robotlink::Result<bool> takeImage(const QueueMessage& message, robotlink::Result<CameraImage> image);
  robotlink::Result<bool> begin(const QueueMessage& message);
  template <typename Value>
  robotlink::Result<bool> put(std::optional<Value> Contents::*slot, std::optional<Value> value);
  robotlink::Result<void> close();
  robotlink::Result<void> tellUntimed();
  /// `next`: the time of the frame behind it, if it is known.
  robotlink::Result<void> tellDoubtful(std::optional<robotlink::Instant> next);
  robotlink::Result<void> tell(const Contents& contents, std::optional<robotlink::Instant> stated);

  Frame messagesOf(const Contents& contents, robotlink::Instant time);
  void tellCamera(const Contents& contents, robotlink::Instant time, Frame& frame);
  void tellBody(const Contents& contents, robotlink::Instant time, Frame& frame);
  void tellTexts(const Contents& contents, robotlink::Instant time, Frame& frame);

  std::string robot_;
  FrameSink sink_;
  Trouble trouble_;
  Counts imported_, notUnderstood_;
  Contents contents_;
  std::vector<Contents> untimed_;     ///< before the first time that is known
  std::optional<Contents> doubtful_;  ///< its time lies far from that of the frame before it
  std::optional<robotlink::Instant> lastTime_;
  std::map<std::string, robotlink::Instant> timeOfProcess_;
  std::map<std::string, std::uint64_t> frames_;
  CameraOptics optics_;
  bool placeValid_ = true;
};

}  // namespace logplayer::bhuman
