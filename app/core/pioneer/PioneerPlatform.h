// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <string>

#include "app/core/pioneer/PioneerDriver.h"
#include "app/core/pioneer/PioneerLine.h"
#include "robotlink/process/Platform.h"

namespace app {

/// The platform of a Pioneer at the far end of a line: a real one, or one of another simulator. Its time is
/// real time.
///
/// Its owner lets it run a frame some hundred times a second; what came over the line meanwhile is taken
/// then. As long as it does so the robot is kept from stopping by itself; a workbench that hangs lets it
/// stop.
class PioneerPlatform final : public robotlink::Platform {
 public:
  PioneerPlatform(const robotlink::Clock& clock, std::string robot,
                  const robotlink::RobotDescription& description, PioneerDriver::Options options);
  ~PioneerPlatform() override;

  /// Ends the connection in good order: motors off, CLOSE.
  void shutDown() override;
  void actuate() override;
  /// Stops the robot at once, by the line's own thread: whoever steps this may be held up by a program that
  /// hangs.
  void engageStop(bool engaged) override;
  bool stopEngaged() const override { return stopEngaged_.load(); }
  std::vector<robotlink::AnySender*> onRequest() override { return driver_.senders(); }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override {
    return driver_.control(details, clock().now());
  }
  /// Does not wait any longer before it tries to connect again.
  void connectNow() { driver_.connectNow(clock().now()); }
  const PioneerDriver& driver() const { return driver_; }

 protected:
  void execute() override;

 private:
  void takeEvents();
  void sendWaiting();

  std::atomic<bool> stopEngaged_{false};
  bool shutDown_ = false;
  PioneerDriver driver_;
  PioneerLine line_;
};

}  // namespace app
