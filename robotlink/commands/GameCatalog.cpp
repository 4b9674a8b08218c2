// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the catalog about the referee of a simulated game.
#include "robotlink/commands/CommandCatalog.h"

namespace robotlink {

std::vector<CommandTable::Command> gameCatalog() {
  using Type = CommandTable::Type;
  return {
      {"game.ready", "Sends the robots to their kick-off positions; starts a new half if one is over"},
      {"game.set", "Places the robots at their positions and the ball at the center; the robots wait"},
      {"game.play", "Starts play"},
      {"game.finish", "Ends the half"},
      {"game.restart", "Starts the game over: no goals, first half, nobody is penalized"},
      {"game.penalize",
       "Takes a robot out of the game for the time that the rules set",
       {{"robot", Type::kText, "its name"},
        {"reason", Type::kText, "a penalty of the rules; '': the first one", std::string()}}},
      {"game.return", "Puts a penalized robot back into the game", {{"robot", Type::kText, "its name"}}},
      {"game.score",
       "Sets the goals of a team",
       {{"team", Type::kText, "its name"}, {"goals", Type::kNumber, "how many, 0 to 99"}}},
      {"game.kick-off", "Gives a team the kick-off", {{"team", Type::kText, "its name"}}},
      {"game.automatic",
       "Chooses whether the referee decides by itself: phases, goals, balls out, penalties",
       {{"on", Type::kBool, "off: the referee acts only on commands", true}}},
      {"game.radio",
       "Sets range, delay and losses of the radio between robots of a team",
       {{"range", Type::kNumber, "m; 0: without limit"},
        {"delay", Type::kNumber, "s, 0 to 10", 0.0},
        {"loss", Type::kNumber, "fraction of messages that are lost, 0 to 1", 0.0}}},
  };
}

}  // namespace robotlink
