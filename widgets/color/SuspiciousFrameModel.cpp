// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/SuspiciousFrameModel.h"

#include <algorithm>
#include <iterator>

#include "robotlink/base/Clock.h"

namespace widgets {

SuspiciousFrameModel::SuspiciousFrameModel(QObject* parent)
    : RowModel({tr("Image"), tr("Suspicion"), tr("Classes"), tr("Specks"), tr("Enclosed"), tr("Ambiguous"),
                tr("Vast")},
               parent) {}

void SuspiciousFrameModel::clear(colortool::ColorClasses classes) {
  beginResetModel();
  classes_ = std::move(classes);
  rows_.clear();
  endResetModel();
}

void SuspiciousFrameModel::add(std::vector<SuspiciousFrame> frames) {
  if (frames.empty()) return;
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(frames.size()) - 1);
  std::ranges::move(frames, std::back_inserter(rows_));
  endInsertRows();
  if (rows_.size() > FrameSearch::kMaxKept) removeMildest(rows_.size() - FrameSearch::kMaxKept);
}

void SuspiciousFrameModel::removeMildest(std::size_t count) {
  for (; count > 0; --count) {
    const auto mildest =
        std::ranges::min_element(rows_, {}, [](const SuspiciousFrame& frame) { return frame.found.score; });
    const int row = static_cast<int>(mildest - rows_.begin());
    beginRemoveRows({}, row, row);
    rows_.erase(mildest);
    endRemoveRows();
  }
}

void SuspiciousFrameModel::setOrigin(robotlink::Instant time) {
  if (std::exchange(origin_, time) == time || rows_.empty()) return;
  Q_EMIT dataChanged(index(0, kTime), index(rowCount() - 1, kTime));
}

double SuspiciousFrameModel::value(const SuspiciousFrame& frame, int column) const {
  switch (column) {
    case kTime:
      return robotlink::seconds(frame.time - origin_);
    case kScore:
      return frame.found.score;
    case kSpecks:
      return frame.found.pixels.specks;
    case kEnclosed:
      return frame.found.pixels.enclosed;
    case kAmbiguous:
      return frame.found.pixels.ambiguous;
    case kVast:
      return frame.found.pixels.vast;
    default:
      return 0;
  }
}

QString SuspiciousFrameModel::classesOf(const SuspiciousFrame& frame) const {
  std::vector<std::pair<std::uint32_t, int>> counts;
  for (std::size_t i = 0; i < frame.found.byClass.size(); ++i) {
    if (frame.found.byClass[i].all() > 0)
      counts.emplace_back(frame.found.byClass[i].all(), static_cast<int>(i));
  }
  std::ranges::sort(counts, std::greater<>());
  QStringList texts;
  for (const auto& [count, colorClass] : counts) {
    if (colorClass < classes_.size())
      texts << QStringLiteral("%1 %2").arg(QString::fromStdString(classes_.name(colorClass)),
                                           QString::number(count));
  }
  return texts.join(QStringLiteral(", "));
}

QVariant SuspiciousFrameModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SuspiciousFrame& one = row(index.row());
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      if (column == kClasses) return classesOf(one);
      if (column == kTime) return tr("%1 s").arg(value(one, column), 0, 'f', 3);
      return QString::number(value(one, column), 'f', 0);
    case kSortRole:
      return column == kClasses ? QVariant(classesOf(one)) : QVariant(value(one, column));
    case Qt::DecorationRole:
      return column == kTime ? QVariant(one.thumbnail) : QVariant();
    case Qt::ToolTipRole:
      return column == kClasses ? QVariant(classesOf(one)) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant::fromValue<int>(
          Qt::AlignVCenter | (column == kTime || column == kClasses ? Qt::AlignLeft : Qt::AlignRight));
    default:
      return {};
  }
}

QVariant SuspiciousFrameModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue<int>(
        Qt::AlignVCenter | (section == kTime || section == kClasses ? Qt::AlignLeft : Qt::AlignRight));
  }
  const QString tips[] = {
      tr("Its time"),
      tr("Weighted suspicious pixels: specks count 1, enclosed ones 0.5, ambiguous ones "
         "0.1, those of vast areas 0.02"),
      tr("Suspicious pixels of each class"),
      tr("Pixels of colored areas that are too small to be objects"),
      tr("Pixels of small areas inside an object of another color"),
      tr("Pixels of colored classes that are close to another class, or to none"),
      tr("Pixels of areas of one color that cover more of the image than an object could")};
  return role == Qt::ToolTipRole ? QVariant(tips[section])
                                 : TitledModel::headerData(section, orientation, role);
}

}  // namespace widgets
