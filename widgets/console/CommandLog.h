// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <deque>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/commands/ScriptRun.h"
#include "widgets/View.h"

namespace widgets {

/// The commands that a person has typed, in whichever view, and their outcomes. All of a window share one,
/// see commandLog(). GUI thread; the objects on which they act must outlive it.
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

  /// The objects on which lines act must outlive this.
  CommandLog(robotlink::CommandTable& commands, robotlink::Session& session, QObject* parent = nullptr);
  ~CommandLog() override;

  /// Runs a line of a script, notes it and its outcome, and adds it to the history. A command has been
  /// run at the return; the words of scripts (SCRIPTS.md) may take longer, and then note their outcome
  /// later. One that still waits is canceled by the next one. "help" lists all commands, "help robot." those
  /// that begin so.
  robotlink::Result<void> run(const QString& line);
  /// Notes a later result of a command, or an error from elsewhere.
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

  void timerEvent(QTimerEvent* event) override;
  robotlink::Result<void> runCommand(const std::string& line);
  void runWord(const QString& line);
  /// Goes on with what waits.
  void tickScript();

  robotlink::CommandTable& commands_;
  const robotlink::SteadyClock clock_;
  /// Runs what is no command, and has the variables.
  robotlink::ScriptRun script_;
  /// The line that it runs; empty: none.
  QString waiting_;
  /// While a line waits.
  int timer_ = 0;
  std::deque<Entry> entries_;
  QStringList history_;
};

/// The log that all views of the context share.
CommandLog& commandLog(ViewContext& context);

}  // namespace widgets
