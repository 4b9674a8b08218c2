// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/StreamFilter.h"

#include <gtest/gtest.h>

#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"

namespace logplayer {
namespace {

TEST(StreamFilter, aStarStandsForAnyTextWithItsSlashes) {
  EXPECT_TRUE(fits("red1/camera/image", "red1/camera/image"));
  EXPECT_TRUE(fits("red1/camera/image", "*"));
  EXPECT_TRUE(fits("red1/camera/image", "red1/*"));
  EXPECT_TRUE(fits("red1/camera/image", "*/image"));
  EXPECT_TRUE(fits("red1/camera/image", "r*1/*/im*"));
  EXPECT_TRUE(fits("red1/camera/image", "red1/camera/image*"));
  EXPECT_TRUE(fits("", "*"));
  EXPECT_TRUE(fits("", ""));
  EXPECT_TRUE(fits("a/ab/abc", "*abc"));
  EXPECT_FALSE(fits("red1/camera/image", "red1"));
  EXPECT_FALSE(fits("red1/camera/image", "blue*"));
  EXPECT_FALSE(fits("red1/camera/image", "*/imag"));
  EXPECT_FALSE(fits("red1/camera/image", ""));
  EXPECT_FALSE(fits("", "a"));
}

TEST(StreamFilter, anythingIsTakenUnlessSomethingIsNamed) {
  EXPECT_TRUE(StreamFilter{}.has("red1/log"));
  const StreamFilter choice{{"red1/*", "scene"}, {"*/camera/*"}};
  EXPECT_TRUE(choice.has("red1/log"));
  EXPECT_TRUE(choice.has("scene"));
  EXPECT_FALSE(choice.has("blue1/log"));
  EXPECT_FALSE(choice.has("red1/camera/image"));
  EXPECT_FALSE((StreamFilter{{}, {"scene"}}.has("scene")));
}

TEST(StreamFilter, tablesSceneAndSetUpsAreLatched) {
  EXPECT_TRUE(isLatched("scene", "foxglove.SceneUpdate"));
  EXPECT_TRUE(isLatched("red1/program", robotcontrol::ProgramSetup::descriptor()->full_name()));
  EXPECT_TRUE(isLatched("red1/colors/table", robotcontrol::ColorTable::descriptor()->full_name()));
  EXPECT_TRUE(isLatched("red1/tables/keys", robotcontrol::KeyTable::descriptor()->full_name()));
  EXPECT_FALSE(isLatched("red1/drawings/field/ball", "foxglove.SceneUpdate"));
  EXPECT_FALSE(isLatched("red1/camera/image", "foxglove.RawImage"));
}

}  // namespace
}  // namespace logplayer
