// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"

namespace app {

/// The lead batteries of a Pioneer, three of 7.2 Ah: they last for about ten hours of standing, three of
/// driving. Linear between full and empty, with a drop under load; figures are typical ones of such
/// batteries.
class PioneerBattery {
 public:
  void discharge(bool motorsOn, double speed, robotlink::Duration passed);

  double voltage() const;                    ///< V, at the terminals
  double charge() const { return charge_; }  ///< 0 to 1

 private:
  double charge_ = 1;
  double current_ = 0;  ///< A
};

}  // namespace app
