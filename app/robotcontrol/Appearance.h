// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QApplication;

namespace app {

/// Light and dark. "System" asks the desktop (the settings portal) and, where there is none, follows the
/// palette that Qt was given.
enum class Appearance { kSystem, kLight, kDark };

Appearance appearanceFromName(const QString& name);
QString nameOf(Appearance appearance);

/// Gives the application style and palette. May be called again at any time. GUI thread.
void apply(Appearance appearance, QApplication& application);

}  // namespace app
