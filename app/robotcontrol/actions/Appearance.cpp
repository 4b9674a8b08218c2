// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/Appearance.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusInterface>
#include <QDBusReply>
#include <QPalette>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOptionButton>
#include <optional>

#include "widgets/Icon.h"

namespace app {
namespace {

constexpr int kPortalTimeoutMs = 200;

/// The preference of the desktop (org.freedesktop.appearance color-scheme: 1 dark, 2 light); empty if it has
/// none.
std::optional<bool> desktopPrefersDark() {
  const QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return std::nullopt;
  QDBusInterface portal(QStringLiteral("org.freedesktop.portal.Desktop"),
                        QStringLiteral("/org/freedesktop/portal/desktop"),
                        QStringLiteral("org.freedesktop.portal.Settings"), bus);
  portal.setTimeout(kPortalTimeoutMs);
  const QDBusReply<QDBusVariant> reply = portal.call(
      QStringLiteral("Read"), QStringLiteral("org.freedesktop.appearance"), QStringLiteral("color-scheme"));
  if (!reply.isValid()) return std::nullopt;
  QVariant value = reply.value().variant();
  if (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  switch (value.toUInt()) {
    case 1:
      return true;
    case 2:
      return false;
    default:
      return std::nullopt;
  }
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

/// The color in the middle between two.
QColor half(const QColor& a, const QColor& b) {
  return QColor::fromRgbF(0.5 * (a.redF() + b.redF()), 0.5 * (a.greenF() + b.greenF()),
                          0.5 * (a.blueF() + b.blueF()));
}

/// The Fusion style, with marks that can be seen on dark windows too: it draws the frames of check boxes in
/// the color of the window, only darker.
class VisibleMarks final : public QProxyStyle {
 public:
  VisibleMarks() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element == PE_IndicatorTabClose) {
      const bool isActive = (option->state & State_Enabled) && (option->state & State_MouseOver);
      return widgets::icon("close").paint(painter, option->rect, Qt::AlignCenter,
                                          isActive ? QIcon::Active : QIcon::Normal);
    }
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    if ((element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) || button == nullptr)
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
    QStyleOptionButton seen = *button;
    // The style makes it darker by this factor.
    constexpr int kFrameDarker = 140;
    seen.palette.setColor(QPalette::Window,
                          half(button->palette.color(QPalette::Text), button->palette.color(QPalette::Base))
                              .lighter(kFrameDarker));
    QProxyStyle::drawPrimitive(element, &seen, painter, widget);
  }
};

QPalette makePalette(const QColor& window, const QColor& base, const QColor& text, const QColor& accent) {
  QPalette palette(window.lighter(115), window);
  const QColor faint = half(text, window);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, half(base, window));
  palette.setColor(QPalette::ToolTipBase, base);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, accent);
  return palette;
}

/// Buttons are gray, since the style would draw their frames in black on black.
QPalette highContrastPalette() {
  const QColor accent(0xff, 0xd7, 0x00), faint(0xb8, 0xb8, 0xb8);
  QPalette palette = makePalette(QColor(0x1c, 0x1c, 0x1c), Qt::black, Qt::white, accent);
  palette.setColor(QPalette::Button, QColor(0x46, 0x46, 0x46));
  palette.setColor(QPalette::HighlightedText, Qt::black);
  palette.setColor(QPalette::PlaceholderText, faint);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ToolTipText})
    palette.setColor(QPalette::Disabled, role, faint);
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(0xd6, 0xd6, 0xd6));
  palette.setColor(QPalette::Disabled, QPalette::Button, QColor(0x2a, 0x2a, 0x2a));
  return palette;
}

}  // namespace

Appearance appearanceFromName(const QString& name) {
  if (name == QLatin1String("light")) return Appearance::kLight;
  if (name == QLatin1String("dark")) return Appearance::kDark;
  if (name == QLatin1String("high-contrast")) return Appearance::kHighContrast;
  return Appearance::kSystem;
}

QString nameOf(Appearance appearance) {
  switch (appearance) {
    case Appearance::kLight:
      return QStringLiteral("light");
    case Appearance::kDark:
      return QStringLiteral("dark");
    case Appearance::kHighContrast:
      return QStringLiteral("high-contrast");
    case Appearance::kSystem:
      break;
  }
  return QStringLiteral("system");
}

void apply(Appearance appearance, QApplication& application) {
  QApplication::setStyle(new VisibleMarks);
  if (appearance == Appearance::kHighContrast) return application.setPalette(highContrastPalette());
  const bool dark = appearance == Appearance::kDark ||
                    (appearance == Appearance::kSystem &&
                     desktopPrefersDark().value_or(isDark(QApplication::style()->standardPalette())));
  application.setPalette(dark ? makePalette(QColor(0x2b, 0x2e, 0x33), QColor(0x1f, 0x21, 0x25),
                                            QColor(0xe4, 0xe6, 0xea), QColor(0x3d, 0x7e, 0xd0))
                              : makePalette(QColor(0xf0, 0xf1, 0xf3), QColor(0xff, 0xff, 0xff),
                                            QColor(0x1c, 0x1e, 0x21), QColor(0x2b, 0x6c, 0xc4)));
}

}  // namespace app
