// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Handles SIGINT (Ctrl-C), SIGTERM and SIGHUP in a thread of its own. A signal that was ignored when the
/// program was started (by nohup) stays ignored.
///
/// While an Interrupt exists, a signal only sets Interrupt::noted(); the program is terminated if nothing
/// calls noted() within two seconds, or when another signal arrives later. Without an Interrupt it is
/// terminated at once. Termination removes unfinished files, so that all files left are complete. A broken
/// pipe on standard output (SIGPIPE) is noted in the same way, but never terminates the program. One per
/// program, to be created before any other thread, since threads inherit its signal mask.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
};

/// While an object of this class exists, signals do not terminate the program but are noted, so that the
/// operation can end properly. Objects can be nested. Any thread.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether the program is to end; a caller that gets true is expected to stop soon.
  static bool noted();
  /// The signal that was received; 0: none.
  static int signal();
  /// The exit status by which shells report termination by a signal.
  static constexpr int exitStatus(int signal) { return 128 + signal; }
};

}  // namespace app
