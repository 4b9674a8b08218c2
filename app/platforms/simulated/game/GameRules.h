// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"

namespace app {

/// The transmission of messages between robots of a team.
struct RadioSettings {
  /// m; 0: without limit.
  double range = 0;
  /// s.
  double delay = 0;
  /// The share of messages that do not arrive.
  double loss = 0;

  bool operator==(const RadioSettings&) const = default;
};

/// The rules of a simulated game, as read from a file like resources/games/2002.yaml. Meters, in the
/// field's frame; places are those of the team that plays toward +x. A plain value.
struct GameRules {
  /// The fouls that the referee notices by itself.
  enum class Watch : std::uint8_t { kNothing, kLeaving, kPushing, kDefending, kHolding };
  enum class Placing : std::uint8_t { kAll, kIllegal };
  /// The reason for taking a robot out of the game, and for how long.
  struct Penalty {
    std::string reason;
    Watch watch = Watch::kNothing;
    /// The time for which it must have lasted, if it is watched.
    robotlink::Duration after{};
    robotlink::Duration time{};
  };

  std::string title;
  /// Two; the first one plays toward +x in the first half.
  std::vector<std::string> teams;

  unsigned halves = 2;
  robotlink::Duration half{}, pause{};
  bool switchSides = false;
  /// The durations of these phases.
  robotlink::Duration initial{}, ready{}, set{};

  Placing placing = Placing::kAll;
  robotlink::Vector2 goalie = robotlink::Vector2::Zero();
  /// The places of the others, for a team with and without the kick-off; not empty.
  std::vector<robotlink::Vector2> kicking, waiting;

  robotlink::Duration ballOut{}, ballStuck{};
  double ballInset = 0, stuckDistance = 0;
  /// The places to which a stuck ball may be put, in the field's frame for both teams.
  std::vector<robotlink::Vector2> drops;

  /// The penalties; not empty.
  std::vector<Penalty> penalties;
  /// m/s, and m.
  double pushingSpeed = 0, pushingNearBall = 0;
  double leavingMargin = 0;
  /// A ball that is nearer to the middle of a robot lies under it, m.
  double holdingDistance = 0;
  /// The distances of penalized robots from the field's edge, and from each other.
  double besideField = 0, besideSpacing = 0;

  RadioSettings radio;

  /// Null if there is no such reason.
  const Penalty* penalty(std::string_view reason) const;
  /// The penalty for what is watched; null if it is not.
  const Penalty* penaltyFor(Watch watch) const;

  /// Reads a file. Every problem is reported with its line; ids begin with "game.", "yaml." or "file.".
  static tl::expected<GameRules, robotlink::Errors> load(const std::filesystem::path& file);
  static tl::expected<GameRules, robotlink::Errors> parse(std::string_view text, std::string file);
};

/// Takes the place of a name of rules where a game has no referee.
inline constexpr char kNoGame[] = "none";
/// The file of shipped rules by their name ("2002"), or any other by its path.
std::filesystem::path gameRulesNamed(const std::string& name);

}  // namespace app
