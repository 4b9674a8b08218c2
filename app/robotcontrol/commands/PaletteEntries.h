// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QAction>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <vector>

class QMenuBar;

namespace robotlink {
class CommandTable;
}

namespace app {

/// An entry that the palette offers.
struct PaletteEntry {
  /// "View › Field", "robot.walk x y rotation" or, for an argument, what it can be.
  QString title;
  /// The effect of the entry, in a sentence.
  QString help;
  /// The shortcut as text; may be empty.
  QString key;
  /// The line of the command; empty for a menu entry.
  QString line;
  /// Whether the line misses arguments that must be given.
  bool isUnfinished = false;
  /// The menu entry; null for a command.
  QPointer<QAction> action = {};

  /// The id of the entry in the list of recent ones: the line, or the name of the menu entry.
  QString id() const;
};

/// All menu entries that can be chosen now, and all commands; a command that a menu entry runs is left out.
std::vector<PaletteEntry> paletteEntries(const QMenuBar& menus, const robotlink::CommandTable& commands);

/// How well an entry fits what was typed: each word must be in its title, help or line, or its letters in
/// this order in the title. Negative: it does not fit; an empty text fits all equally.
int paletteScore(const PaletteEntry& entry, const QString& typed);

/// The entries that fit, the best first; equals in the order of `recent` (the newest last), then by title.
std::vector<PaletteEntry> paletteMatches(const std::vector<PaletteEntry>& entries, const QString& typed,
                                         const QStringList& recent);

/// A list of entries.
class PaletteModel final : public QAbstractListModel {
  Q_OBJECT
 public:
  /// QString, for each: help, key.
  enum Role { kHelpRole = Qt::UserRole + 1, kKeyRole };

  using QAbstractListModel::QAbstractListModel;
  void show(std::vector<PaletteEntry> entries);
  /// Null if there is no such row.
  const PaletteEntry* entry(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<PaletteEntry> entries_;
};

}  // namespace app
