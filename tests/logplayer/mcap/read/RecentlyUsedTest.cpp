// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/RecentlyUsed.h"

#include <gtest/gtest.h>

#include <string>

namespace logplayer::mcap {
namespace {

/// Holds 30 bytes; 1, 2 and 3 are there, with 10 bytes each.
struct Filled : RecentlyUsed<std::string> {
  Filled() : RecentlyUsed(30) {
    for (std::size_t key = 1; key <= 3; ++key) insert(key, std::to_string(key), 10);
  }
};

/// Which of the keys 1 to 5 are there; this uses them in that order.
std::string keys(RecentlyUsed<std::string>& cache) {
  std::string found;
  for (std::size_t key = 1; key <= 5; ++key) found += cache.find(key) != nullptr ? std::to_string(key) : "";
  return found;
}

TEST(RecentlyUsed, theLeastRecentlyUsedGoesFirst) {
  Filled cache;
  ASSERT_NE(cache.find(1), nullptr);
  cache.insert(4, "4", 10);
  EXPECT_EQ(keys(cache), "134");
  EXPECT_EQ(*cache.find(4), "4");
}

TEST(RecentlyUsed, oneLargeValueTakesThePlaceOfSeveral) {
  Filled cache;
  cache.insert(4, "4", 20);
  EXPECT_EQ(keys(cache), "34");
}

TEST(RecentlyUsed, theNewestIsKeptWhateverItsSize) {
  Filled cache;
  cache.insert(4, "4", 1000);
  EXPECT_EQ(keys(cache), "4");
  cache.insert(5, "5", 1);
  EXPECT_EQ(keys(cache), "5") << "it no longer is the newest";
}

TEST(RecentlyUsed, aReplacedValueCountsOnce) {
  Filled cache;
  cache.insert(3, "three", 10);
  EXPECT_EQ(keys(cache), "123");
  EXPECT_EQ(*cache.find(3), "three");
}

TEST(RecentlyUsed, whatIsErasedMakesRoom) {
  Filled cache;
  cache.erase(2);
  cache.erase(2);
  cache.insert(4, "4", 10);
  EXPECT_EQ(keys(cache), "134");
  cache.clear();
  EXPECT_EQ(keys(cache), "");
  cache.insert(5, "5", 30);
  EXPECT_EQ(keys(cache), "5");
}

TEST(RecentlyUsed, aRetiredValueStaysUntilRoomIsNeededAndGoesFirst) {
  Filled cache;
  cache.retire(3);
  EXPECT_EQ(keys(cache), "123");
  ASSERT_NE(cache.find(3), nullptr) << "to look at it does not make it needed again";
  cache.insert(4, "4", 10);
  EXPECT_EQ(keys(cache), "124");
  cache.retire(9);  // is not there
  EXPECT_EQ(keys(cache), "124");
}

TEST(RecentlyUsed, memoryIsGivenBackForReuse) {
  Filled cache;
  EXPECT_EQ(cache.release(0), "") << "there is room";
  EXPECT_EQ(cache.release(10), "1");
  cache.retire(3);
  EXPECT_EQ(cache.release(0), "3") << "nobody needs it";
  EXPECT_EQ(keys(cache), "2");
  EXPECT_EQ(cache.release(1000), "2");
  EXPECT_EQ(cache.release(1000), "");
}

TEST(RecentlyUsed, aKeyThatWasRetiredCanBeInsertedAgain) {
  Filled cache;
  cache.retire(1);
  cache.insert(1, "again", 10);
  cache.insert(4, "4", 10);
  EXPECT_EQ(keys(cache), "134") << "it is as good as new";
}

}  // namespace
}  // namespace logplayer::mcap
