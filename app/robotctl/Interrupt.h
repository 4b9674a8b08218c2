// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Watches for SIGINT (Ctrl-C), SIGTERM and SIGHUP while it lives, in a thread of its own. A signal that was
/// ignored when the program was started (by nohup) stays ignored.
///
/// Where an Interrupt exists, the program is asked to end by Interrupt::noted(); if nobody has asked for that
/// within two seconds, or another signal comes later, it is ended at once. Elsewhere it is ended at once.
/// That removes unfinished files, so what is left is complete. A broken pipe on standard output (SIGPIPE) is
/// noted in the same way, but ends nothing by itself. One for the program, made before any other thread.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
};

/// While it lives, signals do not end the program but are noted, so that what it does is ended in good order.
/// They can be nested.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether the program is to end; whoever asks is expected to do that.
  static bool noted();
  /// The signal that came; 0: none did.
  static int signal();
  /// As shells tell of a program that a signal has ended.
  static constexpr int exitStatus(int signal) { return 128 + signal; }
};

}  // namespace app
