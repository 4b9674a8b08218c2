// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/commands/ScriptRun.h"

namespace app {

class OpenPlatform;
class Workbench;

/// Returns the interface by which scripts act on a workbench, which must outlive them.
robotlink::ScriptRun::Workbench scriptsOf(Workbench& workbench);

/// Performs the startup of the program: once the remote robots on the command line are connected, or have had
/// some seconds to connect, it starts the simulation when that is loaded, runs the
/// commands of the command line one after the other, and then a script. GUI thread.
class StartScript : public QObject {
  Q_OBJECT
 public:
  struct Options {
    /// Whether what is opened is a simulation that is started.
    bool startsSimulation = false;
    std::vector<std::string> commands;
    /// The file of a script; empty: none.
    std::string script;
    /// The JUnit file that is written at the end of the script; empty: none.
    std::string junit;
  };

  /// The workbench must outlive it.
  StartScript(Workbench& workbench, Options options, QObject* parent);

 Q_SIGNALS:
  /// The script has ended, with an ExitStatus; what was wrong is printed on standard error.
  void finished(int status);

 protected:
  void timerEvent(QTimerEvent* event) override;

 private:
  /// Whether robots at the addresses of the command line, which commands may name, are not connected yet. The
  /// wait for them is limited.
  bool awaitsRobots() const;
  /// Begins the next line once the previous one is done. Returns false if there are no more.
  bool beginNext();
  /// Prints why the line or script that ran last failed.
  void report();
  /// Writes the JUnit file and ends.
  void finish();

  Workbench& workbench_;
  const Options options_;
  const robotlink::SteadyClock clock_;
  const robotlink::Instant begun_ = clock_.now();
  robotlink::ScriptRun run_;
  /// The line that runs now, for messages.
  std::string line_;
  std::size_t next_ = 0;
  /// The errors of opening what the command line names.
  robotlink::Errors unopened_;
  bool hasStarted_ = false;
  bool isScript_ = false;
  /// The number of outcomes before the script.
  std::size_t before_ = 0;
};

}  // namespace app
