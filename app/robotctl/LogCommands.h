// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "logplayer/LogFile.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace app {

// The parts of `robotctl log`; each adds subcommands to it.
void addLogReadCommands(CLI::App& log, int& status);    // info, verify
void addLogImportCommands(CLI::App& log, int& status);  // import, repair
void addLogCutCommands(CLI::App& log, int& status);     // cut, merge, filter, convert
void addLogExportCommand(CLI::App& log, int& status);
void addLogNoteCommands(CLI::App& log, int& status);  // bookmark, attachment

/// Prints each on stderr, one a line: kDoneWithLosses, or kDone if there are none.
int printLosses(const std::vector<std::string>& losses);

/// A time range as people give it. A time is in seconds from the log's start ("12.5"), or a time of the log
/// ("@486.75"), or a date ("2026-05-04T12:30:01"), or the text of a bookmark.
struct TimeRange {
  std::string from, to;  ///< empty: the start, the end

  void addTo(CLI::App& command);
  struct Instants {
    std::optional<robotlink::Instant> from, to;
    /// The log, if it was needed. Kept while it is read again, it need not be looked through, or converted,
    /// a second time.
    std::shared_ptr<logplayer::LogFile> log;
  };
  /// Fails with "usage" for what is none of these.
  robotlink::Result<Instants> of(const std::filesystem::path& log) const;
};

/// Shows on stderr how much is done, if that is a terminal and it takes a while. A signal (Ctrl-C) while it
/// exists gives up what it is shown for, so that nothing half-done is left. One at a time.
class TerminalProgress {
 public:
  TerminalProgress();
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  /// For functions that report their progress; valid as long as this.
  logplayer::LogFile::Progress function();
  /// Makes room for what is printed.
  void erase();

 private:
  bool show(double share);

  Interrupt interrupt_;
  std::chrono::steady_clock::time_point start_;
  bool onTerminal_;
  int shown_ = -1;  // percent
};

}  // namespace app
