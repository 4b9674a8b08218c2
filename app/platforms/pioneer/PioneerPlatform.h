// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "app/platforms/pioneer/PioneerAddress.h"
#include "app/platforms/pioneer/PioneerDriver.h"
#include "app/platforms/pioneer/PioneerLaser.h"
#include "app/platforms/pioneer/PioneerLine.h"
#include "app/platforms/real/RealPlatform.h"

namespace app {

/// The platform of a Pioneer at the other end of a line: a real robot, or one of another simulator. Its time
/// is real time.
///
/// The owner lets it run about a hundred frames per second, each of which processes what has arrived over the
/// line. While it does, the robot's watchdog is kept from stopping the robot; if the workbench hangs, the
/// robot stops. Clock and description must outlive it.
class PioneerPlatform final : public RealPlatform {
 public:
  /// `options.address` is the URL of the line. The connection is made by actuate(), and so is that of the
  /// laser that the address has, if it has one.
  PioneerPlatform(const robotlink::Clock& clock, std::string robot,
                  const robotlink::RobotDescription& description, PioneerDriver::Options options,
                  const PioneerAddress& address);
  ~PioneerPlatform() override;

  /// Ends the connection properly: motors off, then CLOSE.
  void shutDown() override;
  /// Processes what has arrived, then sends commands; opens and closes the line as the connection requires.
  void actuate() override;
  /// Sends the stop commands at once, without waiting for actuate(), since the thread that steps this
  /// platform may be blocked by a program that hangs. Any thread.
  void engageStop(bool engaged) override;
  bool stopEngaged() const override { return stopEngaged_.load(); }
  std::vector<robotlink::AnySender*> onRequest() override { return driver_.senders(); }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override {
    return driver_.control(details, clock().now());
  }
  void connectNow() override { driver_.connectNow(clock().now()); }
  bool isConnected() const override { return driver_.session().isConnected(); }
  std::string connectionText() const override { return driver_.session().describe(); }
  std::vector<Figure> connectionFigures() const override;

 protected:
  /// Sends the packages.
  void execute() override;

 private:
  /// Passes the laser's scans to the driver, and its state.
  void stepLaser();
  /// Passes the events of the line to the driver.
  void takeEvents();
  /// Passes the driver's packets to the line.
  void sendWaiting();

  std::atomic<bool> stopEngaged_{false};
  /// Whether STOP's commands were sent since the last actuate().
  std::atomic<bool> stopSent_{false};
  /// Whether shutDown() was called, which acts only once.
  bool shutDown_ = false;
  PioneerDriver driver_;
  PioneerLine line_;
  /// Null if the robot has no laser at a line of its own.
  std::unique_ptr<PioneerLaser> laser_;
};

}  // namespace app
