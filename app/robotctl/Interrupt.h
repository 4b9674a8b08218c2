// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace app {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM do not end the program but are noted, so that what it does is ended in good
/// order. One at a time.
class Interrupt {
 public:
  Interrupt() {
    noted_ = 0;
    std::signal(SIGINT, &note);
    std::signal(SIGTERM, &note);
  }
  ~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool noted() { return noted_ != 0; }

 private:
  static void note(int) { noted_ = 1; }
  static inline volatile std::sig_atomic_t noted_ = 0;  // signals leave no other way
};

}  // namespace app
