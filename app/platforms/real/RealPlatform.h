// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "robotlink/process/Platform.h"

namespace app {

/// The platform of a real robot, or of a device such as a camera. Its time is real time. The owner lets it
/// run about a hundred frames per second; it connects by itself, repeatedly where that fails.
class RealPlatform : public robotlink::Platform {
 public:
  /// A figure about the connection: its name in JSON, and its value.
  using Figure = std::pair<std::string, std::variant<std::uint64_t, double>>;

  using Platform::Platform;

  /// Ends the pause between two attempts to connect.
  virtual void connectNow() = 0;
  virtual bool isConnected() const = 0;
  /// The state of the connection as a sentence without its period.
  virtual std::string connectionText() const = 0;
  /// The figures of the connection so far.
  virtual std::vector<Figure> connectionFigures() const = 0;
};

}  // namespace app
