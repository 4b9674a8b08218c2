// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>
#include <optional>

namespace widgets {

struct JointRow;

/// The angle of a joint between its limits: measured as a bar from 0, requested as a mark. While the user
/// steers, it is a slider: a click or a drag turns the joint to that angle, as do the keys of sliders; the
/// wheel does only while it has the focus, so that scrolling a table turns no joint. GUI thread.
class JointSlider final : public QSlider {
  Q_OBJECT
 public:
  /// A slider's step is a tenth of a degree.
  static constexpr int kPerDegree = 10;

  explicit JointSlider(const JointRow& joint, QWidget* parent = nullptr);
  /// Shows new values; the slider itself moves only while the user does not hold it.
  void showJoint(const JointRow& joint);
  QSize sizeHint() const override { return {160, 16}; }
  QSize minimumSizeHint() const override { return {80, 12}; }

 Q_SIGNALS:
  /// The user wants this angle, rad.
  void angleWanted(double angle);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  /// The position of an angle, pixels.
  double placeOf(double angle) const;
  void moveTo(int x);

  double minimum_, maximum_;
  std::optional<double> requested_, measured_;
  bool isCommanded_ = false;
};

}  // namespace widgets
