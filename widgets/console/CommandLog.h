// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <deque>

#include "robotlink/base/Error.h"
#include "widgets/View.h"

namespace widgets {

/// The commands that a person has typed, in whichever view, and what came of them. All of a window share one,
/// see commandLog(). GUI thread; the command table must outlive it.
class CommandLog final : public QObject {
  Q_OBJECT
 public:
  enum class Kind : std::uint8_t { kCommand, kOutput, kError };
  struct Entry {
    Kind kind = Kind::kOutput;
    QString text;
    bool operator==(const Entry&) const = default;
  };
  /// The numbers of entries and of lines in the history that are kept; the oldest are dropped.
  static constexpr std::size_t kMaxEntries = 2000;
  static constexpr int kMaxHistory = 200;

  explicit CommandLog(const robotlink::CommandTable& commands, QObject* parent = nullptr)
      : QObject(parent), commands_(commands) {}

  /// Runs a line as CommandTable::runLine() does, notes it and what came of it, and adds it to the history.
  /// "help" lists all commands, "help robot." those that begin so.
  robotlink::Result<void> run(const QString& line);
  /// Notes something that came of a command later, or that went wrong elsewhere.
  void add(Kind kind, const QString& text);
  void clear();
  const std::deque<Entry>& entries() const { return entries_; }

  /// The lines that were run, the newest last, each once.
  const QStringList& history() const { return history_; }
  /// Puts a line at the end of the history; longer ones than a script may have are ignored.
  void remember(const QString& line);
  /// Replaces the history, for example by that of the last start.
  void setHistory(const QStringList& lines);

 Q_SIGNALS:
  void added(const widgets::CommandLog::Entry& entry);
  void cleared();

 private:
  void help(const QString& begin);

  const robotlink::CommandTable& commands_;
  std::deque<Entry> entries_;
  QStringList history_;
};

/// The log that all views of the context share.
CommandLog& commandLog(ViewContext& context);

}  // namespace widgets
