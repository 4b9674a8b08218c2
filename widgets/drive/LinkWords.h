// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/models/Theme.h"

namespace robotcontrol {
class LinkStatus;
}

namespace widgets {

/// What a link's status means, in words.
struct LinkWords {
  QString state;  ///< "connected", "lost, trying again"
  Meaning meaning = Meaning::kMuted;
  QString robot;         ///< "MobileSim, Pioneer, p3at-sh"; may be empty
  QString client;        ///< of a simulated robot: who drives it; may be empty
  bool longGap = false;  ///< information packets came too far apart for a client to be happy
};

/// `age`: seconds since the status was told.
LinkWords linkWords(const robotcontrol::LinkStatus& status, double age);

}  // namespace widgets
