// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/link/StreamList.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace app {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

StreamList::Stream imageStream(std::uint64_t messages, std::uint64_t bytes) {
  return {.path = "red1/camera/image",
          .topic = "/red1/camera/image",
          .type = "foxglove.RawImage",
          .encoding = "protobuf",
          .isSubscribed = true,
          .isDecoded = true,
          .messages = messages,
          .bytes = bytes};
}

/// The rate in the only row.
double rateOf(const StreamList& list, const char* what = "rate") {
  return json::parse(list.json("", {}, "")).at("streams").at(0).at(what).get<double>();
}

/// The line of a stream.
std::string lineOf(const StreamList& list, const std::string& path) {
  const std::string text = list.text();
  const auto begin = text.find("  " + path + " ");
  return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

TEST(StreamList, aRateIsThatBetweenTwoUpdates) {
  StreamList list;
  list.update({imageStream(100, 1000)}, 10);
  list.update({imageStream(150, 51'000)}, 12);
  EXPECT_DOUBLE_EQ(rateOf(list), 25);
  EXPECT_DOUBLE_EQ(rateOf(list, "bytes_per_second"), 25'000);
  list.update({imageStream(150, 51'000)}, 14);
  EXPECT_EQ(rateOf(list), 0);
}

TEST(StreamList, aConnectionThatCountsAnewHasNoRateAtFirst) {
  StreamList list;
  list.update({imageStream(1000, 1000)}, 10);
  list.update({imageStream(5, 50)}, 11);
  EXPECT_EQ(rateOf(list), 0);
  list.update({imageStream(15, 150)}, 12);
  EXPECT_DOUBLE_EQ(rateOf(list), 10);
}

TEST(StreamList, aStreamThatWasAwayIsMeasuredSinceItWasLastSeen) {
  StreamList list;
  list.update({imageStream(10, 10)}, 1);
  list.update({}, 2);
  EXPECT_FALSE(list.has("red1/camera/image"));
  list.update({imageStream(50, 10)}, 5);
  EXPECT_DOUBLE_EQ(rateOf(list), 10);
}

TEST(StreamList, twoUpdatesAtOnceDivideByNothing) {
  StreamList list;
  list.update({imageStream(0, 0)}, 1);
  list.update({imageStream(1, 1)}, 1);
  EXPECT_TRUE(std::isfinite(rateOf(list)));
}

TEST(StreamList, aPathThatMayHaveBeenMeantIsFound) {
  StreamList list;
  list.update({imageStream(0, 0)}, 1);
  EXPECT_TRUE(list.has("red1/camera/image"));
  EXPECT_EQ(list.near("red1/camera/imag"), "red1/camera/image");
  EXPECT_EQ(list.near("simulation"), "");
}

TEST(StreamList, ratesHaveTheUnitInWhichTheyAreRead) {
  for (const auto& [bytes, text] : std::vector<std::pair<std::uint64_t, std::string>>{
           {999, "999 B/s"}, {1000, "1.0 kB/s"}, {999'900, "999.9 kB/s"}, {1'500'000, "1.50 MB/s"}}) {
    StreamList list;
    list.update({imageStream(0, 0)}, 1);
    list.update({imageStream(30, bytes)}, 2);
    EXPECT_THAT(lineOf(list, "red1/camera/image"), HasSubstr(" 30.0 Hz "));
    EXPECT_THAT(lineOf(list, "red1/camera/image"), EndsWith(" " + text));
  }
}

TEST(StreamList, whatNobodyReadsHasNoRate) {
  StreamList list;
  StreamList::Stream stream = imageStream(7, 7);
  stream.isSubscribed = false;
  list.update({stream}, 1);
  EXPECT_THAT(lineOf(list, "red1/camera/image"), EndsWith("          -            -"));
  EXPECT_THAT(list.text(), Not(HasSubstr("Hz")));
}

TEST(StreamList, aLineSaysWhatIsNotAsItShouldBe) {
  StreamList list;
  StreamList::Stream foreign = imageStream(0, 0), jpeg = foreign, png = foreign, lossy = foreign;
  foreign.path = "foreign";
  foreign.encoding = "flatbuffer";
  foreign.isDecoded = false;
  foreign.dropped = 3;
  jpeg.path = "as-jpeg";
  jpeg.topic += "/jpeg";
  png.path = "as-png";
  png.topic += "/png";
  png.thinned = 2;
  lossy.path = "lossy";
  lossy.thinned = 5;
  lossy.dropped = 0;
  list.update({foreign, jpeg, png, lossy}, 1);
  EXPECT_THAT(lineOf(list, "foreign"), EndsWith("  flatbuffer, not decoded, 3 dropped"));
  EXPECT_THAT(lineOf(list, "as-jpeg"), EndsWith("  as JPEG"));
  EXPECT_THAT(lineOf(list, "as-png"), EndsWith("  as PNG, 2 thinned"));
  EXPECT_THAT(lineOf(list, "lossy"), EndsWith("  5 thinned"));
}

TEST(StreamList, columnsAreAsWideAsTheLongestNames) {
  StreamList list;
  EXPECT_EQ(list.text(), "  stream  type       rate        bytes\n");
  StreamList::Stream small = imageStream(0, 0);
  small.path = "log";
  small.type = "Log";
  list.update({imageStream(0, 0), small}, 1);
  const std::string text = list.text();
  EXPECT_EQ(text.find("type"), lineOf(list, "log").find("Log"));
}

TEST(StreamList, namesOfAServerCannotSteerTheTerminal) {
  StreamList list;
  StreamList::Stream evil = imageStream(0, 0);
  evil.path = "red\x1b[2Jblue";
  list.update({evil}, 1);
  EXPECT_THAT(list.text(), Not(HasSubstr("\x1b")));
  EXPECT_THAT(list.json("ws://x", {}, "connected"), Not(HasSubstr("\x1b")));
}

TEST(StreamList, countsOfTheServerAreInTheJsonOnlyIfItCounts) {
  StreamList list;
  StreamList::Stream counted = imageStream(4, 5);
  counted.dropped = 0;
  list.update({imageStream(1, 2), counted}, 1);
  const json all = json::parse(list.json("ws://robot:8765", {"red1", "red2"}, "connected"));
  EXPECT_EQ(all.at("url"), "ws://robot:8765");
  EXPECT_EQ(all.at("robots"), json({"red1", "red2"}));
  EXPECT_EQ(all.at("state"), "connected");
  const json& streams = all.at("streams");
  ASSERT_EQ(streams.size(), 2U);
  EXPECT_FALSE(streams[0].contains("dropped"));
  EXPECT_EQ(streams[1].at("dropped"), 0);
  EXPECT_FALSE(streams[1].contains("thinned"));
  EXPECT_EQ(streams[1].at("messages"), 4);
  EXPECT_EQ(streams[1].at("topic"), "/red1/camera/image");
}

}  // namespace
}  // namespace app
