// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/StrokeModel.h"

#include <QIcon>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

#include "widgets/color/ColorClassModel.h"

namespace widgets {
namespace {

constexpr int kPictureSide = 32;

/// The stroke's thumbnail, with a bar in the color of its class next to it.
QIcon picture(const colortool::Thumbnail& thumbnail, const QColor& color) {
  QPixmap pixmap(kPictureSide + 6, kPictureSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  if (thumbnail.width > 0 && thumbnail.height > 0) {
    const QImage image(reinterpret_cast<const uchar*>(thumbnail.pixels.data()), thumbnail.width,
                       thumbnail.height, 3 * thumbnail.width, QImage::Format_RGB888);
    painter.drawImage(QRect(0, 0, kPictureSide, kPictureSide), image);
  }
  if (color.isValid()) painter.fillRect(kPictureSide + 1, 0, 5, kPictureSide, color);
  return untinted(pixmap);
}

bool sameIds(const std::vector<colortool::StrokePtr>& a, const std::vector<colortool::StrokePtr>& b,
             std::size_t count) {
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin(),
                    [](const auto& x, const auto& y) { return x->id == y->id; });
}

}  // namespace

StrokeModel::StrokeModel(QObject* parent)
    : TitledModel({tr("Class"), tr("Not"), tr("Weight"), tr("Right"), tr("Tool"), tr("Pixels"), tr("Image"),
                   tr("Camera"), tr("Lighting")},
                  parent) {}

void StrokeModel::setSamples(const colortool::Samples& samples) {
  const std::size_t before = samples_.strokes.size(), after = samples.strokes.size(),
                    same = std::min(before, after);
  const auto last = [](std::size_t count) { return static_cast<int>(count) - 1; };
  if (!sameIds(samples_.strokes, samples.strokes, same)) {
    beginResetModel();
    samples_ = samples;
    return endResetModel();
  }
  // Most changes append a stroke or remove the last one.
  if (after > before) {
    beginInsertRows({}, static_cast<int>(before), last(after));
    samples_ = samples;
    endInsertRows();
  } else if (after < before) {
    beginRemoveRows({}, static_cast<int>(after), last(before));
    samples_ = samples;
    endRemoveRows();
  } else {
    samples_ = samples;
  }
  if (same > 0) Q_EMIT dataChanged(index(0, 0), index(last(same), kColumns - 1));
}

void StrokeModel::setRight(std::unordered_map<std::uint64_t, double> right) {
  right_ = std::move(right);
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, kRight), index(rowCount() - 1, kRight));
}

int StrokeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(samples_.strokes.size());
}

std::optional<double> StrokeModel::right(const colortool::Stroke& stroke) const {
  const auto found = right_.find(stroke.id);
  return found == right_.end() ? std::nullopt : std::optional(found->second);
}

QString StrokeModel::className(const colortool::Stroke& stroke) const {
  return stroke.colorClass == colortool::ColorClasses::kNone
             ? tr("background")
             : QString::fromStdString(samples_.classes.name(stroke.colorClass));
}

QVariant StrokeModel::text(const colortool::Stroke& stroke, int column) const {
  const colortool::SampleImage* image = samples_.image(stroke.image);
  switch (column) {
    case kClass:
      return className(stroke);
    case kWeight:
      return stroke.weight;
    case kRight:
      return right(stroke) ? QStringLiteral("%1 %").arg(100 * *right(stroke), 0, 'f', 0)
                           : QStringLiteral("–");
    case kTool:
      return QString::fromStdString(stroke.tool);
    case kPixels:
      return static_cast<qulonglong>(stroke.colors.size());
    case kImage:
      return QString::fromStdString(image->name).section(QStringLiteral(" ["), 0, 0);
    case kCamera:
      return QString::fromStdString(image->camera);
    case kLighting:
      return QString::fromStdString(image->lighting);
    default:
      return {};
  }
}

QVariant StrokeModel::sortKey(const colortool::Stroke& stroke, int column) const {
  switch (column) {
    case kClass:
      // Strokes of a class are in the order in which they were made.
      return stroke.colorClass * 1e9 + static_cast<double>(stroke.id);
    case kMustNotBe:
      return stroke.mustNotBe ? 0 : 1;
    case kRight:
      return right(stroke).value_or(2);  // unknown shares come last
    default:
      return text(stroke, column);
  }
}

QVariant StrokeModel::toolTip(const colortool::Stroke& stroke, int column) const {
  const auto share = right(stroke);
  if (column == kRight)
    return share ? tr("Share of its pixels that a table without this stroke classifies correctly")
                 : tr("Not known: it needs a second stroke of its class for comparison");
  if (column == kImage || column == kClass)
    return tr("A double click shows the image %1")
        .arg(QString::fromStdString(samples_.image(stroke.image)->name));
  return {};
}

QVariant StrokeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const colortool::Stroke& at = stroke(index.row());
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(at, column);
    case Qt::DecorationRole: {
      if (column != kClass) return {};
      const robotlink::Rgb rgb = samples_.classes.shownColor(at.colorClass);
      return picture(at.thumbnail, at.colorClass == 0 ? QColor() : QColor(rgb.r, rgb.g, rgb.b));
    }
    case Qt::CheckStateRole:
      return column == kMustNotBe ? QVariant(at.mustNotBe ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::TextAlignmentRole:
      return column == kWeight || column == kPixels || column == kRight
                 ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter))
                 : QVariant();
    case Qt::ToolTipRole:
      return toolTip(at, column);
    case kSortRole:
      return sortKey(at, column);
    case kShareRole:
      return column == kRight && right(at) ? QVariant(*right(at)) : QVariant();
    default:
      return {};
  }
}

bool StrokeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid()) return false;
  const std::uint64_t id = stroke(index.row()).id;
  if (role == Qt::CheckStateRole && index.column() == kMustNotBe) {
    Q_EMIT mustNotBeWanted(id, value.toInt() == Qt::Checked);
    return true;
  }
  if (role != Qt::EditRole || value == data(index, Qt::EditRole)) return false;
  if (index.column() == kWeight) {
    Q_EMIT weightWanted(id, value.toDouble());
  } else if (index.column() == kLighting) {
    Q_EMIT lightingWanted(id, value.toString().trimmed());
  } else {
    return false;
  }
  return true;
}

Qt::ItemFlags StrokeModel::flags(const QModelIndex& index) const {
  auto flags = QAbstractTableModel::flags(index);
  if (!index.isValid()) return flags;
  if (index.column() == kWeight || index.column() == kLighting) flags |= Qt::ItemIsEditable;
  if (index.column() == kMustNotBe && stroke(index.row()).colorClass != colortool::ColorClasses::kNone)
    flags |= Qt::ItemIsUserCheckable;
  return flags;
}

}  // namespace widgets
