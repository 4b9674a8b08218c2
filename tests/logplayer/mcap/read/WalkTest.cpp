// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Walk.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/logplayer/mcap/BuiltFile.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

const MessagePosition kBeforeAll{Instant::min(), 0, 0, 0};
const MessagePosition kBehindAll{Instant::max(), UINT64_MAX, UINT64_MAX, UINT16_MAX};

/// Three chunks that overlap, the last one without indexes.
class WalkTest : public testing::Test {
 protected:
  WalkTest() {
    file_.addChannels(3);
    first_ = file_.addIndexed({{1, 0, 10, ""}, {2, 0, 30, ""}, {1, 0, 50, ""}});
    second_ = file_.addIndexed({{1, 0, 30, ""}, {2, 0, 40, ""}});
    file_.addChunk({{3, 0, 20, ""}, {1, 0, 60, ""}});
    scanned_.emplace(file_);
  }
  Walk walk(Walk::Direction direction) { return {direction, scanned_->index, scanned_->cache}; }
  /// The times that steps from a position find.
  static std::vector<std::int64_t> times(Walk walk, MessagePosition from,
                                         const std::vector<std::uint16_t>& channels = {1, 2, 3}) {
    std::vector<std::int64_t> found;
    while (const auto next = walk.step(from, channels)) {
      found.push_back(next->time.time_since_epoch().count());
      from = *next;
    }
    return found;
  }

  BuiltFile file_;
  std::optional<ScannedFile> scanned_;
  std::uint64_t first_ = 0, second_ = 0;
};

TEST_F(WalkTest, messagesOfAllSectionsComeInOrderOfTime) {
  EXPECT_THAT(times(walk(Walk::Direction::kForward), kBeforeAll), ElementsAre(10, 20, 30, 30, 40, 50, 60));
  EXPECT_THAT(times(walk(Walk::Direction::kBackward), kBehindAll), ElementsAre(60, 50, 40, 30, 30, 20, 10));
}

TEST_F(WalkTest, equalTimesComeInTheOrderOfTheFile) {
  Walk forward = walk(Walk::Direction::kForward);
  const auto earlier = forward.step({at(29), 0, 0, 0}, {1, 2});
  const auto later = forward.step(*earlier, {1, 2});
  EXPECT_EQ(earlier->chunkOffset, first_);
  EXPECT_EQ(later->chunkOffset, second_);
  Walk backward = walk(Walk::Direction::kBackward);
  EXPECT_EQ(backward.step({at(31), 0, 0, 0}, {1, 2}), later);
  EXPECT_EQ(backward.step(*later, {1, 2}), earlier);
}

TEST_F(WalkTest, onlyTheChannelsThatAreAskedForCome) {
  EXPECT_THAT(times(walk(Walk::Direction::kForward), kBeforeAll, {2}), ElementsAre(30, 40));
  EXPECT_THAT(times(walk(Walk::Direction::kForward), kBeforeAll, {3, 1}), ElementsAre(10, 20, 30, 50, 60));
  EXPECT_THAT(times(walk(Walk::Direction::kForward), kBeforeAll, {7}), IsEmpty());
  EXPECT_THAT(times(walk(Walk::Direction::kBackward), kBehindAll, {}), IsEmpty());
}

TEST_F(WalkTest, itStepsFromAnyPlaceAlsoFromWhereNoMessageIs) {
  Walk forward = walk(Walk::Direction::kForward), backward = walk(Walk::Direction::kBackward);
  for (const std::int64_t from : {45, 5, 60, 31, 20, 100}) {
    const std::vector<std::int64_t> all{10, 20, 30, 40, 50, 60};
    const auto later = forward.step({at(from), UINT64_MAX, 0, 0}, {1, 2, 3});
    const auto next = std::ranges::upper_bound(all, from);
    EXPECT_EQ(later ? later->time : at(-1), next == all.end() ? at(-1) : at(*next)) << from;
    const auto earlier = backward.step({at(from), 0, 0, 0}, {1, 2, 3});
    const auto before = std::ranges::lower_bound(all, from);
    EXPECT_EQ(earlier ? earlier->time : at(-1), before == all.begin() ? at(-1) : at(before[-1])) << from;
  }
}

TEST_F(WalkTest, otherChannelsThanBeforeStartANewSearchFromTheSamePlace) {
  Walk forward = walk(Walk::Direction::kForward);
  const auto first = forward.step(kBeforeAll, {1});
  EXPECT_EQ(forward.step(*first, {3})->time, at(20));
  EXPECT_EQ(forward.step(*first, {2})->time, at(30));
}

TEST_F(WalkTest, aSectionWhoseHeadLiesIsSortedAnewOnceItIsRead) {
  for (Section& section : scanned_->index.sections) {
    if (!section.indexed) section.info.start = section.info.end = at(60);  // although it begins at 20
  }
  Walk forward = walk(Walk::Direction::kForward);
  EXPECT_EQ(forward.step({at(50), UINT64_MAX, 0, 0}, {1, 2, 3})->time, at(60));
  EXPECT_THAT(times(std::move(forward), kBeforeAll), ElementsAre(10, 20, 30, 30, 40, 50, 60));
}

}  // namespace
