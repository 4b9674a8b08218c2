// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QApplication;

namespace app {

/// Colors of the application. kSystem follows the desktop (its settings portal on D-Bus) or, if that gives no
/// answer, the palette that Qt got from the platform. kHighContrast has white texts on black, with a contrast
/// of at least 7 (WCAG 2.1, level AAA) also for what is disabled.
enum class Appearance { kSystem, kLight, kDark, kHighContrast };

/// The inverse of nameOf(); kSystem for unknown names.
Appearance appearanceFromName(const QString& name);
/// The name in settings: "system", "light", "dark", "high-contrast".
QString nameOf(Appearance appearance);

/// Sets style and palette of the application. May be called repeatedly; GUI thread. For kSystem it waits up
/// to 0.2 s for the desktop's answer.
void apply(Appearance appearance, QApplication& application);

}  // namespace app
