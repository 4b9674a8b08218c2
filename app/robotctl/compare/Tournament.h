// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/robotctl/compare/CompareReport.h"
#include "app/robotctl/compare/Comparison.h"
#include "app/robotctl/compare/RunPlan.h"
#include "robotlink/base/Error.h"

namespace app {

/// A team as a user writes it: "NAME:LAYOUT,TASK=SOLUTION,preset=PRESET". The name
/// may be left out, as may each of the parts. A plain value.
struct TeamChoice {
  std::string name;
  /// Empty: that of the scene.
  std::string layout;
  std::map<std::string, std::string> solutions;
  /// Empty: none.
  std::string preset;

  static robotlink::Result<TeamChoice> parse(const std::string& text);
  /// The options of `robotctl sim` by which the robots of a color run it.
  std::vector<std::string> optionsFor(const std::string& color) const;
};

/// Games between two teams in a scene whose teams have two colors. In each second game the sides are swapped,
/// with the seed of the game before, so that neither side nor luck favors a team. A plain value.
struct Tournament {
  std::array<TeamChoice, 2> teams = {};
  /// The names of the two teams in the scene.
  std::array<std::string, 2> colors{"red", "blue"};
  std::string scene;
  int games = 10;
  std::uint64_t firstSeed = 1;
  double seconds = 240;
  /// Whether it is also measured how far percepts and models are from the truth.
  bool errors = false;
  /// Options of `robotctl sim` for each game.
  std::vector<std::string> options = {};

  /// The index of the team that has a color, by the index of that, in a game that counts from 0.
  static std::size_t teamOf(int game, std::size_t color) {
    return (static_cast<std::size_t>(game) + color) % 2;
  }
  std::uint64_t seedOf(int game) const { return firstSeed + static_cast<std::uint64_t>(game / 2); }
  std::vector<PlannedRun> runs() const;
  PlannedRun run(int game) const;
};

/// The games of a tournament that were played.
class TournamentTable {
 public:
  struct Game {
    /// From 1.
    int number = 0;
    std::uint64_t seed = 0;
    /// The names of the teams, and their goals, each by the color in which it played.
    std::array<std::string, 2> teams;
    std::array<int, 2> goals{};
    std::string digest;
  };
  struct Standing {
    std::string team;
    int wins = 0, draws = 0, losses = 0, goals = 0, conceded = 0;
  };

  /// The tournament must outlive it.
  explicit TournamentTable(const Tournament& tournament) : tournament_(tournament) {}

  /// Adds what a game, counted from 0, has printed. Fails if that has no score.
  robotlink::Result<void> add(int game, const nlohmann::json& printed);
  const std::vector<Game>& games() const { return games_; }
  std::array<Standing, 2> standings() const;
  /// The figures of both teams, each game a subject: goals, goals conceded, share of wins (a draw is half a
  /// one), penalties, time outside and lying, and errors if they were measured.
  const Comparison& figures() const { return figures_; }

  std::string csv() const;
  nlohmann::json asJson() const;
  std::vector<ReportTable> tables() const;

 private:
  const Tournament& tournament_;
  std::vector<Game> games_;
  Comparison figures_;
};

}  // namespace app
