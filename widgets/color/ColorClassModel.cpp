// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorClassModel.h"

#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPixmap>

namespace widgets {
namespace {

constexpr int kSwatchSide = 32;  // pixels; views scale it down

QString percent(double share) {
  return QStringLiteral("%1 %").arg(100 * share, 0, 'f', 1);
}

}  // namespace

QIcon untinted(const QPixmap& pixmap) {
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

QIcon swatch(const QColor& color) {
  QPixmap pixmap(kSwatchSide, kSwatchSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  // A gray edge separates white and black from light and dark backgrounds.
  painter.setPen(QPen(QColor(128, 128, 128), 2));
  painter.setBrush(color.isValid() ? QBrush(color) : QBrush(Qt::NoBrush));
  const QRectF square(3, 3, kSwatchSide - 6, kSwatchSide - 6);
  painter.drawRoundedRect(square, 5, 5);
  if (!color.isValid()) painter.drawLine(square.bottomLeft(), square.topRight());
  return untinted(pixmap);
}

ColorClassModel::ColorClassModel(QObject* parent)
    : RowModel({tr("Class"), tr("Key"), tr("Strokes"), tr("Pixels"), tr("Recall")}, parent) {}

void ColorClassModel::setSamples(const colortool::Samples& samples) {
  std::vector<ColorClassRow> rows(static_cast<std::size_t>(samples.classes.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto number = static_cast<int>(i);
    const robotlink::Rgb rgb = samples.classes.shownColor(number);
    rows[i].name = number == 0 ? tr("background") : QString::fromStdString(samples.classes.name(number));
    if (number > 0) rows[i].color = QColor(rgb.r, rgb.g, rgb.b);
    if (rows.size() == rows_.size()) rows[i].recall = rows_[i].recall;
  }
  for (const colortool::StrokePtr& stroke : samples.strokes) {
    ColorClassRow& row = rows[stroke->colorClass];
    ++row.strokes;
    row.pixels += static_cast<qint64>(stroke->colors.size());
  }
  setRows(std::move(rows));
}

void ColorClassModel::setRecalls(const std::vector<std::optional<double>>& recalls) {
  std::vector<ColorClassRow> rows = rows_;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].recall = i < recalls.size() ? recalls[i] : std::nullopt;
  setRows(std::move(rows));
}

void ColorClassModel::setRows(std::vector<ColorClassRow> rows) {
  if (rows != rows_) replaceRows(std::move(rows), [](const auto&, const auto&) { return true; });
}

QVariant ColorClassModel::text(const ColorClassRow& row, int column, int number) const {
  switch (column) {
    case kName:
      return row.name;
    case kKey:
      return number <= 9 ? QVariant(QString::number(number)) : QVariant();
    case kStrokes:
      return row.strokes;
    case kPixels:
      return QLocale().toString(row.pixels);
    default:
      return row.recall ? percent(*row.recall) : QStringLiteral("–");
  }
}

QVariant ColorClassModel::toolTip(const QModelIndex& index) const {
  const ColorClassRow& at = row(index.row());
  switch (index.column()) {
    case kName:
      return index.row() == 0
                 ? tr("Pixels without a class. Strokes of the background keep the classes separate from it.")
                 : tr("Click on the color to change it; F2 or a double click edits the name");
    case kRecall:
      return at.recall ? tr("Percentage of its strokes' pixels that the other strokes find")
                       : tr("Not known: a class needs two strokes, to test one against the other");
    default:
      return {};
  }
}

QVariant ColorClassModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ColorClassRow& at = row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(at, index.column(), index.row());
    case Qt::EditRole:
      return index.column() == kName ? QVariant(at.name) : text(at, index.column(), index.row());
    case Qt::DecorationRole:
      return index.column() == kName ? QVariant(swatch(at.color)) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == kName
                 ? QVariant()
                 : QVariant(
                       int((index.column() == kKey ? Qt::AlignHCenter : Qt::AlignRight) | Qt::AlignVCenter));
    case Qt::ToolTipRole:
      return toolTip(index);
    case kShareRole:
      return index.column() == kRecall && at.recall ? QVariant(*at.recall) : QVariant();
    default:
      return {};
  }
}

bool ColorClassModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
  const QString name = value.toString().trimmed();
  if (name == row(index.row()).name) return false;
  Q_EMIT renameWanted(index.row(), name);
  return true;
}

Qt::ItemFlags ColorClassModel::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  return index.column() == kName && index.row() > 0 ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace widgets
