// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/motions/MotionEdits.h"

namespace robotlink {
struct RobotDescription;
}

namespace widgets {

/// The key frames of a motion, in the order of its text: a row each, with its begin, duration and
/// interpolation, and a column for each joint. Values are in the units of the text. It is shown a motion, and
/// says what the user wants to change. GUI thread.
class KeyFrameModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kBegin, kDuration, kInterpolation, kFirstJoint };

  explicit KeyFrameModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  /// `columns`: the joint of each column; `robot`, whose limits are shown, may be null.
  void show(const robotlink::MotionFile& motion, std::vector<std::string> columns,
            std::shared_ptr<const robotlink::RobotDescription> robot);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

 Q_SIGNALS:
  // Emitted when the user has typed a value; a duration or interpolation below 0 is invalid.
  void durationTyped(int frame, qint64 nanoseconds);
  void interpolationTyped(int frame, int interpolation);
  void valueTyped(int frame, int joint, const QString& value);

 private:
  const robotlink::KeyFrame& frameOf(int row) const;
  QString text(const QModelIndex& index) const;
  QString limitsOf(int section) const;
  bool inTicks() const { return motion_.timeUnit == robotlink::MotionFile::TimeUnit::kTicks; }

  robotlink::MotionFile motion_;
  std::vector<robotlink::KeyFramePlace> frames_;
  std::vector<std::string> columns_;
  std::shared_ptr<const robotlink::RobotDescription> robot_;
};

}  // namespace widgets
