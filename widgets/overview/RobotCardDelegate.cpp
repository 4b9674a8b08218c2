// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotCardDelegate.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "widgets/overview/RobotCardModel.h"

namespace widgets {
namespace {

constexpr int kCardMargin = 4, kCardPadding = 8, kTeamStripe = 6;
constexpr int kMaxCardWidth = 560;
constexpr double kCardAspect = 4.0 / 3;  // of images
/// Lines of text on a card: name, state, behavior, battery, link.
constexpr int kCardLines = 5;

int lineHeight(const QFontMetrics& font) {
  return font.height() + 3;
}

int minCardWidth(const QFontMetrics& font) {
  return font.averageCharWidth() * 24;
}

/// Whether the image is next to the texts.
bool isBeside(QSize card) {
  return card.width() > card.height() * 1.7;
}

/// The height of the image on a card of a size.
double imageHeight(QSize card, const QFontMetrics& font) {
  const double width = card.width() - 2 * (kCardMargin + kCardPadding);
  const double height = card.height() - 2 * (kCardMargin + kCardPadding);
  if (isBeside(card)) return std::min(height, (width - minCardWidth(font)) / kCardAspect);
  return std::min(height - kCardLines * lineHeight(font), width / kCardAspect);
}

/// The arguments of the functions below.
struct CardSheet {
  QPainter& painter;
  const QStyleOptionViewItem& option;
  const RobotCard& card;

