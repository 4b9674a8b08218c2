// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl tournament`: which of two teams plays better soccer.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/compare/RunExecution.h"
#include "app/robotctl/compare/Tournament.h"
#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

struct TournamentArguments {
  std::string first, second;
  Tournament tournament{.scene = "game2002"};
  RunExecution execution{.seconds = 240};
  bool asJson = false;
};

int wrongTournament(const std::string& text) {
  std::cerr << "robotctl tournament: " << text << "\n";
  return kUsage;
}

std::string commandOf(const TournamentArguments& arguments) {
  const Tournament& tournament = arguments.tournament;
  std::vector<std::string> words{"robotctl",      "tournament",
                                 arguments.first, arguments.second,
                                 "--games",       std::to_string(tournament.games),
                                 "--scene",       tournament.scene,
                                 "--seconds",     fmt::format("{}", tournament.seconds),
                                 "--seed",        std::to_string(tournament.firstSeed)};
  if (tournament.errors) words.emplace_back("--errors");
  words.insert(words.end(), {"--out", arguments.execution.out});
  if (!tournament.options.empty()) words.emplace_back("--");
  words.insert(words.end(), tournament.options.begin(), tournament.options.end());
  return shellLine(words);
}

void printStandings(const TournamentTable& table) {
  for (const auto& one : table.standings())
    std::cout << fmt::format("{}: {} won, {} drawn, {} lost, goals {} : {}\n", one.team, one.wins, one.draws,
                             one.losses, one.goals, one.conceded);
}

robotlink::Result<void> writeTournament(const TournamentArguments& arguments, const TournamentTable& table,
                                        const std::vector<std::string>& missing) {
  const std::filesystem::path folder = arguments.execution.out;
  const Tournament& tournament = arguments.tournament;
  const ReportTitle title{tournament.teams[0].name + " against " + tournament.teams[1].name,
                          commandOf(arguments), missing, table.tables()};
  if (auto written = writeReport(folder, table.figures(), title); !written) return written;
  if (auto written = robotlink::writeFileAtomically(folder / "games.csv", table.csv()); !written)
    return written;
  return robotlink::writeFileAtomically(folder / "tournament.json", jsonOutput(table.asJson()));
}

int playTournament(TournamentArguments& arguments) {
  Tournament& tournament = arguments.tournament;
  const auto one = TeamChoice::parse(arguments.first), other = TeamChoice::parse(arguments.second);
  if (!one || !other) return wrongTournament((one ? other : one).error().text);
  if (one->name == other->name)
    return wrongTournament("both teams are called '" + one->name + "'; name them, as in a:" + one->name);
  tournament.teams = {*one, *other};
  tournament.firstSeed = arguments.execution.firstSeed;
  tournament.seconds = arguments.execution.seconds;
  tournament.options = arguments.execution.options;
  TournamentTable table(tournament), tried(tournament);
  const auto addTo = [&](TournamentTable& games, const auto& results) -> robotlink::Result<void> {
    for (const auto& [run, printed] : results) {
      int game = 0;
      while (tournament.run(game).subject != run.subject) ++game;
      if (auto added = games.add(game, printed); !added) return added;
    }
    return {};
  };
  const auto first = arguments.execution.tryOut(tournament.runs());
  if (!first) return printErrors({first.error()});
  if (const auto added = addTo(tried, first->results); !added) return printErrors({added.error()});
  const auto results = arguments.execution.execute(tournament.runs());
  if (!results) return printErrors({results.error()});
  if (const auto added = addTo(table, results->results); !added) return printErrors({added.error()});
  if (auto written = writeTournament(arguments, table, results->missing); !written)
    return printErrors({written.error()});
  if (arguments.asJson) {
    std::cout << jsonOutput(table.asJson());
  } else {
    printStandings(table);
    printDifferences(table.figures());
    std::cout << (std::filesystem::path(arguments.execution.out) / "report.html").string() << "\n";
  }
  return results->missing.empty() ? kDone : kFailed;
}

}  // namespace

void addTournamentCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<TournamentArguments>();
  CLI::App* command = app.add_subcommand(
      "tournament", "Plays games between two teams of simulated robots, and reports which is better");
  command
      ->add_option("team", arguments->first,
                   "What the robots of a team run: NAME:LAYOUT,TASK=SOLUTION,preset=PRESET, each of which "
                   "may be left out")
      ->required();
  command->add_option("opponent", arguments->second, "The same for the other team")->required();
  command
      ->add_option("--games", arguments->tournament.games,
                   "Number of games; in every second one the sides are swapped, with the same seed")
      ->check(numberFrom(1, 100000))
      ->capture_default_str();
  command
      ->add_option("--scene", arguments->tournament.scene, "A scene with two teams and the rules of a game")
      ->capture_default_str();
  command->add_flag("--errors", arguments->tournament.errors,
                    "Adds the errors of both teams' percepts and models against the ground truth");
  command->add_flag("--json", arguments->asJson, "Prints games and standings as one JSON object");
  arguments->execution.addOptionsTo(*command);
  arguments->execution.addTo(*command);
  command->callback(
      [arguments, &status] { status = withResources([&] { return playTournament(*arguments); }); });
}

}  // namespace app
