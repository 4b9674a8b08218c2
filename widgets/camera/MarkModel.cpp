// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/MarkModel.h"

#include <QJsonArray>
#include <algorithm>

namespace widgets {

MarkModel::MarkModel(QObject* parent)
    : RowModel({tr("Mark"), tr("Place, m"), tr("Pixel"), tr("Error, px")}, parent) {}

void MarkModel::setMarks(std::vector<FieldMark> marks) {
  const QJsonObject clicked = save();
  std::vector<PickedMark> rows;
  for (FieldMark& mark : marks) rows.push_back({std::move(mark)});
  replaceRows(std::move(rows), [](const PickedMark&, const PickedMark&) { return false; });
  restore(clicked);
}

void MarkModel::pick(int row, const std::optional<QPointF>& pixel) {
  if (row < 0 || row >= rowCount()) return;
  rows_[static_cast<std::size_t>(row)].pixel = pixel;
  setErrors({});
}

void MarkModel::clear() {
  for (PickedMark& mark : rows_) mark.pixel.reset();
  setErrors({});
}

void MarkModel::setErrors(const std::vector<double>& errors) {
  const auto picked = std::ranges::count_if(rows_, [](const auto& mark) { return mark.pixel.has_value(); });
  const bool areKnown = errors.size() == static_cast<std::size_t>(picked);
  std::size_t next = 0;
  for (PickedMark& mark : rows_) {
    const bool isKnown = areKnown && mark.pixel;
    mark.error = isKnown ? std::optional(errors[next++]) : std::nullopt;
  }
  announceRows();
}

int MarkModel::nextFree(int row) const {
  for (int i = 1; i <= rowCount(); ++i) {
    const int next = (row + i) % rowCount();
    if (!rows_[static_cast<std::size_t>(next)].pixel) return next;
  }
  return -1;
}

QJsonObject MarkModel::save() const {
  if (rows_.empty()) return saved_;
  QJsonObject state;
  for (const PickedMark& mark : rows_)
    if (mark.pixel) state[mark.mark.name()] = QJsonArray{mark.pixel->x(), mark.pixel->y()};
  return state;
}

void MarkModel::restore(const QJsonObject& state) {
  saved_ = state;
  for (PickedMark& mark : rows_) {
    const QJsonArray pixel = state[mark.mark.name()].toArray();
    mark.pixel =
        pixel.size() == 2 ? std::optional(QPointF(pixel[0].toDouble(), pixel[1].toDouble())) : std::nullopt;
  }
  setErrors({});
}

QVariant MarkModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const PickedMark& mark = row(index.row());
  if (role == Qt::TextAlignmentRole) return index.column() == kKind ? QVariant() : QVariant(kNumberAlignment);
  if (role == Qt::ToolTipRole) return mark.mark.name();
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kKind:
      return mark.mark.kind;
    case kPlace:
      return mark.mark.placeText();
    case kPixel:
      return mark.pixel
                 ? QStringLiteral("%1, %2").arg(mark.pixel->x(), 0, 'f', 0).arg(mark.pixel->y(), 0, 'f', 0)
                 : QString();
    default:
      return mark.error ? QString::number(*mark.error, 'f', 2) : QString();
  }
}

}  // namespace widgets
