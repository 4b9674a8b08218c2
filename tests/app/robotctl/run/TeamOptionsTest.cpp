// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/TeamOptions.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/session/Presets.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotlink::Preset;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a command line says about the robots' programs.
class TeamOptionsTest : public testing::Test {
 protected:
  TeamOptionsTest() { options_.addTo(command_); }
  /// A preset that sets one debug key.
  std::string preset(const std::string& name, const std::string& mode) const {
    return folder_.write(name, R"({"format": "robotcontrol-preset", "version": 1,
                                   "preset": {"keys": {"package/models/ball": ")" +
                                   mode + R"("}}})");
  }
  static std::string modeIn(const std::shared_ptr<const Preset>& preset,
                            const std::string& key = "package/models/ball") {
    const auto& keys = preset->parts[Preset::kKeys];
    const auto found = keys->find(key);
    return found == keys->end() ? std::string("off") : found->second;
  }
  /// What is wrong with what was chosen.
  std::vector<std::string> apply() {
    const auto done = options_.applyTo(run_);
    std::vector<std::string> texts;
    if (!done)
      for (const auto& error : done.error()) texts.push_back(error.describe());
    return texts;
  }

  const TestFolder folder_;
  CLI::App command_;
  TeamOptions options_;
  RunOptions run_;
};

TEST_F(TeamOptionsTest, withoutAnyNothingIsChosen) {
  EXPECT_FALSE(options_.given());
  EXPECT_THAT(apply(), IsEmpty());
  EXPECT_EQ(run_.preset, nullptr);
  EXPECT_THAT(run_.layouts, IsEmpty());
  EXPECT_THAT(run_.solutions, IsEmpty());
  options_.game = "2002";
  EXPECT_FALSE(options_.given()) << "rules are no program";
  apply();
  EXPECT_EQ(run_.game, "2002");
}

TEST_F(TeamOptionsTest, anOptionTakesOneValueAndMayBeRepeated) {
  command_.parse("--layout compact --layout red=parallel --shadow ball-model=last-percept --game none");
  EXPECT_THAT(options_.layouts, ElementsAre("compact", "red=parallel"));
  EXPECT_TRUE(options_.given());
  EXPECT_EQ(options_.game, "none");
}

TEST_F(TeamOptionsTest, solutionsAreThoseOfAllOrOfOneTeam) {
  options_.solutions = {"ball-model=last-percept", "red/ball-model=kalman"};
  EXPECT_THAT(apply(), IsEmpty());
  EXPECT_EQ(run_.solutions.at("ball-model"), "last-percept");
  EXPECT_EQ(run_.robotSolutions.at("red").at("ball-model"), "kalman");
}

TEST_F(TeamOptionsTest, presetsAreThoseOfAllOrOfOneTeam) {
  options_.presets = {preset("all.preset.json", "always"), "red=" + preset("red.preset.json", "every 2")};
  EXPECT_THAT(apply(), IsEmpty());
  ASSERT_NE(run_.preset, nullptr);
  EXPECT_EQ(modeIn(run_.preset), "always");
  EXPECT_EQ(modeIn(run_.robotPresets.at("red")), "every 2");
}

TEST_F(TeamOptionsTest, aFileWithAnEqualsSignInItsNameIsAFile) {
  options_.presets = {preset("red=1.preset.json", "every 3")};
  EXPECT_THAT(apply(), IsEmpty());
  EXPECT_EQ(modeIn(run_.preset), "every 3");
  EXPECT_THAT(run_.robotPresets, IsEmpty());
}

TEST_F(TeamOptionsTest, shadowsAreThoseOfAllOrOfOneTeam) {
  options_.shadows = {"ball-model=last-percept", "red/ball-model=kalman"};
  EXPECT_THAT(apply(), IsEmpty());
  EXPECT_THAT(run_.shadows.at(""), ElementsAre(robotlink::ShadowName{"ball-model", "last-percept"}));
  EXPECT_THAT(run_.shadows.at("red"), ElementsAre(robotlink::ShadowName{"ball-model", "kalman"}));
}

TEST_F(TeamOptionsTest, allThatIsWrongIsSaidAtOnce) {
  options_.layouts = {"=compact"};
  options_.solutions = {"ball-model"};
  options_.presets = {(folder_ / "none.preset.json").string()};
  options_.colorTables = {(folder_ / "none.c64").string()};
  options_.shadows = {"ball-model=magic"};
  EXPECT_THAT(apply(), ElementsAre(HasSubstr("=compact"), HasSubstr("ball-model"),
                                   HasSubstr("none.preset.json"), HasSubstr("none.c64"), HasSubstr("magic")));
}

}  // namespace
}  // namespace app
