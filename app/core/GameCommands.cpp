// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/GameCommands.h"

#include <algorithm>
#include <cmath>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using robotcontrol::ControlGame;
using robotlink::CommandTable;
using robotlink::Result;
using Names = std::vector<std::string>;

const robotcontrol::GameStatus* shownGame(OpenPlatform& open) {
  return open.session().store().latestAs<robotcontrol::GameStatus>(robotlink::streams::kGame,
                                                                   open.session().timeline().newest());
}

Result<void> askReferee(OpenPlatform& open, const ControlGame& control) {
  robotcontrol::Request request;
  *request.mutable_control_game() = control;
  if (const std::string wrong = robotlink::wrongWith(request); !wrong.empty())
    return robotlink::failure("game.request", wrong);
  open.ask(std::move(request));
  return {};
}

Result<void> setScoreOf(OpenPlatform& open, const std::string& team, double goals) {
  if (!(goals >= 0) || goals != std::floor(goals))
    return robotlink::failure("game.request", "the number of goals must be a whole number, 0 or more");
  ControlGame control;
  control.set_action(ControlGame::SCORE);
  control.set_team(team);
  control.set_goals(static_cast<std::uint32_t>(std::min(goals, 1e6)));
  return askReferee(open, control);
}

Names shownPlayers(OpenPlatform& open) {
  Names names;
  if (const auto* game = shownGame(open)) {
    for (const auto& player : game->players()) names.push_back(player.robot());
  }
  return names;
}

Names teamsOf(OpenPlatform& open) {
  Names names;
  if (const auto* game = shownGame(open)) {
    for (const auto& team : game->state().teams()) names.push_back(team.name());
  }
  return names;
}

Names reasonsOf(OpenPlatform& open) {
  const auto* game = shownGame(open);
  return game == nullptr ? Names() : Names(game->reasons().begin(), game->reasons().end());
}

void addPlayerCommands(CommandTable& commands, OpenPlatform& open) {
  commands.attach(
      "game.penalize",
      [&open](const Values& values) {
        ControlGame control;
        control.set_action(ControlGame::PENALIZE);
        control.set_robot(text(values, 0));
        control.set_reason(text(values, 1));
        return askReferee(open, control);
      },
      [&open](const auto& before) { return before.empty() ? shownPlayers(open) : reasonsOf(open); });
  commands.attach(
      "game.return",
      [&open](const Values& values) {
        ControlGame control;
        control.set_action(ControlGame::RETURN);
        control.set_robot(text(values, 0));
        return askReferee(open, control);
      },
      [&open](const auto& before) { return before.empty() ? shownPlayers(open) : Names(); });
}

void addTeamCommands(CommandTable& commands, OpenPlatform& open) {
  const auto teams = [&open](const auto& before) { return before.empty() ? teamsOf(open) : Names(); };
  commands.attach(
      "game.score",
      [&open](const Values& values) { return setScoreOf(open, text(values, 0), number(values, 1)); }, teams);
  commands.attach(
      "game.kick-off",
      [&open](const Values& values) {
        ControlGame control;
        control.set_action(ControlGame::KICK_OFF);
        control.set_team(text(values, 0));
        return askReferee(open, control);
      },
      teams);
}

}  // namespace

void addGameCommands(CommandTable& commands, OpenPlatform& open) {
  const auto action = [&](const char* name, ControlGame::Action what) {
    commands.attach(name, [&open, what](const Values&) {
      ControlGame control;
      control.set_action(what);
      return askReferee(open, control);
    });
  };
  action("game.ready", ControlGame::READY);
  action("game.set", ControlGame::SET);
  action("game.play", ControlGame::PLAY);
  action("game.finish", ControlGame::FINISH);
  action("game.restart", ControlGame::RESTART);
  addPlayerCommands(commands, open);
  addTeamCommands(commands, open);
  commands.attach("game.automatic", [&open](const Values& values) {
    ControlGame control;
    control.set_action(ControlGame::AUTOMATIC);
    control.set_on(flag(values, 0));
    return askReferee(open, control);
  });
  commands.attach("game.radio", [&open](const Values& values) {
    ControlGame control;
    control.set_action(ControlGame::RADIO);
    control.mutable_radio()->set_range(number(values, 0));
    control.mutable_radio()->set_delay(number(values, 1));
    control.mutable_radio()->set_loss(number(values, 2));
    return askReferee(open, control);
  });
}

}  // namespace app
