// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameRules.h"

#include <algorithm>

#include "robotlink/base/Resources.h"
#include "robotlink/config/YamlReader.h"

namespace app {
namespace {

using robotlink::Duration;
using robotlink::Vector2;
using robotlink::YamlNode;

constexpr double kMaxGameSeconds = 1e5, kMaxGamePlace = 100;

Duration secondsAt(const YamlNode& node, std::string_view key) {
  return robotlink::fromSeconds(node.numberIn(key, 0, kMaxGameSeconds));
}

Vector2 placeIn(const YamlNode& node) {
  const auto numbers = node.as<std::vector<double>>();
  const bool isPlace = numbers.size() == 2 && std::ranges::all_of(numbers, [](double number) {
                         return std::abs(number) <= kMaxGamePlace;
                       });
  if (!isPlace) {
    node.fail("game.place", "a place is two numbers, x and y in m");
    return Vector2::Zero();
  }
  return {numbers[0], numbers[1]};
}

std::vector<Vector2> placesAt(const YamlNode& node, std::string_view key) {
  std::vector<Vector2> places;
  const YamlNode list = node.child(key);
  for (const YamlNode& item : list.items()) places.push_back(placeIn(item));
  if (places.empty()) list.fail("game.places", "at least one place is needed");
  return places;
}

/// Returns the value of the word in the node; that of the first word after a failure.
template <class T>
T wordOf(const YamlNode& node, const std::vector<std::pair<const char*, T>>& words) {
  const auto word = node.as<std::string>();
  std::string known;
  for (const auto& [name, value] : words) {
    if (word == name) return value;
    known += (known.empty() ? "" : " or ") + std::string(name);
  }
  if (!node.empty()) node.fail("game.word", "this is " + known + ", not '" + word + "'", {word});
  return words.front().second;
}

void readTimes(const YamlNode& root, GameRules& rules) {
  const YamlNode teams = root.child("teams");
  rules.teams = teams.as<std::vector<std::string>>();
  if (rules.teams.size() != 2 || rules.teams[0] == rules.teams[1]) {
    teams.fail("game.teams", "two teams play against each other");
    rules.teams = {"1", "2"};
  }
  const YamlNode halves = root.child("halves");
  rules.halves = static_cast<unsigned>(halves.wholeNumberIn("count", 1, 10));
  rules.half = robotlink::fromSeconds(halves.numberIn("seconds", 1, kMaxGameSeconds));
  rules.pause = secondsAt(halves, "pause");
  rules.switchSides = halves.required<bool>("switch_sides");
  const YamlNode phases = root.child("phases");
  rules.initial = secondsAt(phases, "initial");
  rules.ready = secondsAt(phases, "ready");
  rules.set = secondsAt(phases, "set");
}

void readKickOff(const YamlNode& node, GameRules& rules) {
  rules.placing = wordOf<GameRules::Placing>(
      node.child("placing"), {{"all", GameRules::Placing::kAll}, {"illegal", GameRules::Placing::kIllegal}});
  rules.goalie = placeIn(node.child("goalie"));
  rules.kicking = placesAt(node, "kicking");
  rules.waiting = placesAt(node, "waiting");
}

void readBall(const YamlNode& node, GameRules& rules) {
  rules.ballOut = secondsAt(node, "out_seconds");
  rules.ballInset = node.numberIn("inset", 0, 10);
  rules.ballStuck = secondsAt(node, "stuck_seconds");
  rules.stuckDistance = node.numberIn("stuck_distance", 0, 10);
  rules.drops = placesAt(node, "drops");
}

void readPenalty(const YamlNode& node, GameRules& rules) {
  GameRules::Penalty penalty;
  penalty.reason = node.required<std::string>("reason");
  penalty.time = secondsAt(node, "seconds");
  if (const YamlNode watch = node.optionalChild("watch"); !watch.empty()) {
    penalty.watch = wordOf<GameRules::Watch>(watch, {{"leaving", GameRules::Watch::kLeaving},
                                                     {"pushing", GameRules::Watch::kPushing},
                                                     {"defending", GameRules::Watch::kDefending},
                                                     {"holding", GameRules::Watch::kHolding}});
    penalty.after = secondsAt(node, "after");
  }
  if (penalty.reason.empty() || rules.penalty(penalty.reason) != nullptr)
    node.fail("game.reason", "each penalty has a reason of its own");
  rules.penalties.push_back(std::move(penalty));
}

void readPenalties(const YamlNode& root, GameRules& rules) {
  const YamlNode penalties = root.child("penalties");
  for (const YamlNode& node : penalties.items()) readPenalty(node, rules);
  if (rules.penalties.empty()) penalties.fail("game.penalties", "at least one penalty is needed");
  const YamlNode pushing = root.child("pushing");
  rules.pushingSpeed = pushing.numberIn("speed", 0, 10);
  rules.pushingNearBall = pushing.numberIn("near_ball", 0, 10);
  rules.leavingMargin = root.child("leaving").numberIn("margin", 0, 10);
  // Older files do not have it, and need it only if they watch for it.
  const bool isHoldingWatched = rules.penaltyFor(GameRules::Watch::kHolding) != nullptr;
  if (isHoldingWatched || !root.optionalChild("holding").empty())
    rules.holdingDistance = root.child("holding").numberIn("distance", 0.01, 10);
  const YamlNode penalized = root.child("penalized");
  rules.besideField = penalized.numberIn("beside", 0, 10);
  rules.besideSpacing = penalized.numberIn("spacing", 0.01, 10);
}

tl::expected<GameRules, robotlink::Errors> readRules(robotlink::Result<robotlink::YamlReader> reader) {
  if (!reader) return tl::unexpected(robotlink::Errors{reader.error()});
  const YamlNode root = reader->root();
  GameRules rules;
  if (const YamlNode version = root.child("version"); version.as<int>() != 1)
    version.fail("game.version", "this program reads games of version 1");
  rules.title = root.required<std::string>("title");
  readTimes(root, rules);
  readKickOff(root.child("kick_off"), rules);
  readBall(root.child("ball"), rules);
  readPenalties(root, rules);
  const YamlNode radio = root.child("radio");
  rules.radio = {radio.numberIn("range", 0, 1000), radio.numberIn("delay", 0, 10),
                 radio.numberIn("loss", 0, 1)};
  if (auto finished = reader->finish(); !finished) return tl::unexpected(std::move(finished.error()));
  return rules;
}

}  // namespace

const GameRules::Penalty* GameRules::penalty(std::string_view reason) const {
  const auto found = std::ranges::find(penalties, reason, &Penalty::reason);
  return found == penalties.end() ? nullptr : &*found;
}

const GameRules::Penalty* GameRules::penaltyFor(Watch watch) const {
  const auto found = std::ranges::find(penalties, watch, &Penalty::watch);
  return found == penalties.end() ? nullptr : &*found;
}

tl::expected<GameRules, robotlink::Errors> GameRules::load(const std::filesystem::path& file) {
  return readRules(robotlink::YamlReader::load(file));
}

tl::expected<GameRules, robotlink::Errors> GameRules::parse(std::string_view text, std::string file) {
  return readRules(robotlink::YamlReader::parse(text, std::move(file)));
}

std::filesystem::path gameRulesNamed(const std::string& name) {
  const bool isPath = name.find('/') != std::string::npos || name.ends_with(".yaml");
  return isPath ? std::filesystem::path(name) : robotlink::resource("games/" + name + ".yaml");
}

}  // namespace app
