// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <deque>
#include <string>

#include "robotlink/base/Clock.h"
#include "widgets/color/ColorLearner.h"

namespace widgets {

class ColorBench;

/// Labeled images of a simulated robot, to score tables with. While it is on, it switches on the debug key of
/// the package oracle/classes (the true class of each pixel) of the selected robot and gives the bench one
/// image per second, keeping the last kMost. Logs that contain the package work as well. GUI thread; the
/// bench must outlive it.
class TrueClassFrames final : public QObject {
  Q_OBJECT
 public:
  /// Bound of the images that are kept.
  static constexpr std::size_t kMost = 30;

  explicit TrueClassFrames(ColorBench& bench, QObject* parent = nullptr);

  /// Off: removes the bench's labeled images.
  void setOn(bool on);
  bool on() const { return on_; }
  /// Number of images.
  std::size_t count() const { return frames_.size(); }
  /// To be called once per tick.
  void tick();

 private:
  /// Requests the debug key on or off.
  void ask(const std::string& robot, bool on);

  ColorBench& bench_;
  bool on_ = false;
  /// The robot whose key was requested; empty: none.
  std::string asked_;
  std::deque<LabelledFrame> frames_;
  /// Time of the newest image.
  robotlink::Instant last_;
};

}  // namespace widgets
