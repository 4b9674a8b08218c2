// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/RecordedStreams.h"

#include <gtest/gtest.h>

using namespace logplayer;

namespace {

RecordedStreams recorded(const std::string& text) {
  const auto selection = readSelection(text);
  EXPECT_TRUE(selection.has_value()) << text;
  return selection ? RecordedStreams(*selection) : RecordedStreams();
}

}  // namespace

TEST(RecordedStreams, withoutAChoiceAreAllThatAReplayNeeds) {
  const RecordedStreams streams;
  for (const char* path :
       {"red1/camera/image", "red1/joints/states", "red1/frames/motion", "red1/requests", "scene",
        "transforms", "red1/models/ball", "red1/drawings/field/ball", "bookmarks"}) {
    EXPECT_TRUE(streams.contains(path)) << path;
  }
  for (const char* path : {"red1/images/segmentation", "red1/logged/models/ball", "recording", "replay"}) {
    EXPECT_FALSE(streams.contains(path)) << path;
  }
}

TEST(RecordedStreams, aChoiceIsOfPatternsAndLeavesNoLogWithoutItsProgram) {
  const RecordedStreams streams = recorded("red1/camera/*, red1/images/*,-*/image");
  EXPECT_FALSE(streams.contains("red1/camera/image"));
  EXPECT_TRUE(streams.contains("red1/camera/pose"));
  EXPECT_TRUE(streams.contains("red1/images/segmentation"));
  EXPECT_FALSE(streams.contains("red1/models/ball"));
  EXPECT_TRUE(streams.contains("red1/program"));
  EXPECT_TRUE(streams.contains("red1/requests"));
  EXPECT_TRUE(streams.contains("bookmarks"));
  EXPECT_FALSE(streams.contains("red1/models/program"));
}

TEST(RecordedStreams, whatIsLeftOutByNameIsLeftOut) {
  const RecordedStreams streams = recorded("-*/requests,-transforms");
  EXPECT_FALSE(streams.contains("red1/requests"));
  EXPECT_TRUE(streams.excludes("transforms"));
  EXPECT_TRUE(streams.excludes("recording"));
  EXPECT_FALSE(streams.excludes("scene"));
  EXPECT_TRUE(streams.contains("red1/camera/image"));
}

TEST(RecordedStreams, aSelectionIsReadAsItIsWritten) {
  const std::string text = "red1/*,*/log,-*/camera/image";
  const auto selection = readSelection(text);
  ASSERT_TRUE(selection.has_value());
  EXPECT_EQ(selection->include_size(), 2);
  EXPECT_EQ(selection->exclude(0), "*/camera/image");
  EXPECT_EQ(textOf(*selection), text);
  EXPECT_EQ(textOf(*readSelection("  ")), "");
  EXPECT_EQ(textOf(*readSelection("- a")), "-a");
}

TEST(RecordedStreams, whatIsNoSelectionIsRefusedByItsName) {
  for (const char* text : {",", "a,,b", "-", "a b", "a,"}) {
    const auto selection = readSelection(text);
    ASSERT_FALSE(selection.has_value()) << text;
    EXPECT_NE(selection.error().text.find("red1/*"), std::string::npos);
  }
}

TEST(RecordedStreams, manyMadeUpPathsAreAnsweredAll) {
  const RecordedStreams streams = recorded("-*7");
  for (int i = 0; i < 25'000; ++i) EXPECT_EQ(streams.contains("red1/" + std::to_string(i)), i % 10 != 7);
}
