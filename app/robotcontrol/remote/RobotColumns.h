// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// The columns of the table of RobotsDialog.
enum RobotColumn {
  kSetName,
  kSetTeam,
  kSetRole,
  kSetAddress,
  kSetLayout,
  kSetColorTable,
  kSetParameters,
  kSetMotions,
  kSetPreset,
  kSetState,
};

}  // namespace app
