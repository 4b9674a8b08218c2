// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QStringList>

namespace widgets {

/// A button for each key-frame motion that is shipped (resources/motions/*.mof) and one to get up.
class MotionButtons final : public QGroupBox {
  Q_OBJECT
 public:
  explicit MotionButtons(QWidget* parent = nullptr);
  /// The names of the shipped motions, in order; without those that only lead from one motion to another.
  static QStringList shippedMotions();
  /// What the robot plays now; its button is marked. Empty: none.
  void showPlaying(const QString& motion);

 Q_SIGNALS:
  void chosen(const QString& motion);

 private:
  void add(const QString& motion, int place);
};

}  // namespace widgets
