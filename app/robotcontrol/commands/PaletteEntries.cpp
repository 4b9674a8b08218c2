// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/commands/PaletteEntries.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <optional>
#include <set>

#include "robotlink/commands/CommandTable.h"

namespace app {
namespace {

using robotlink::CommandTable;

const QLatin1String kActionId("menu:");

QString plain(QString text) {
  return text.remove(QLatin1Char('&'));
}

void collect(const QList<QAction*>& actions, const QString& path, std::vector<PaletteEntry>& entries) {
  for (QAction* action : actions) {
    if (action->isSeparator() || !action->isVisible() || action->text().isEmpty()) continue;
    const QString text = plain(action->text());
    const QString title = path.isEmpty() ? text : path + QStringLiteral(" › ") + text;
    if (const QMenu* menu = action->menu()) {
      collect(menu->actions(), title, entries);
      continue;
    }
    if (!action->isEnabled() || action->objectName().isEmpty()) continue;
    const QString tip = plain(action->toolTip());
    entries.push_back({title,
                       tip == text ? QString() : tip,
                       action->shortcut().toString(QKeySequence::NativeText),
                       {},
                       false,
                       action});
  }
}

PaletteEntry entryFor(const CommandTable::Command& command) {
  PaletteEntry entry;
  entry.title = entry.line = QString::fromStdString(command.name);
  entry.help = QCoreApplication::translate("Command", command.help.c_str());
  for (const auto& argument : command.arguments) {
    const QString name = QString::fromStdString(argument.name);
    entry.title += argument.isOptional() ? QStringLiteral(" [%1]").arg(name) : QLatin1Char(' ') + name;
    entry.isUnfinished = entry.isUnfinished || !argument.isOptional();
  }
  return entry;
}

bool beginsWord(const QString& text, int at) {
  return at == 0 || !text.at(at - 1).isLetterOrNumber();
}

/// How well a word fits into a text as a part of it.
std::optional<int> partScore(const QString& text, const QString& word) {
  const int at = text.indexOf(word, 0, Qt::CaseInsensitive);
  if (at < 0) return std::nullopt;
  return (beginsWord(text, at) ? 60 : 30) - std::min(at, 20);
}

/// Whether the letters of a word are in a text in this order, the first one at the start of a word.
bool hasLetters(const QString& text, const QString& word) {
  for (int begin = text.indexOf(word.at(0), 0, Qt::CaseInsensitive); begin >= 0;
       begin = text.indexOf(word.at(0), begin + 1, Qt::CaseInsensitive)) {
    if (!beginsWord(text, begin)) continue;
    int at = begin;
    for (const QChar letter : word) {
      at = text.indexOf(letter, at, Qt::CaseInsensitive);
      if (at < 0) break;
      ++at;
    }
    if (at > 0) return true;
  }
  return false;
}

}  // namespace

QString PaletteEntry::id() const {
  return line.isEmpty() && action ? kActionId + action->objectName() : line;
}

std::vector<PaletteEntry> paletteEntries(const QMenuBar& menus, const CommandTable& commands) {
  std::vector<PaletteEntry> entries;
  collect(menus.actions(), {}, entries);
  std::set<QString> inMenus;
  for (const PaletteEntry& entry : entries) inMenus.insert(entry.action->objectName());
  for (const auto& [name, command] : commands.all()) {
    const bool isInMenu = command.arguments.empty() && inMenus.contains(QString::fromStdString(name));
    if (command.run && !isInMenu) entries.push_back(entryFor(command));
  }
  return entries;
}

int paletteScore(const PaletteEntry& entry, const QString& typed) {
  int total = 0;
  for (const QString& word : typed.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const auto title = partScore(entry.title, word);
    const auto rest = partScore(entry.help + QLatin1Char(' ') + entry.id(), word);
    if (!title && !rest && !hasLetters(entry.title, word)) return -1;
    total += title ? 100 + *title : rest ? *rest : 1;
  }
  return total;
}

std::vector<PaletteEntry> paletteMatches(const std::vector<PaletteEntry>& entries, const QString& typed,
                                         const QStringList& recent) {
  struct Rated {
    int score;
    int age;  // the smaller the later it was used
    const PaletteEntry* entry;
  };
  std::vector<Rated> rated;
  for (const PaletteEntry& entry : entries) {
    const int score = paletteScore(entry, typed);
    const int used = recent.lastIndexOf(entry.id());
    if (score >= 0) rated.push_back({score, used < 0 ? recent.size() : recent.size() - 1 - used, &entry});
  }
  std::ranges::stable_sort(rated, [](const Rated& a, const Rated& b) {
    if (a.score != b.score) return a.score > b.score;
    if (a.age != b.age) return a.age < b.age;
    return a.entry->title.compare(b.entry->title, Qt::CaseInsensitive) < 0;
  });
  std::vector<PaletteEntry> matches;
  matches.reserve(rated.size());
  for (const Rated& each : rated) matches.push_back(*each.entry);
  return matches;
}

void PaletteModel::show(std::vector<PaletteEntry> entries) {
  beginResetModel();
  entries_ = std::move(entries);
  endResetModel();
}

const PaletteEntry* PaletteModel::entry(const QModelIndex& index) const {
  return index.isValid() ? &entries_[static_cast<std::size_t>(index.row())] : nullptr;
}

int PaletteModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant PaletteModel::data(const QModelIndex& index, int role) const {
  const PaletteEntry* shown = entry(index);
  if (shown == nullptr) return {};
  switch (role) {
    case Qt::DisplayRole:
      return shown->title;
    case Qt::ToolTipRole:
    case kHelpRole:
      return shown->help;
    case kKeyRole:
      return shown->key;
    default:
      return {};
  }
}

}  // namespace app