  QColor text() const { return option.palette.color(QPalette::Text); }
  QString elided(const QString& of, double width) const {
    return painter.fontMetrics().elidedText(of, Qt::ElideRight, static_cast<int>(width));
  }
  void line(const QRectF& rect, const CardText& of) const {
    painter.setPen(of.meaning == Meaning::kMuted ? colorOf(Meaning::kMuted, option.palette) : text());
    painter.drawText(rect, Qt::AlignLeft | Qt::AlignVCenter, elided(of.text, rect.width()));
  }
};

void paintCardFrame(const CardSheet& sheet, const QRectF& rect) {
  const QPalette& palette = sheet.option.palette;
  const bool isSelected = sheet.card.isSelected;
  QPainterPath frame;
  frame.addRoundedRect(rect, 5, 5);
  QColor fill = palette.color(QPalette::Base);
  if (isSelected) fill = mixed(fill, palette.color(QPalette::Highlight), 0.14);
  if ((sheet.option.state & QStyle::State_MouseOver) != 0) fill = mixed(fill, sheet.text(), 0.05);
  sheet.painter.fillPath(frame, fill);
  sheet.painter.save();
  sheet.painter.setClipPath(frame);
  sheet.painter.fillRect(QRectF(rect.left(), rect.top(), kTeamStripe, rect.height()), sheet.card.color);
  sheet.painter.restore();
  const QColor line = isSelected ? palette.color(QPalette::Highlight) : mixed(fill, sheet.text(), 0.25);
  sheet.painter.setPen(QPen(line, isSelected ? 2 : 1));
  sheet.painter.drawPath(frame);
}

void paintCardImage(const CardSheet& sheet, const QRectF& room) {
  if (room.width() < 20 || room.height() < 20) return;
  QPainter& painter = sheet.painter;
  if (sheet.card.image.isNull()) {
    painter.fillRect(room, mixed(sheet.option.palette.color(QPalette::Base), sheet.text(), 0.06));
    painter.setPen(colorOf(Meaning::kMuted, sheet.option.palette));
    painter.drawText(room.adjusted(4, 4, -4, -4), Qt::AlignCenter | Qt::TextWordWrap, sheet.card.noImage);
    return;
  }
  const QSizeF size = QSizeF(sheet.card.image.size()).scaled(room.size(), Qt::KeepAspectRatio);
  QRectF picture(QPointF(), size);
  picture.moveCenter(room.center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(picture, sheet.card.image);
}

void paintCardName(const CardSheet& sheet, const QRectF& rect) {
  QPainter& painter = sheet.painter;
  const QString name = QString::fromStdString(sheet.card.robot);
  const QFont usual = painter.font();
  QFont bold = usual;
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(sheet.text());
  painter.drawText(rect, Qt::AlignLeft | Qt::AlignVCenter, sheet.elided(name, rect.width()));
  const int width = painter.fontMetrics().horizontalAdvance(name + QStringLiteral("  "));
  painter.setFont(usual);
  painter.setPen(colorOf(Meaning::kMuted, sheet.option.palette));
  const QRectF beside = rect.adjusted(width, 0, 0, 0);
  if (beside.width() > 30)
    painter.drawText(beside, Qt::AlignLeft | Qt::AlignVCenter, sheet.elided(sheet.card.kind, beside.width()));
}

/// A line with a dot in the color of its meaning; the text has the meaning, too.
void paintDotted(const CardSheet& sheet, const QRectF& rect, const CardText& text) {
  if (text.text.isEmpty()) return;
  const double size = 8;
  sheet.painter.setPen(Qt::NoPen);
  sheet.painter.setBrush(colorOf(text.meaning, sheet.option.palette));
  sheet.painter.drawEllipse(QRectF(rect.left(), rect.center().y() - size / 2, size, size));
  sheet.painter.setBrush(Qt::NoBrush);
  sheet.line(rect.adjusted(size + 6, 0, 0, 0), text);
}

void paintCardTexts(const CardSheet& sheet, QRectF rect) {
  const int height = lineHeight(sheet.painter.fontMetrics());
  const auto next = [&rect, height] {
    const QRectF line(rect.left(), rect.top(), rect.width(), height);
    rect.setTop(rect.top() + height);
    return line;
  };
  paintCardName(sheet, next());
  paintDotted(sheet, next(), sheet.card.state);
  sheet.line(next(), sheet.card.behavior);
  paintDotted(sheet, next(), sheet.card.link);
  if (sheet.card.battery.state != BatteryLevel::State::kUnknown)
    BatteryGauge::paint(sheet.painter, next(), sheet.card.battery, sheet.option.palette);
}

}  // namespace

QSize RobotCardDelegate::sizeFor(int cards, QSize room, const QFontMetrics& font) {
  const int minWidth = minCardWidth(font) + 2 * (kCardMargin + kCardPadding);
  const int minHeight = kCardLines * lineHeight(font) + 2 * (kCardMargin + kCardPadding);
  QSize best(std::clamp(room.width(), minWidth, kMaxCardWidth), minHeight);
  double largest = -1;
  for (int columns = 1; columns <= std::max(1, cards); ++columns) {
    const int rows = (std::max(1, cards) + columns - 1) / columns;
    const QSize size(std::min(kMaxCardWidth, room.width() / columns), room.height() / rows);
    if (size.width() < minWidth || size.height() < minHeight) continue;
    if (const double height = imageHeight(size, font); height > largest) {
      largest = height;
      best = size;
    }
  }
  // A card is no higher than its image and texts need.
  const int needed = kCardLines * lineHeight(font) + 2 * (kCardMargin + kCardPadding) +
                     static_cast<int>(best.width() / kCardAspect);
  return {best.width(), std::min(best.height(), needed)};
}

bool RobotCardDelegate::fit(int cards, QSize room, const QFontMetrics& font) {
  const QSize size = sizeFor(cards, room, font);
  return std::exchange(size_, size) != size;
}

void RobotCardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  const CardSheet sheet{*painter, option, model_.row(index.row())};
  const QRectF rect = QRectF(option.rect).adjusted(kCardMargin, kCardMargin, -kCardMargin, -kCardMargin);
  paintCardFrame(sheet, rect);
  const QRectF inside =
      rect.adjusted(kCardPadding + kTeamStripe / 2, kCardPadding, -kCardPadding, -kCardPadding);
  const double height = imageHeight(option.rect.size(), painter->fontMetrics());
  if (isBeside(option.rect.size())) {
    const double width = height * kCardAspect;
    paintCardImage(sheet, {inside.left(), inside.top(), width, height});
    paintCardTexts(sheet, inside.adjusted(width + kCardPadding, 0, 0, 0));
  } else {
    const double texts = kCardLines * lineHeight(painter->fontMetrics());
    const double room = std::max(0.0, std::min(height, inside.height() - texts));
    paintCardImage(sheet, {inside.left(), inside.top(), inside.width(), room});
    paintCardTexts(sheet, inside.adjusted(0, room + 2, 0, 0));
  }
  painter->restore();
}

}  // namespace widgets
