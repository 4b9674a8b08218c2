// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Tournament.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace app {
namespace {

using nlohmann::json;

/// Seconds after which a module counts as not returning: on a busy machine a game must not be played without
/// a robot whose program merely had to wait.
constexpr char kGamePatience[] = "60";
constexpr char kLayoutPart[] = "layout", kPresetPart[] = "preset";

/// The share of a win that a game counts as.
double shareOfWin(int own, int other) {
  if (own == other) return 0.5;
  return own > other ? 1 : 0;
}

/// Returns the output about the robots of one color, as if they had been alone.
json errorsOf(const json& printed, const std::string& color) {
  json part = json::object();
  if (!printed.contains("errors")) return part;
  for (const auto& player : printed["game"].value("players", json::array())) {
    const std::string robot = player.value("robot", "");
    if (player.value("team", "") == color && printed["errors"].contains(robot))
      part["errors"][robot] = printed["errors"][robot];
  }
  return part;
}

void addPlayerFigures(const json& printed, const std::string& color, std::vector<Figure>& figures) {
  double penalties = 0, outside = 0, fallen = 0;
  for (const auto& player : printed["game"].value("players", json::array())) {
    if (player.value("team", "") != color) continue;
    penalties += player.value("penalties", 0.0);
    outside = std::max(outside, player.value("longest_outside_seconds", 0.0));
    fallen += player.value("fallen_seconds", 0.0);
  }
  figures.push_back({"penalties", "", penalties});
  figures.push_back({"longest time outside", "s", outside});
  figures.push_back({"time lying, of all robots", "s", fallen});
}

}  // namespace

robotlink::Result<TeamChoice> TeamChoice::parse(const std::string& text) {
  TeamChoice team;
  std::string parts = text;
  if (const auto colon = text.find(':'); colon != std::string::npos) {
    team.name = text.substr(0, colon);
    parts = text.substr(colon + 1);
  } else {
    team.name = text;
  }
  std::istringstream stream(parts);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto equals = part.find('=');
    const std::string key = equals == std::string::npos ? kLayoutPart : part.substr(0, equals);
    const std::string value = equals == std::string::npos ? part : part.substr(equals + 1);
    if (key.empty() || value.empty())
      return robotlink::failure(
          "usage", "a team is NAME:LAYOUT,TASK=SOLUTION,preset=PRESET, each of which may be left out, not '" +
                       text + "'");
    std::string& chosen = key == kLayoutPart   ? team.layout
                          : key == kPresetPart ? team.preset
                                               : team.solutions[key];
    if (!chosen.empty())
      return robotlink::failure(
          "usage", "the team '" + text + "' has two of " + key + ": " + chosen + " and " + value);
    chosen = value;
  }
  if (team.name.empty()) return robotlink::failure("usage", "the team '" + text + "' has no name");
  return team;
}

std::vector<std::string> TeamChoice::optionsFor(const std::string& color) const {
  std::vector<std::string> options;
  const auto add = [&](const char* option, const std::string& value) {
    options.emplace_back(option);
    options.push_back(value);
  };
  if (!layout.empty()) add("--layout", color + "=" + wholePath(layout));
  for (const auto& [task, solution] : solutions) add("--solution", color + "/" + task + "=" + solution);
  if (!preset.empty()) add("--preset", color + "=" + wholePath(preset));
  return options;
}

PlannedRun Tournament::run(int game) const {
  const TeamChoice& first = teams[teamOf(game, 0)];
  const TeamChoice& second = teams[teamOf(game, 1)];
  PlannedRun run{first.name + " against " + second.name, fmt::format("game {}", game + 1), {}};
  run.arguments = {"sim",        wholePath(scene),
                   "--threads",  "1",
                   "--seconds",  fmt::format("{}", seconds),
                   "--seed",     std::to_string(seedOf(game)),
                   "--patience", kGamePatience,
                   "--json"};
  for (std::size_t color = 0; color < colors.size(); ++color)
    std::ranges::move(teams[teamOf(game, color)].optionsFor(colors[color]),
                      std::back_inserter(run.arguments));
  if (errors) run.arguments.emplace_back("--errors");
  run.arguments.insert(run.arguments.end(), options.begin(), options.end());
  return run;
}

