// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/core/ServedPlatform.h"
#include "app/core/platform/RecordOptions.h"
#include "robotlink/base/Error.h"
#include "robotlink/foxglove/server/ListenAddress.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// The option --listen of commands that can be watched and steered over the network, and those that say who
/// may do that. Filled by the command line parser.
struct ListenOptions {
  /// Adds the options to a command; this object must outlive the command.
  void addTo(CLI::App& command);
  bool given() const;
  /// Returns the given address; without a value, the default port on this machine only.
  robotlink::Result<robotlink::websocket::ListenAddress> address() const;
  /// Serves a platform at that address until its time is over or the user interrupts it; returns the exit
  /// status of the program.
  int serve(PlatformOpening opening, ServeOptions options, const RecordOptions& record) const;

 private:
  /// Adds the options about who may connect, and those about silent clients. They need option_.
  void addAccessTo(CLI::App& command);
  void addTimeLimitsTo(CLI::App& command);

  std::string text_, recordings_, resources_;
  AccessOptions access_;
  /// Seconds.
  double motionTimeout_ = 0.5, linkTimeout_ = 1;
  /// Owned by the command; null before addTo().
  CLI::Option* option_ = nullptr;
};

}  // namespace app
