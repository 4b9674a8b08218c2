// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/commands/ScriptLine.h"
#include "robotlink/commands/ScriptReport.h"
#include "robotlink/session/Session.h"

namespace robotcontrol {
class RequestResult;
}

namespace robotlink {

class ScriptCondition;

/// Runs scripts line by line, without blocking: each line begins when the one before is done, that is, when
/// what it opens is open and its requests are accepted. SCRIPTS.md describes what can be written.
///
/// Real time is a parameter of tick(). One thread, that of the session; what it acts on must outlive it.
class ScriptRun {
 public:
  /// The objects that scripts act on.
  struct Workbench {
    CommandTable& commands;
    Session& session;
    /// Whether something is being opened. Fails, once, with why it could not be. May be empty.
    std::function<Result<bool>()> opening = {};
  };

  explicit ScriptRun(Workbench workbench);
  ~ScriptRun();
  ScriptRun(const ScriptRun&) = delete;
  ScriptRun& operator=(const ScriptRun&) = delete;

  /// Begins to run a file; one that cannot be read has failed at once. Files that it includes are read when
  /// it is their turn.
  void runFile(const std::filesystem::path& file);
  /// Begins to run lines that are in no file; errors name them by `name`, or have no position if that is
  /// empty. Variables of earlier lines are kept.
  void runLines(const std::string& name, const std::string& lines);
  /// Sets the folder to which files of commands and of lines are relative: by default, that of this program.
  void setFolder(std::filesystem::path folder) { folder_ = std::move(folder); }

  /// Gets the lines of `print`, in tick(); without this they are lost.
  void setOutput(std::function<void(const std::string&)> output) { output_ = std::move(output); }
  /// Ends what runs, as if it were done; what it has asked for continues.
  void cancel();
  /// The line with the values of variables in place of their names, as it would be run.
  Result<std::string> withValuesOfVariables(const std::string& line) const;

  /// Runs what can be run now. `now` is real time from any zero.
  void tick(Instant now);
  /// Whether there is nothing to run: the script has ended, or failed.
  bool isIdle() const { return sources_.empty(); }
  /// Why the script that was begun last failed, with file, line and column; unset if it did not.
  const std::optional<Error>& failed() const { return failed_; }
  /// Returns what ran since this object was made, ordered by begin: scripts, and files that they included.
  const std::vector<ScriptOutcome>& outcomes() const { return outcomes_; }

 private:
  /// A file, or lines, being run.
  struct Source {
    std::string name;
    std::filesystem::path folder;
    std::vector<std::string> lines;
    /// The next line, which is the number of the one that runs now.
    std::size_t next = 0;
    std::size_t outcome = 0;
    std::optional<Instant> since;
  };
  /// The event that the current line waits for.
  enum class Waits { kNothing, kCommand, kCondition, kTime };

  void push(std::string name, std::filesystem::path folder, const std::string& text);
  Result<void> include(const std::filesystem::path& file);
  std::optional<std::string> variable(const std::string& name) const;
  /// Begins the next line, or ends the innermost source.
  void beginNext(Instant now);
  Result<void> begin(const std::string& line, Instant now);
  Result<void> beginCommand();
  void take(const robotcontrol::RequestResult& result);
  Result<void> check(const std::string& condition) const;
  Result<void> print(const std::string& expression) const;
  /// Whether the line is done.
  Result<bool> isDone(Instant now);
  Result<bool> isCommandDone(Instant now);
  Result<bool> isConditionMet(Instant now);
  Result<bool> hasTimePassed(Instant now);
  void end(Instant now);
  void fail(Error error, Instant now);

  Workbench workbench_;
  std::uint64_t listener_ = 0;
  /// The innermost one is the last.
  std::vector<Source> sources_;
  std::map<std::string, std::string> variables_;
  std::vector<ScriptOutcome> outcomes_;
  std::filesystem::path folder_;
  std::function<void(const std::string&)> output_;
  std::optional<Error> failed_;

  // The line that runs now.
  ScriptLine line_;
  Waits waits_ = Waits::kNothing;
  /// When it began, and when the session's time last advanced.
  Instant began_, movedAt_;
  /// In the session's time: what has passed since kTime began, and the newest that was seen.
  Duration timePassed_{0};
  Instant timeSeen_;
  std::unique_ptr<ScriptCondition> condition_;
  /// Whether a command runs, or the handler of an answer to it, whose requests are listed.
  bool isListing_ = false;
  std::set<std::uint64_t> unanswered_;
  /// Why a request was refused.
  std::optional<std::string> refused_;
};

}  // namespace robotlink
