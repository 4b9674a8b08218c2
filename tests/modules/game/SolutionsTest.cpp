// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for all registered solutions of the robot program.
#include <gmock/gmock.h>
#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "robotlink/debugging/Solution.h"
#include "tests/modules/game/PlayedGame.h"

namespace modules {
namespace {

using robotlink::SolutionDescription;
using robotlink::SolutionRegistry;

TEST(Solutions, offerTwoWaysToDoEachTaskAndSayWhatTheyDo) {
  std::map<std::string, int> counts;
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    ++counts[solution.task];
    EXPECT_TRUE(solution.help.ends_with(".")) << solution.task << "/" << solution.name;
  }
  for (const auto& described : robotlink::describedTasks()) {
    EXPECT_GE(counts[described.task], 2) << described.task;
    EXPECT_FALSE(described.help.empty());
  }
  EXPECT_EQ(counts.size(), robotlink::describedTasks().size());
}

TEST(Solutions, sayWhoseMethodTheyAreAndCanBeLookedInto) {
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    const std::string name = solution.task + "/" + solution.name;
    EXPECT_GT(solution.help.size(), 10U) << name;
    EXPECT_TRUE(solution.source.ends_with(".")) << name;
    EXPECT_FALSE(solution.outputs.empty()) << name;
    const auto publishes = [&](const char* kind) {
      return std::ranges::any_of(solution.keys, [&](int key) {
        return robotlink::DebugKey::all()[static_cast<std::size_t>(key)].stream.starts_with(kind);
      });
    };
    EXPECT_TRUE(publishes("plots/")) << name;
    EXPECT_TRUE(publishes("drawings/")) << name;
  }
}

TEST(Solutions, haveDefaultsForAllTheirParameters) {
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/resources/parameters";
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    if (solution.parameters == nullptr) continue;
    // They are in the folder of the robot that it is for.
    const std::string name = solution.task + "." + solution.name + ".textproto";
    std::filesystem::path file;
    for (const char* robot : {"ers210", "p3at", "camera"}) {
      if (std::filesystem::exists(folder / robot / name)) file = folder / robot / name;
    }
    std::ifstream stream(file);
    ASSERT_TRUE(stream) << name;
    std::stringstream text;
    text << stream.rdbuf();
    const std::unique_ptr<google::protobuf::Message> parameters(solution.parameters->New());
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text.str(), parameters.get())) << file;
  }
}

/// Plays with these solutions and all their debug keys on, and returns the keys that never told anything.
std::vector<std::string> silentKeys(PlayedGame::Solutions solutions) {
  PlayedGame game(solutions);
  std::set<std::string> keys;
  for (const auto& [task, name] : solutions)
    for (const int key : SolutionRegistry::find(task, name)->keys)
      keys.insert(robotlink::DebugKey::all()[static_cast<std::size_t>(key)].name);
  for (const std::string& key : keys) game.publish(key);
  game.placeBall({-0.1, 0.2});
  game.run(3);
  std::vector<std::string> silent;
  for (const std::string& key : keys) {
    const auto publishs = [&](const std::string& path) { return path.find("/" + key) != std::string::npos; };
    if (std::ranges::none_of(game.paths(), publishs)) silent.push_back(key);
  }
  return silent;
}

TEST(Solutions, tellSomethingUnderEachOfTheirKeys) {
  EXPECT_THAT(silentKeys({{"segmentation", "scan-lines"},
                          {"camera-pose", "kinematic"},
                          {"ball-percept", "circle-fit"},
                          {"landmark-percepts", "color-bands"},
                          {"line-percepts", "ransac-segments"},
                          {"robot-state", "joint-errors"},
                          {"players-model", "kalman"},
                          {"ball-model", "particle"},
                          {"self-localisation", "landmarks"},
                          {"behavior", "go-to-ball-and-kick"}}),
              testing::IsEmpty());
}

TEST(Solutions, ofTheOtherKindTellSomethingToo) {
  EXPECT_THAT(silentKeys({{"segmentation", "whole-image"},
                          {"camera-pose", "fixed-stance"},
                          {"ball-percept", "region"},
                          {"landmark-percepts", "horizon-scan"},
                          {"line-percepts", "edge-points"},
                          {"robot-state", "contacts"},
                          {"players-model", "grid"},
                          {"ball-model", "kalman"},
                          {"self-localisation", "odometry"}}),
              testing::IsEmpty());
}

TEST(Solutions, thatAreTheOracleTellSomethingToo) {
  EXPECT_THAT(silentKeys({{"line-percepts", "oracle"}, {"robot-state", "oracle"}}), testing::IsEmpty());
}

TEST(Solutions, canBeSwitchedWhileTheRobotPlays) {
  PlayedGame game;
  game.placeBall({0.3, 0.3});
  for (const char* solution : {"circle-fit", "region", "circle-fit"}) {
    game.select("ball-percept", solution);
    game.run(1);
  }
  game.select("segmentation", "whole-image");
  game.select("self-localisation", "oracle");
  while (game.ballContacts() == 0 && game.time() < 40) game.run(0.5);
  EXPECT_GT(game.ballContacts(), 0U);
}

}  // namespace
}  // namespace modules
