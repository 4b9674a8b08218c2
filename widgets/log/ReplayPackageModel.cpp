// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayPackageModel.h"

#include <QFont>
#include <QGuiApplication>
#include <algorithm>

#include "widgets/Theme.h"
#include "widgets/log/TimeScale.h"

namespace widgets {

using robotcontrol::ControlReplay;

namespace {

bool differs(const robotcontrol::ReplayStatus::Difference& difference) {
  return difference.different() > 0 || difference.only_logged() > 0 || difference.only_recomputed() > 0;
}

}  // namespace

ReplayPackageModel::ReplayPackageModel(QObject* parent)
    : TitledModel(
          {tr("Package"), tr("Source"), tr("Compared"), tr("Different"), tr("First [s]"), tr("Largest")},
          parent) {}

void ReplayPackageModel::setStatus(const robotcontrol::ReplayStatus& status, robotlink::Instant origin) {
  const bool sameOrigin = std::exchange(origin_, origin) == origin;
  std::vector<Row> rows;
  for (const auto& package : status.packages()) {
    Row row{package, {}, {}};
    for (const auto& difference : status.differences()) {
      if (difference.package() == package.package()) row.difference = difference;
    }
    row.bytes = package.SerializeAsString() + row.difference.SerializeAsString();
    rows.push_back(std::move(row));
  }
  const auto samePackage = [](const Row& a, const Row& b) {
    return a.package.package() == b.package.package();
  };
  if (!std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(), samePackage)) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (sameOrigin && rows[i].bytes == rows_[i].bytes) continue;
    rows_[i] = std::move(rows[i]);
    Q_EMIT dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), kColumns - 1));
  }
}

QString ReplayPackageModel::packageName(int row) const {
  return QString::fromStdString(at(row).package.package());
}

bool ReplayPackageModel::allows(int row, Source source) const {
  if (source == ControlReplay::AS_LOGGED) return at(row).package.logged();
  if (source == ControlReplay::RECOMPUTED) return at(row).package.can_recompute();
  return true;
}

QString ReplayPackageModel::reason(int row, Source source) const {
  if (source == ControlReplay::AS_LOGGED && !at(row).package.logged()) return tr("the log does not hold it");
  if (source == ControlReplay::RECOMPUTED && !at(row).package.can_recompute()) {
    const QString why = QString::fromStdString(at(row).package.why_not());
    return why.isEmpty() ? tr("no task of the program produces it") : why;
  }
  return {};
}

QString ReplayPackageModel::sourceName(Source source) {
  switch (source) {
    case ControlReplay::AS_LOGGED:
      return tr("as logged");
    case ControlReplay::RECOMPUTED:
      return tr("recomputed");
    default:
      return tr("automatic");
  }
}

int ReplayPackageModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString ReplayPackageModel::shownTime(std::int64_t ns) const {
  return timeText(robotlink::Instant(robotlink::Duration(ns)) - origin_);
}

QVariant ReplayPackageModel::text(const Row& row, int column) const {
  const auto& difference = row.difference;
  const bool compared = difference.compared() > 0 || differs(difference);
  const QString none = QStringLiteral("–");
  switch (column) {
    case kPackage:
      return QString::fromStdString(row.package.package());
    case kSource: {
      const auto source = row.package.source();
      const bool there =
          source == ControlReplay::RECOMPUTED ? row.package.can_recompute() : row.package.logged();
      if (!there) return tr("not available");
      return row.package.chosen() ? sourceName(source) : tr("%1 (automatic)").arg(sourceName(source));
    }
    case kCompared:
      return compared ? QString::number(difference.compared()) : none;
    case kDifferent: {
      if (!compared) return none;
      const auto lone = difference.only_logged() + difference.only_recomputed();
      return lone > 0 ? tr("%1 + %2 alone").arg(difference.different()).arg(lone)
                      : QString::number(difference.different());
    }
    case kFirst:
      return differs(difference) ? shownTime(difference.first_time()) : none;
    default:
      if (difference.largest_field().empty()) return none;
      return QStringLiteral("%1: %2")
          .arg(QString::fromStdString(difference.largest_field()))
          .arg(difference.largest(), 0, 'g', 4);
  }
}

QVariant ReplayPackageModel::sortKey(const Row& row, int column) const {
  switch (column) {
    case kCompared:
      return qulonglong{row.difference.compared()};
    case kDifferent:
      return qulonglong{row.difference.different() + row.difference.only_logged() +
                        row.difference.only_recomputed()};
    case kFirst:
      return qlonglong{row.difference.first_time()};
    case kLargest:
      return row.difference.largest();
    default:
      return text(row, column);
  }
}

QVariant ReplayPackageModel::toolTip(const Row& row, int column) const {
  const auto& difference = row.difference;
  switch (column) {
    case kSource:
      if (!row.package.can_recompute() && !row.package.why_not().empty()) {
        return tr("It cannot be recomputed: %1").arg(QString::fromStdString(row.package.why_not()));
      }
      return tr("Double click: choose where it comes from");
    case kDifferent:
      return tr("%1 differ, %2 were only logged, %3 are only recomputed, of %4 compared")
          .arg(difference.different())
          .arg(difference.only_logged())
          .arg(difference.only_recomputed())
          .arg(difference.compared());
    case kFirst:
      return tr("Double click: go to the first difference");
    case kLargest:
      if (difference.largest_field().empty()) return {};
      return tr("At %1 s. Double click: go there").arg(shownTime(difference.largest_time()));
    default:
      return {};
  }
}

QVariant ReplayPackageModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = at(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case kSortRole:
      return sortKey(row, index.column());
    case Qt::ToolTipRole:
      return toolTip(row, index.column());
    case Qt::EditRole:
    case kChoiceRole:
      return static_cast<int>(row.package.chosen() ? row.package.source() : ControlReplay::AUTOMATIC);
    case kFirstRole:
      return differs(row.difference) ? QVariant(qlonglong{row.difference.first_time()}) : QVariant();
    case kLargestRole:
      return row.difference.largest_field().empty() ? QVariant()
                                                    : QVariant(qlonglong{row.difference.largest_time()});
    case Qt::TextAlignmentRole:
      return index.column() >= kCompared && index.column() <= kFirst ? QVariant(kNumberAlignment)
                                                                     : QVariant();
    case Qt::ForegroundRole: {
      const QPalette palette = QGuiApplication::palette();
      if (index.column() == kDifferent && differs(row.difference)) return colorOf(Meaning::kWarning, palette);
      if (!row.package.logged() && !row.package.can_recompute()) return colorOf(Meaning::kMuted, palette);
      return {};
    }
    case Qt::FontRole: {
      if (index.column() != kSource || !row.package.chosen()) return {};
      QFont font;
      font.setBold(true);
      return font;
    }
    default:
      return {};
  }
}

bool ReplayPackageModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != kSource || (role != Qt::EditRole && role != kChoiceRole))
    return false;
  const auto source = static_cast<Source>(value.toInt());
  if (!allows(index.row(), source)) return false;
  Q_EMIT sourceWanted(packageName(index.row()), source);
  return true;
}

Qt::ItemFlags ReplayPackageModel::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  return index.column() == kSource ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace widgets
