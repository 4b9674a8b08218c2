// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/Theme.h"

namespace robotcontrol {
class LinkStatus;
}

namespace widgets {

/// The status of a link in words, translated.
struct LinkWords {
  /// "connected", "lost", "waits for a client".
  QString state;
  /// The color of the state.
  Meaning meaning = Meaning::kMuted;
  /// Name, class and subclass from the handshake: "MobileSim, Pioneer, p3at-sh"; may be empty.
  QString robot;
  /// The client of a simulated robot and its commands per second; may be empty.
  QString client;
  /// Whether information packets were more than 250 ms apart, from which on clients with ARIA warn.
  bool longGap = false;
};

/// `age`: seconds since the status was published; from 3 s on the text says so.
LinkWords linkWords(const robotcontrol::LinkStatus& status, double age);

}  // namespace widgets