std::vector<PlannedRun> Tournament::runs() const {
  std::vector<PlannedRun> all;
  for (int game = 0; game < games; ++game) all.push_back(run(game));
  return all;
}

robotlink::Result<void> TournamentTable::add(int game, const json& printed) {
  const json score = printed.value("score", json::object());
  Game played{.number = game + 1, .seed = tournament_.seedOf(game), .teams = {}, .goals = {}, .digest = {}};
  for (std::size_t color = 0; color < tournament_.colors.size(); ++color) {
    const std::string& name = tournament_.colors[color];
    if (!score.contains(name) || !score[name].is_number_integer() || !printed.contains("game"))
      return robotlink::failure("tournament.score",
                                fmt::format("game {} has no score of the team {}: is there a referee in the "
                                            "scene?",
                                            game + 1, name));
    played.teams[color] = tournament_.teams[Tournament::teamOf(game, color)].name;
    played.goals[color] = score[name].get<int>();
  }
  played.digest = printed.value("digest", "");
  for (std::size_t color = 0; color < tournament_.colors.size(); ++color) {
    const int own = played.goals[color], other = played.goals[1 - color];
    std::vector<Figure> figures{{"games won", "", shareOfWin(own, other)},
                                {"goals", "", static_cast<double>(own)},
                                {"goals conceded", "", static_cast<double>(other)}};
    addPlayerFigures(printed, tournament_.colors[color], figures);
    std::ranges::move(figuresIn(errorsOf(printed, tournament_.colors[color])), std::back_inserter(figures));
    figures_.add(played.teams[color], fmt::format("game {}", played.number), figures);
  }
  games_.push_back(std::move(played));
  return {};
}

std::array<TournamentTable::Standing, 2> TournamentTable::standings() const {
  std::array<Standing, 2> standings;
  for (std::size_t team = 0; team < standings.size(); ++team) {
    Standing& one = standings[team];
    one.team = tournament_.teams[team].name;
    for (const Game& game : games_) {
      const std::size_t color = game.teams[0] == one.team ? 0 : 1;
      const int own = game.goals[color], other = game.goals[1 - color];
      one.goals += own;
      one.conceded += other;
      ++(own > other ? one.wins : own < other ? one.losses : one.draws);
    }
  }
  return standings;
}

std::string TournamentTable::csv() const {
  std::string text = fmt::format("game,seed,{0},{1},goals of {0},goals of {1},digest\n",
                                 tournament_.colors[0], tournament_.colors[1]);
  for (const Game& game : games_)
    text += fmt::format("{},{},{},{},{},{},{}\n", game.number, game.seed, csvField(game.teams[0]),
                        csvField(game.teams[1]), game.goals[0], game.goals[1], game.digest);
  return text;
}

json TournamentTable::asJson() const {
  nlohmann::json all{{"scene", tournament_.scene},
                     {"seconds", tournament_.seconds},
                     {"games", nlohmann::json::array()},
                     {"standings", nlohmann::json::array()}};
  for (const Game& game : games_) {
    nlohmann::json one{{"game", game.number}, {"seed", game.seed}, {"digest", game.digest}};
    for (std::size_t color = 0; color < game.teams.size(); ++color)
      one[tournament_.colors[color]] = {{"team", game.teams[color]}, {"goals", game.goals[color]}};
    all["games"].push_back(std::move(one));
  }
  for (const Standing& one : standings())
    all["standings"].push_back({{"team", one.team},
                                {"wins", one.wins},
                                {"draws", one.draws},
                                {"losses", one.losses},
                                {"goals", one.goals},
                                {"conceded", one.conceded}});
  return all;
}

std::vector<ReportTable> TournamentTable::tables() const {
  ReportTable standing{"Standings", {{"team", "won", "drawn", "lost", "goals"}}};
  for (const Standing& one : standings())
    standing.rows.push_back({one.team, std::to_string(one.wins), std::to_string(one.draws),
                             std::to_string(one.losses), fmt::format("{} : {}", one.goals, one.conceded)});
  ReportTable played{"Games", {{"game", "seed", tournament_.colors[0], tournament_.colors[1], "score"}}};
  for (const Game& game : games_)
    played.rows.push_back({std::to_string(game.number), std::to_string(game.seed), game.teams[0],
                           game.teams[1], fmt::format("{} : {}", game.goals[0], game.goals[1])});
  return {standing, played};
}

}  // namespace app
