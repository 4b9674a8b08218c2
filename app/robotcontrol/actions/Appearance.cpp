// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/Appearance.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusInterface>
#include <QDBusReply>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <optional>

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

QPalette makePalette(const QColor& window, const QColor& base, const QColor& text, const QColor& accent) {
  QPalette palette(window.lighter(115), window);
  const QColor faint =
      QColor::fromRgbF(0.5 * (text.redF() + window.redF()), 0.5 * (text.greenF() + window.greenF()),
                       0.5 * (text.blueF() + window.blueF()));
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor::fromRgbF(0.5 * (base.redF() + window.redF()),
                                                             0.5 * (base.greenF() + window.greenF()),
                                                             0.5 * (base.blueF() + window.blueF())));
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
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
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
