// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "robotlink/base/Error.h"

class QAction;
class QShortcut;
class QWidget;

namespace app {

class WindowKeys;

/// A key and its effect.
struct Shortcut {
  QKeySequence key;
  QString text;
  /// Title of the view in which it works; empty: everywhere.
  QString view;
  /// The action or shortcut; null for a binding of WindowKeys.
  QObject* owner = nullptr;
  /// The name under which a user's choice is saved; empty: the shortcut cannot be changed.
  QString id = {};
  /// The key as it is shipped.
  QKeySequence shipped = {};
};

/// All keys of a window and of the views that are open in it, and those that the user has chosen instead,
/// which a text file remembers. Views that open later get them, too. GUI thread; it belongs to the window,
/// and the keys must outlive it.
class Shortcuts final : public QObject {
  Q_OBJECT
 public:
  Shortcuts(WindowKeys& keys, std::filesystem::path file, QWidget& window);

  /// The reason why the file cannot be used; unset otherwise.
  const std::optional<robotlink::Error>& problem() const { return problem_; }
  std::vector<Shortcut> all() const;
  /// Gives something another key; an empty one removes the key. Fails if the key does something else already,
  /// which it names, or if the file cannot be written.
  robotlink::Result<void> assign(const Shortcut& shortcut, const QKeySequence& key);
  /// Gives something, or everything, the key that it was shipped with.
  robotlink::Result<void> reset(const Shortcut& shortcut) { return assign(shortcut, shortcut.shipped); }
  robotlink::Result<void> resetAll();

  /// Notices actions that are added to views.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void load();
  robotlink::Result<void> save() const;
  /// Returns a shortcut that already uses the key where `shortcut` works; unset if there is none.
  std::optional<Shortcut> conflict(const Shortcut& shortcut, const QKeySequence& key) const;
  void set(const Shortcut& shortcut, const QKeySequence& key);
  /// Gives actions the keys that the user has chosen for them.
  void apply();

  WindowKeys& keys_;
  const std::filesystem::path file_;
  QWidget& window_;
  /// Keyed by id.
  std::map<QString, QKeySequence> chosen_;
  std::optional<robotlink::Error> problem_;
  bool isApplying_ = false;
};

}  // namespace app
