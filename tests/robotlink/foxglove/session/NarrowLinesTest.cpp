// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/NarrowLines.h"

#include <gmock/gmock.h>

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;

class NarrowLinesTest : public testing::Test {
 protected:
  NarrowLinesTest() { client_.info.id = 7; }
  /// A quarter of a second passes, in which so many images were sent to the client and thinned.
  std::vector<NarrowLines::Finding> pass(std::uint64_t sent, std::uint64_t thinned) {
    now_ += 250ms;
    auto& counters = client_.streams["red1/camera/image"];
    counters.sent += sent;
    counters.thinned += thinned;
    client_.streams["red1/log"].thinned += 100;
    return lines_.look({client_}, {"red1/camera/image"}, now_);
  }
  std::size_t passSecond(std::uint64_t sent, std::uint64_t thinned) {
    std::size_t found = 0;
    for (int i = 0; i < 4; ++i) found += pass(sent, thinned).size();
    return found;
  }

  ClientState client_;
  Instant now_{10s};
  NarrowLines lines_;
};

TEST_F(NarrowLinesTest, aLineThatCarriesATenthIsFoundOnceWithinASecond) {
  pass(1, 5);
  std::vector<NarrowLines::Finding> all;
  for (int i = 0; i < 4; ++i)
    for (auto& found : pass(1, 6)) all.push_back(std::move(found));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().client, 7U);
  EXPECT_EQ(all.front().topic, "red1/camera/image");
  EXPECT_THAT(all.front().text, testing::HasSubstr("carries 4 of 28 raw images a second"));
  EXPECT_EQ(passSecond(1, 6), 0U);
}

TEST_F(NarrowLinesTest, aLineThatIsSlowOnlyAtTheBeginningIsNotFound) {
  pass(1, 2);
  EXPECT_EQ(passSecond(2, 5), 0U);
  EXPECT_EQ(passSecond(7, 0), 0U);
  EXPECT_EQ(passSecond(7, 0), 0U);
}

TEST_F(NarrowLinesTest, aLineThatCarriesAThirdIsFoundAfterTwoSeconds) {
  pass(2, 5);
  EXPECT_EQ(passSecond(2, 5), 0U);
  EXPECT_EQ(passSecond(2, 5), 1U);
}

TEST_F(NarrowLinesTest, aLineThatCarriesMostIsNotFound) {
  for (int i = 0; i < 10; ++i) EXPECT_EQ(passSecond(5, 2), 0U);
}

}  // namespace
}  // namespace robotlink::websocket
