// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/TableDifferenceModel.h"

#include <QColor>
#include <QFont>
#include <algorithm>

namespace widgets {
namespace {

using Change = colortool::TableDifference::Change;
constexpr int kPartnersShown = 3;

bool isNumber(int column) {
  using Model = TableDifferenceModel;
  return column == Model::kBefore || column == Model::kAfter || column == Model::kGained ||
         column == Model::kLost;
}

}  // namespace

TableDifferenceModel::TableDifferenceModel(QObject* parent)
    : TitledModel({tr("Class"), tr("Gained"), tr("from"), tr("Lost"), tr("to"), tr("Before"), tr("Now")},
                  parent) {}

void TableDifferenceModel::setDifference(std::shared_ptr<const colortool::TableDifference> difference) {
  const bool same = difference && difference_ && difference->classes() == difference_->classes();
  if (!same) beginResetModel();
  difference_ = std::move(difference);
  same ? announceRows() : endResetModel();
}

std::optional<int> TableDifferenceModel::classOf(int row) const {
  const int classes = difference_->classes().size();
  if (row >= classes) return std::nullopt;
  return (row + 1) % classes;
}

colortool::CellSet TableDifferenceModel::cellsOf(const QModelIndex& index) const {
  if (!index.isValid() || !difference_) return {};
  const auto colorClass = classOf(index.row());
  if (!colorClass) return difference_->cells();
  const int column = index.column();
  const Change change = column == kGained || column == kFrom ? Change::kGained
                        : column == kLost || column == kTo   ? Change::kLost
                                                             : Change::kAny;
  return difference_->cells(*colorClass, change);
}

int TableDifferenceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !difference_ ? 0 : difference_->classes().size() + 1;
}

QString TableDifferenceModel::partners(int colorClass, bool gained, int atMost) const {
  std::vector<std::pair<std::uint64_t, int>> counts;
  for (int other = 0; other < difference_->classes().size(); ++other) {
    if (other == colorClass) continue;
    const auto count = gained ? difference_->count(other, colorClass) : difference_->count(colorClass, other);
    if (count > 0) counts.emplace_back(count, other);
  }
  std::ranges::sort(counts, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  QStringList texts;
  for (const auto& [count, other] : counts) {
    if (texts.size() == atMost) {
      texts << QStringLiteral("…");
      break;
    }
    texts
        << QStringLiteral("%1 %2").arg(QString::fromStdString(difference_->classes().name(other))).arg(count);
  }
  return texts.join(QStringLiteral(", "));
}

QString TableDifferenceModel::text(int row, int column) const {
  const auto colorClass = classOf(row);
  if (!colorClass) {
    if (column == kClass) return tr("all changes");
    return column == kGained || column == kLost ? QString::number(difference_->changed()) : QString();
  }
  const auto sum = difference_->ofClass(*colorClass);
  switch (column) {
    case kClass:
      return QString::fromStdString(difference_->classes().name(*colorClass));
    case kBefore:
      return QString::number(sum.before);
    case kAfter:
      return QString::number(sum.after);
    case kGained:
      return QString::number(sum.gained);
    case kLost:
      return QString::number(sum.lost);
    case kFrom:
      return partners(*colorClass, true, kPartnersShown);
    case kTo:
      return partners(*colorClass, false, kPartnersShown);
    default:
      return {};
  }
}

QVariant TableDifferenceModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !difference_) return {};
  const auto colorClass = classOf(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(index.row(), index.column());
    case Qt::ToolTipRole:
      if (colorClass && (index.column() == kFrom || index.column() == kTo))
        return partners(*colorClass, index.column() == kFrom, 255);
      return tr("A click selects the cells that changed");
    case Qt::DecorationRole:
      if (index.column() == kClass && colorClass.value_or(0) != 0) {
        const robotlink::Rgb shown = difference_->classes().shownColor(*colorClass);
        return QColor(shown.r, shown.g, shown.b);
      }
      return {};
    case Qt::TextAlignmentRole:
      return QVariant::fromValue<int>(Qt::AlignVCenter |
                                      (isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::FontRole:
      if (!colorClass) {
        QFont font;
        font.setBold(true);
        return font;
      }
      return {};
    default:
      return {};
  }
}

QVariant TableDifferenceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue<int>(Qt::AlignVCenter | (isNumber(section) ? Qt::AlignRight : Qt::AlignLeft));
  const QString tips[] = {tr("Class of colors"),
                          tr("Cells that have this class now and did not before"),
                          tr("What they were"),
                          tr("Cells that had this class before and do not now"),
                          tr("What they are"),
                          tr("Cells that have this class in the reference table"),
                          tr("Cells that have this class now")};
  return role == Qt::ToolTipRole ? QVariant(tips[section])
                                 : TitledModel::headerData(section, orientation, role);
}

}  // namespace widgets
