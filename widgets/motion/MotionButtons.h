// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QStringList>

namespace widgets {

/// A button for each key-frame motion that is shipped (resources/motions/*.mof) and one for getting up. The
/// buttons are toggle buttons: the one of the motion that the robot reports to be playing is checked. Object
/// names: "motion-<name>". GUI thread.
class MotionButtons final : public QGroupBox {
  Q_OBJECT
 public:
  explicit MotionButtons(QWidget* parent = nullptr);
  /// Names of the shipped motions in alphabetical order. Left out are "extern" (the exit of the motions'
  /// grammar) and the motions for getting up, which are requested by MotionCommander::kGetUp. Reads the
  /// folder on each call.
  static QStringList shippedMotions();
  /// Checks the button of the motion that the robot reports; empty: it plays none.
  void showPlaying(const QString& motion);

 Q_SIGNALS:
  /// The user pressed a button. `motion` is the motion's name, or MotionCommander::kGetUp.
  void chosen(const QString& motion);

 private:
  /// Adds a button; `place` counts from 0 in rows of two.
  void add(const QString& motion, int place);
};

}  // namespace widgets
