// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <deque>
#include <string>

#include "robotlink/base/Clock.h"
#include "widgets/color/ColorLearner.h"

namespace widgets {

class ColorBench;

/// Images of a simulated robot with the true class of each pixel, to score tables with: while it is on, it
/// asks the robot for them (package oracle/classes) and gives the bench one image a second, the last kMax.
/// Logs that hold them serve as well. tick() is called once a tick. GUI thread; the bench must outlive it.
class TrueClassFrames final : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t kMax = 30;

  explicit TrueClassFrames(ColorBench& bench, QObject* parent = nullptr);

  /// Off: removes the bench's labeled images.
  void setOn(bool on);
  bool on() const { return on_; }
  /// Number of images.
  std::size_t count() const { return frames_.size(); }
  /// Call this once per tick.
  void tick();

 private:
  /// Requests the debug key on or off.
  void ask(const std::string& robot, bool on);

  ColorBench& bench_;
  bool on_ = false;
  /// The robot whose key was requested; empty: none.
  std::string asked_;
  std::deque<LabeledFrame> frames_;
  /// Time of the newest image.
  robotlink::Instant last_;
};

}  // namespace widgets
