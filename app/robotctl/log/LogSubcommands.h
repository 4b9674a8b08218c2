// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace app {

// The parts of `robotctl log`. Each function adds subcommands, whose callbacks set `status`.
void addLogReadCommands(CLI::App& log, int& status);    // info, verify
void addLogImportCommands(CLI::App& log, int& status);  // import, repair
void addLogCutCommands(CLI::App& log, int& status);     // cut, merge, filter, convert
void addLogExportCommand(CLI::App& log, int& status);
void addLogSearchCommand(CLI::App& log, int& status);
void addLogNoteCommands(CLI::App& log, int& status);  // bookmark, attachment
void addLogFetchCommand(CLI::App& log, int& status);

/// Prints losses to stderr, one per line. Returns kDoneWithLosses, or kDone if there are none.
int printLosses(const std::vector<std::string>& losses);
/// Prints why a range or what depends on it failed; kUsage if the range makes no sense, else kFailed.
int printRangeError(const robotlink::Error& error);

/// A time range as users enter it. Each end is a number of seconds from the log's start ("12.5"), a time of
/// the log ("@486.75"), a date ("2026-05-04T12:30:01"), or the text of a bookmark.
struct TimeRangeOptions {
  /// Empty: the start, the end.
  std::string from, to;

  /// Adds the options --from and --to to a command.
  void addTo(CLI::App& command);
  /// The range in log times; empty ends are open.
  struct Instants {
    std::optional<robotlink::Instant> from, to;
    /// The log, if it was needed. Kept while it is read again, it need not be looked through, or converted,
    /// a second time.
    std::shared_ptr<logplayer::LogFile> log;
  };
  /// Interprets the range for a log. Fails with the error id "usage" if an end has none of these forms.
  robotlink::Result<Instants> of(const std::filesystem::path& log) const;
};

/// Shows progress on stderr, if that is a terminal and the operation takes a while. While this object exists,
/// a signal (Ctrl-C) cancels the operation, so that no unfinished file is left. One at a time.
class TerminalProgress {
 public:
  TerminalProgress();
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  /// The callback for the operation; valid as long as this object.
  logplayer::LogFile::Progress function();
  /// Clears the line, before other text is printed.
  void erase();

 private:
  /// Updates the line; returns false if the operation is to be canceled.
  bool show(double share);

  Interrupt interrupt_;
  std::chrono::steady_clock::time_point start_;
  bool onTerminal_;
  /// The percentage that is displayed; -1: nothing.
  int shown_ = -1;
};

}  // namespace app
