// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QStringList>

#include "app/core/platform/PlatformForm.h"

namespace app {

/// Remembers the last input in the forms of platforms, in the window's file: each field says at
/// which place. GUI thread.
class FormMemory {
 public:
  /// Number of values that are kept of a field with recent ones.
  static constexpr int kMaxRecent = 10;

  /// Takes the values of all forms from the state of the window. Unreadable values are skipped.
  void load(const QJsonObject& window);
  /// Adds them to the state of the window.
  void save(QJsonObject& window) const;

  /// The last values of a form, of those fields that are kept and were accepted before.
  FormValues valuesOf(const PlatformForm& form) const;
  /// The last values of a field with recent ones, the newest first.
  QStringList recent(const PlatformField& field) const;
  /// Keeps values that a user has accepted.
  void remember(const PlatformForm& form, const FormValues& values);

 private:
  /// The value of a field; undefined if there is none.
  QJsonValue at(const PlatformField& field) const;

  /// The remembered values, with the same keys as in the state of the window.
  QJsonObject kept_;
};

}  // namespace app
