// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/GamepadBindings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/TestFolder.h"
#include "widgets/motion/GamepadSettings.h"

namespace widgets {
namespace {

using PadAxis = GamepadBindings::Axis;

TEST(GamepadBindingsTest, asShippedTheLeftStickWalksAndTheRightOneTurns) {
  GamepadReading reading;
  reading.axes[0] = 0.1;  // within the dead zone
  reading.axes[1] = -1;
  reading.axes[2] = 0.575;
  reading.buttons[0] = true;
  const WalkAxes axes = walkAxes(reading, {});
  EXPECT_DOUBLE_EQ(axes.forward, 1);
  EXPECT_DOUBLE_EQ(axes.left, 0);
  EXPECT_DOUBLE_EQ(axes.turn, -0.5);
  EXPECT_TRUE(isPressedAsShipped(reading, {}, "a"));
  EXPECT_FALSE(isPressedAsShipped(reading, {}, "b"));
  EXPECT_TRUE(pressedCommands(reading, {}).empty());
}

TEST(GamepadBindingsTest, axesHaveDeadZonesAndScalesAndAddUp) {
  GamepadBindings bindings;
  bindings.axes[4] = {PadAxis::Use::kForward, 0, -0.5};  // a trigger drives backwards
  bindings.axes[1] = {PadAxis::Use::kForward, 0.5, 0.5};
  GamepadReading reading;
  reading.axes[1] = 0.75;
  EXPECT_DOUBLE_EQ(walkAxes(reading, bindings).forward, 0.25);
  reading.axes[4] = 1;
  EXPECT_DOUBLE_EQ(walkAxes(reading, bindings).forward, -0.25);
}

TEST(GamepadBindingsTest, aBoundButtonRunsItsCommandInsteadOfWhatItDoesAsShipped) {
  GamepadBindings bindings;
  bindings.buttons = {{"a", "robot.stand"}, {"b", ""}, {"dpup", "log.step 1"}};
  GamepadReading reading;
  reading.buttons[0] = reading.buttons[1] = reading.buttons[11] = true;
  EXPECT_FALSE(isPressedAsShipped(reading, bindings, "a"));
  EXPECT_FALSE(isPressedAsShipped(reading, bindings, "b"));
  const std::map<std::string, std::string> wanted{{"a", "robot.stand"}, {"dpup", "log.step 1"}};
  EXPECT_EQ(pressedCommands(reading, bindings), wanted);
}

TEST(GamepadSettingsTest, whatWasChosenIsRemembered) {
  const TestFolder folder;
  const auto file = folder.path() / "gamepad.json";
  GamepadBindings bindings;
  bindings.axes[3] = {PadAxis::Use::kTurn, 0.3, 0.7};
  bindings.axes[0] = {PadAxis::Use::kNothing, 0.15, -1};
  bindings.buttons = {{"x", "robot.stand"}, {"a", ""}};
  ASSERT_TRUE(GamepadSettings(file).set(bindings));
  EXPECT_EQ(GamepadSettings(file).bindings(), bindings);
  EXPECT_EQ(GamepadSettings(folder.path() / "none.json").bindings(), GamepadBindings());
}

TEST(GamepadSettingsTest, senselessValuesAreLeftOutOrClampedAndADamagedFileIsPutAside) {
  const TestFolder folder;
  const auto file = folder.path() / "gamepad.json";
  std::ofstream(file) << R"({"format": "robotcontrol-gamepad", "version": 1, "gamepad": {
    "axes": {"leftx": {"does": "flies", "dead_zone": 7, "scale": "big"}, "lefty": 3, "nose": {}},
    "buttons": {"x": 4, "y": "robot.stand", "z": "robot.stand"}}})";
  const GamepadSettings settings(file);
  EXPECT_FALSE(settings.problem());
  EXPECT_EQ(settings.bindings().axes[0], (PadAxis{PadAxis::Use::kLeft, GamepadBindings::kMaxDeadZone, -1}));
  EXPECT_EQ(settings.bindings().axes[1], GamepadBindings().axes[1]);
  EXPECT_EQ(settings.bindings().buttons, (std::map<std::string, std::string>{{"y", "robot.stand"}}));
  std::ofstream(file) << "{";
  EXPECT_TRUE(GamepadSettings(file).problem());
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace widgets
