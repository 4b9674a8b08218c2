// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QMenu>

#include "app/robotcontrol/language/Language.h"

namespace app {

/// The menu of the languages of the window. A choice is in effect from the next start on, when
/// savedLanguage() finds it. GUI thread.
class LanguageMenu final : public QMenu {
  Q_OBJECT
 public:
  explicit LanguageMenu(QWidget* parent);

  /// Emits chosen() if it is another one than before.
  void setLanguage(Language language);
  Language language() const { return language_; }

  /// Reads and writes the choice as a member of the saved window.
  void load(const QJsonObject& window);
  void save(QJsonObject& window) const;

 Q_SIGNALS:
  /// Emitted when another language was chosen; `message` says when it takes effect.
  void chosen(const QString& message);

 private:
  void checkEntry();

  Language language_ = Language::kSystem;
};

}  // namespace app
