// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"

namespace app {

/// A model of a Pioneer's lead-acid batteries, three of 7.2 Ah, for simulated ones. Full ones last for about
/// ten hours of standing, or two of driving at 1 m/s. The voltage is linear in the charge and drops under
/// load; capacity and currents are typical of such robots. A plain value, full at first.
class PioneerBattery {
 public:
  /// The voltages at which it is empty and full, V.
  PioneerBattery(double empty, double full) : empty_(empty), full_(full) {}

  /// Consumes what a robot needs in a time span; `speed` in m/s, of either sign.
  void discharge(bool motorsOn, double speed, robotlink::Duration passed);

  /// The voltage at the terminals, V.
  double voltage() const;
  /// The remaining share of the capacity, 0 to 1.
  double charge() const { return charge_; }

 private:
  double empty_ = 0, full_ = 0;
  double charge_ = 1;
  /// The current of the last discharge(), A.
  double current_ = 0;
};

}  // namespace app
