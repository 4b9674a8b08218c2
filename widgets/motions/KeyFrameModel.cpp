// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/KeyFrameModel.h"

#include <algorithm>

#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/motions/MotionWriter.h"

namespace widgets {

void KeyFrameModel::show(const robotlink::MotionFile& motion, std::vector<std::string> columns,
                         std::shared_ptr<const robotlink::RobotDescription> robot) {
  auto frames = robotlink::keyFramesOf(motion);
  const bool isSameSize = frames.size() == frames_.size() && columns == columns_;
  if (!isSameSize) beginResetModel();
  motion_ = motion;
  frames_ = std::move(frames);
  columns_ = std::move(columns);
  robot_ = std::move(robot);
  if (!isSameSize)
    endResetModel();
  else if (!frames_.empty())
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const robotlink::KeyFrame& KeyFrameModel::frameOf(int row) const {
  return robotlink::keyFrameAt(motion_, frames_[static_cast<std::size_t>(row)]);
}

int KeyFrameModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(frames_.size());
}

int KeyFrameModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kFirstJoint + static_cast<int>(columns_.size());
}

QString KeyFrameModel::text(const QModelIndex& index) const {
  const robotlink::KeyFrame& frame = frameOf(index.row());
  const auto shown = [](const std::string& text) { return QString::fromStdString(text); };
  switch (index.column()) {
    case kBegin:
      return shown(robotlink::writeDuration(motion_, frames_[static_cast<std::size_t>(index.row())].begin));
    case kDuration:
      return shown(robotlink::writeDuration(motion_, frame.duration));
    case kInterpolation:
      return QString::number(frame.interpolation);
    default:
      break;
  }
  const auto joint = static_cast<std::size_t>(index.column() - kFirstJoint);
  return joint < frame.joints.size() ? shown(robotlink::writeValue(motion_, frame.joints[joint])) : QString();
}

QVariant KeyFrameModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::DisplayRole || role == Qt::EditRole) return text(index);
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::ToolTipRole) return {};
  if (index.column() == kInterpolation)
    return tr("0 jumps at once and holds, 1 is linear, 2 and 3 start and end softly");
  return index.column() >= kFirstJoint ? QVariant(tr("An angle, * (stays as it is) or - (released)"))
                                       : QVariant();
}

QString KeyFrameModel::limitsOf(int section) const {
  if (robot_ == nullptr) return {};
  const int joint = robot_->jointIndex(columns_[static_cast<std::size_t>(section - kFirstJoint)]);
  if (joint < 0) return tr("The selected robot has no such joint");
  const auto& limits = robot_->joints[static_cast<std::size_t>(joint)];
  return tr("From %1° to %2°")
      .arg(robotlink::degrees(limits.minimum), 0, 'f', 1)
      .arg(robotlink::degrees(limits.maximum), 0, 'f', 1);
}

QVariant KeyFrameModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const bool isJoint = orientation == Qt::Horizontal && section >= kFirstJoint && section < columnCount();
  if (role == Qt::ToolTipRole && isJoint) return limitsOf(section);
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  switch (section) {
    case kBegin:
      return inTicks() ? tr("At, ticks") : tr("At, ms");
    case kDuration:
      return inTicks() ? tr("Takes, ticks") : tr("Takes, ms");
    case kInterpolation:
      return tr("Int");
    default:
      return isJoint
                 ? QVariant(QString::fromStdString(columns_[static_cast<std::size_t>(section - kFirstJoint)]))
                 : QVariant();
  }
}

Qt::ItemFlags KeyFrameModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.isValid() && index.column() != kBegin ? usual | Qt::ItemIsEditable : usual;
}

bool KeyFrameModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || index.column() == kBegin) return false;
  const QString typed = value.toString().trimmed();
  if (typed == text(index)) return true;
  bool isNumber = false;
  const int number = typed.toInt(&isNumber);
  const robotlink::Duration unit =
      inTicks() ? robotlink::kMotionTick : robotlink::Duration(std::chrono::milliseconds(1));
  if (index.column() == kDuration)
    Q_EMIT durationTyped(index.row(), isNumber ? number * unit.count() : -1);
  else if (index.column() == kInterpolation)
    Q_EMIT interpolationTyped(index.row(), isNumber ? number : -1);
  else
    Q_EMIT valueTyped(index.row(), index.column() - kFirstJoint, typed);
  return true;
}

}  // namespace widgets
