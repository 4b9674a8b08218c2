// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/platforms/pioneer/PioneerAddress.h"
#include "app/platforms/pioneer/PioneerLine.h"
#include "robotlink/arcos/codec/RangeScan.h"
#include "robotlink/arcos/sick/SickSession.h"

namespace app {

/// The laser of a real Pioneer at a line of its own: moves bytes between the line and a SickSession, which
/// sets the laser up. The owner calls step() about a hundred times a second; it never blocks. The clock must
/// outlive it. One thread.
class PioneerLaser {
 public:
  PioneerLaser(robotlink::arcos::StreamUrl line, robotlink::arcos::SickSession::Options options,
               const robotlink::Clock& clock);
  /// Makes the laser quiet, and closes the line.
  ~PioneerLaser();
  PioneerLaser(const PioneerLaser&) = delete;
  PioneerLaser& operator=(const PioneerLaser&) = delete;

  /// Processes what has arrived, and opens the line again where the session wants that.
  void step();
  /// Removes and returns the newest scan in the laser's frame; empty if there is no new one.
  std::optional<robotlink::arcos::RangeScan> takeScan();
  const robotlink::arcos::SickSession& session() const { return session_; }

 private:
  const robotlink::arcos::StreamUrl address_;
  const robotlink::Clock& clock_;
  robotlink::arcos::SickSession session_;
  PioneerLine line_;
  /// The settings with which line_ was last opened; events of an earlier opening are of no use.
  std::optional<robotlink::arcos::SickSession::Line> wanted_;
};

}  // namespace app
