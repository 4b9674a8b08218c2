// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "robotlink/base/Resources.h"

namespace widgets {
namespace {

QByteArray readIcon(const QString& name) {
  const auto path = robotlink::resource(std::filesystem::path("icons") / (name.toStdString() + ".svg"));
  QFile file(QString::fromStdString(path.string()));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QColor strokeColor(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::WindowText);
  if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
  return palette.color(QPalette::WindowText);
}

/// Renders an SVG in the palette's current colors. Pixmaps are cached in Qt's QPixmapCache by size and color.
class PaletteIconEngine final : public QIconEngine {
 public:
  PaletteIconEngine(QString name, QByteArray svg) : name_(std::move(name)), svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal ratio = painter->device() != nullptr ? painter->device()->devicePixelRatioF() : 1;
    painter->drawPixmap(rect, pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
    const QColor color = strokeColor(mode);
    const QString key = QStringLiteral("robotcontrol/%1/%2x%3/%4/%5")
                            .arg(name_)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(color.rgba(), 8, 16)
                            .arg(static_cast<int>(mode));
    QPixmap result;
    if (!QPixmapCache::find(key, &result)) {
      result = render(size, color, mode == QIcon::Disabled ? 0.45 : 1);
      QPixmapCache::insert(key, result);
    }
    return result;
  }

  QIconEngine* clone() const override { return new PaletteIconEngine(*this); }

 private:
  QPixmap render(const QSize& size, const QColor& color, double opacity) const {
    QPixmap result(size);
    result.fill(Qt::transparent);
    if (svg_.isEmpty() || size.isEmpty()) return result;
    QSvgRenderer renderer(QByteArray(svg_).replace("currentColor", color.name().toLatin1()));
    QPainter painter(&result);
    painter.setOpacity(opacity);
    const int side = std::min(size.width(), size.height());
    renderer.render(&painter, QRectF((size.width() - side) / 2.0, (size.height() - side) / 2.0, side, side));
    return result;
  }

  QString name_;
  QByteArray svg_;
};

}  // namespace

QIcon icon(const QString& name) {
  return QIcon(new PaletteIconEngine(name, readIcon(name)));
}

}  // namespace widgets
