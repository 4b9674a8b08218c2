// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/SparklineDelegate.h"

#include <QPainter>
#include <algorithm>

#include "robotlink/base/Geometry.h"
#include "widgets/Theme.h"
#include "widgets/joints/JointsModel.h"

namespace widgets {
namespace {

/// Movements smaller than this fill only a part of the height, so that noise does not look like motion.
constexpr double kMinSparkRange = robotlink::radians(5);

}  // namespace

void SparklineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const auto& history = model_.row(index.row()).history;
  if (history.size() < 2) return;
  const auto [low, high] = std::ranges::minmax(history);
  const double middle = (low + high) / 2, range = std::max(high - low, kMinSparkRange);
  const QRectF room = QRectF(option.rect).adjusted(3, 3, -3, -3);
  QPolygonF curve;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(history.size() - 1);
    curve << QPointF(room.left() + x * room.width(),
                     room.center().y() - (history[i] - middle) / range * room.height());
  }
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setClipRect(option.rect);
  painter->setPen(QPen(colorOf(Meaning::kNote, option.palette), 1.2));
  painter->drawPolyline(curve);
  painter->restore();
}

}  // namespace widgets
