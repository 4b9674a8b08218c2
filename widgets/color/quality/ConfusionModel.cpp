// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ConfusionModel.h"

#include <QIcon>
#include <QLocale>
#include <algorithm>

#include "colortool/training/Suspicion.h"
#include "widgets/Counted.h"
#include "widgets/color/ColorClassModel.h"

namespace widgets {
namespace {

QString percentOf(double share) {
  // A small share is not shown as 0.
  return share > 0 && share < 0.0005 ? QStringLiteral("< 0.1")
                                     : QStringLiteral("%1").arg(100 * share, 0, 'f', 1);
}

}  // namespace

void ConfusionModel::setEvaluation(const colortool::ColorClasses& classes,
                                   std::optional<colortool::Evaluation> evaluation,
                                   std::vector<std::uint8_t> alone) {
  beginResetModel();
  classes_ = classes;
  evaluation_ = std::move(evaluation);
  alone_ = std::move(alone);
  rows_.clear();
  columns_.clear();
  for (int i = 0; evaluation_ && i < std::min(classes_.size(), evaluation_->classes()); ++i) {
    std::uint64_t found = 0;
    for (int label = 0; label < evaluation_->classes(); ++label) found += evaluation_->count(label, i);
    if (evaluation_->labeled(i) > 0) rows_.push_back(i);
    if (evaluation_->labeled(i) > 0 || found > 0) columns_.push_back(i);
  }
  endResetModel();
}

bool ConfusionModel::isAlone(int colorClass) const {
  return std::ranges::find(alone_, colorClass) != alone_.end();
}

std::optional<double> ConfusionModel::meanRecall() const {
  double sum = 0;
  int count = 0;
  for (const int label : rows_) {
    if (label == 0 || isAlone(label)) continue;
    sum += evaluation_->recall(label);
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<double> ConfusionModel::falseColors() const {
  if (!evaluation_ || evaluation_->labeled(0) == 0 || isAlone(0)) return std::nullopt;
  const std::vector<bool> things = colortool::objectClasses(classes_);
  std::vector<std::uint8_t> numbers;
  for (std::size_t i = 1; i < things.size(); ++i) {
    if (things[i]) numbers.push_back(static_cast<std::uint8_t>(i));
  }
  return evaluation_->falseColor(numbers);
}

int ConfusionModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ConfusionModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || columns_.empty() ? 0 : static_cast<int>(columns_.size()) + 1;
}

double ConfusionModel::share(int label, int found) const {
  return static_cast<double>(evaluation_->count(label, found)) /
         static_cast<double>(evaluation_->labeled(label));
}

QString ConfusionModel::nameOf(int colorClass) const {
  return colorClass == 0 ? tr("background") : QString::fromStdString(classes_.name(colorClass));
}

QVariant ConfusionModel::toolTip(int label, int found) const {
  const QLocale locale;
  return tr("%1 of %2 of %3: found to be %4")
      .arg(locale.toString(static_cast<qulonglong>(evaluation_->count(label, found))),
           counted(evaluation_->labeled(label), tr("1 pixel"), tr("%1 pixels")), nameOf(label),
           found == 0 ? tr("of no class") : nameOf(found));
}

QVariant ConfusionModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const int label = rows_[static_cast<std::size_t>(index.row())];
  const bool isRecall = index.column() == 0;
  const int found = isRecall ? label : columns_[static_cast<std::size_t>(index.column() - 1)];
  const bool unknown = isAlone(label);
  switch (role) {
    case Qt::DisplayRole:
      if (unknown) return isRecall ? QVariant(QStringLiteral("–")) : QVariant();
      if (isRecall) return percentOf(share(label, label)) + QStringLiteral(" %");
      return evaluation_->count(label, found) > 0 ? QVariant(percentOf(share(label, found))) : QVariant();
    case Qt::ToolTipRole:
      return unknown ? QVariant(tr("A second stroke of %1 is needed, to test one against the other")
                                    .arg(nameOf(label)))
                     : toolTip(label, found);
    case Qt::TextAlignmentRole:
      return int(Qt::AlignRight | Qt::AlignVCenter);
    case kShareRole:
      return unknown || isRecall ? QVariant() : QVariant(share(label, found));
    case kRightRole:
      return label == found;
    default:
      return {};
  }
}

QVariant ConfusionModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const bool isRow = orientation == Qt::Vertical;
  if (!isRow && section == 0) return role == Qt::DisplayRole ? QVariant(tr("Recall")) : QVariant();
  const std::size_t at = static_cast<std::size_t>(isRow ? section : section - 1);
  const auto& classes = isRow ? rows_ : columns_;
  if (at >= classes.size()) return {};
  const int colorClass = classes[at];
  const robotlink::Rgb rgb = classes_.shownColor(colorClass);
  switch (role) {
    case Qt::DisplayRole:
      return isRow || colorClass != 0 ? nameOf(colorClass) : tr("none");
    case Qt::DecorationRole:
      return swatch(colorClass == 0 ? QColor() : QColor(rgb.r, rgb.g, rgb.b));
    case Qt::ToolTipRole:
      return isRow ? tr("Pixels that are %1").arg(nameOf(colorClass))
                   : tr("Found to be %1").arg(nameOf(colorClass));
    default:
      return {};
  }
}

}  // namespace widgets
