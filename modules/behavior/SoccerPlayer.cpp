// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/SoccerPlayer.h"

#include "modules/behavior/SoccerOptions.h"

namespace modules {

SoccerPlayer::SoccerPlayer(const robotlink::FieldDescription& field, const Options& options)
    : mind_(field, options) {
  SoccerOptions(mind_).build();
}

}  // namespace modules
