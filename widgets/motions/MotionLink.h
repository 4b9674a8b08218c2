// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "widgets/View.h"

namespace widgets {

class ManualSteering;
class MotionBench;

/// The motion that is edited and the program of the selected robot: sends the text, which the program plays
/// from then on without a restart, takes it back, plays it, and puts the robot into the pose of a key frame.
/// Playing and posing need manual control. GUI thread; owned by the bench.
class MotionLink final : public QObject {
  Q_OBJECT
 public:
  /// kNone: there is no motion, or no robot that plays motions.
  /// kSame: the robot has this text. kOther: it has another one of this name, or none.
  /// kSending: a reply is pending. kRefused: the robot refused the last text, see text().
  enum class State : std::uint8_t { kNone, kSame, kOther, kSending, kRefused };

  explicit MotionLink(MotionBench& bench);

  /// Sends the text to the selected robot. Fails if there is none, or no motion.
  robotlink::Result<void> send();
  /// Lets the robot have the motion of its files again.
  robotlink::Result<void> takeBack();
  /// Whether each change without errors is sent, a moment after it.
  void setAutoSend(bool on);
  bool autoSend() const { return autoSend_; }
  /// Plays the motion once; sends it before if the robot has another text.
  robotlink::Result<void> play();
  /// Selects the key frame `count` places later (negative: earlier) and, with manual control, turns the
  /// robot's joints to it.
  robotlink::Result<void> step(int count);

  State state() const;
  /// The state for the user: "red1 has this motion", or what was refused.
  QString text() const;
  /// The time at which playing the edited motion began, in the session's time; unset: it is not played.
  std::optional<robotlink::Instant> playedSince() const { return playedSince_; }

  /// Called 30 times a second.
  void tick();

 Q_SIGNALS:
  /// State, text or autoSend() changed.
  void changed();

 private:
  void ask(const std::string& text, std::function<void()> accepted);
  robotlink::Result<void> requireRobot() const;
  void pose();
  void followPlaying();

  MotionBench& bench_;
  ManualSteering& manual_;
  bool autoSend_ = false;
  bool isPending_ = false;
  /// The reason why the robot refused the text that was last sent; empty: it did not.
  QString refusal_;
  /// The text that was sent last, and the robot.
  std::string sent_, robot_;
  /// Number of the last request, so that late replies are ignored.
  std::uint64_t asked_ = 0;
  int ticksPending_ = 0, ticksUnchanged_ = 0;
  std::optional<robotlink::Instant> playedSince_;
};

/// The link of a window, created on the first call.
MotionLink& motionLink(ViewContext& context);

/// Follows the robot, and keeps what is unsaved; called 30 times a second by the window.
void tickMotions(ViewContext& context);

}  // namespace widgets
