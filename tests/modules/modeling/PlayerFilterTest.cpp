// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for both filters of other robots that also learn from where none was seen.
#include <gtest/gtest.h>

#include <algorithm>

#include "modules/modeling/players/PlayerGrid.h"
#include "modules/modeling/players/PlayerKalman.h"
#include "robotlink/base/Random.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

template <typename Filter>
Filter makeFilter();
template <>
PlayerGrid makeFilter() {
  return PlayerGrid(4.2, 2.7, {});
}
template <>
PlayerKalman makeFilter() {
  return PlayerKalman({});
}

template <typename Filter>
class PlayerFilter : public testing::Test {
 protected:
  /// Shows robots at places of the field, seen from its center in the direction x.
  void show(const std::vector<std::pair<std::string, Vector2>>& robots, int images = 1,
            const SeenSector& sector = {}) {
    for (int i = 0; i < images; ++i) {
      PlayerFrame frame;
      frame.time = time_ += 0.04;
      frame.sector = sector;
      for (const auto& [team, place] : robots) {
        const Vector2 off{0.04 * random_.normal(), 0.04 * random_.normal()};
        frame.seen.push_back({team, place + off, 0.6});
      }
      filter_.update(frame);
    }
  }
  Filter filter_ = makeFilter<Filter>();
  robotlink::Random random_{3};
  double time_ = 0;
};

using PlayerFilters = testing::Types<PlayerGrid, PlayerKalman>;
TYPED_TEST_SUITE(PlayerFilter, PlayerFilters);

TYPED_TEST(PlayerFilter, findsEachRobotOnceAndKeepsTeamsApart) {
  this->show({{"blue", {1, 0}}, {"blue", {1, 0.8}}, {"red", {1.1, 0.1}}}, 30);
  ASSERT_EQ(this->filter_.players().size(), 3U);
  EXPECT_EQ(std::ranges::count(this->filter_.players(), "blue", &TrackedPlayer::team), 2);
  for (const TrackedPlayer& player : this->filter_.players()) {
    const Vector2 truth = player.team == "red"               ? Vector2(1.1, 0.1)
                          : player.positionInField.y() > 0.4 ? Vector2(1, 0.8)
                                                             : Vector2(1, 0);
    EXPECT_LT((player.positionInField - truth).norm(), 0.12) << player.team;
    EXPECT_GT(player.confidence, 0.5);
  }
}

TYPED_TEST(PlayerFilter, followsARobotThatWalks) {
  for (int i = 0; i < 100; ++i) this->show({{"blue", {1.8 - 0.008 * i, 0.3}}});
  ASSERT_FALSE(this->filter_.players().empty());
  EXPECT_LT((this->filter_.players().front().positionInField - Vector2(1.0, 0.3)).norm(), 0.25);
}

TYPED_TEST(PlayerFilter, forgetsMuchFasterWhereItLooksAndSeesNobody) {
  const SeenSector ahead{{}, 0, 0.5, 0.3, 2.5};
  const auto confidence = [&] {
    const auto& players = this->filter_.players();
    return players.empty() ? 0.0 : players.front().confidence;
  };
  this->show({{"blue", {1, 0}}}, 20);
  this->show({}, 25);
  const double unseen = confidence();
  EXPECT_GT(unseen, 0.4);
  this->show({{"blue", {1, 0}}}, 20);
  this->show({}, 25, ahead);
  EXPECT_LT(confidence(), 0.6 * unseen);
  this->show({}, 100, ahead);
  EXPECT_TRUE(this->filter_.players().empty());
}

TEST(SeenSector, isWhatTheCameraShows) {
  const SeenSector sector{{1, 1, robotlink::kPi / 2}, 0.2, 0.3, 0.4, 2};
  EXPECT_TRUE(sector.contains({1, 2}));
  EXPECT_FALSE(sector.contains({1, 1.2}));
  EXPECT_FALSE(sector.contains({1, 4}));
  EXPECT_FALSE(sector.contains({2, 2}));
  EXPECT_FALSE(SeenSector{}.contains({1, 0}));
}

TEST(PlayerGrid, tellsItsCells) {
  PlayerGrid grid(4.2, 2.7, {});
  EXPECT_TRUE(grid.cells(0).empty());
  PlayerFrame frame;
  frame.seen.push_back({"red", {1, 0}, 0.8});
  grid.update(frame);
  const auto cells = grid.cells(0.05);
  ASSERT_FALSE(cells.empty());
  for (const PlayerGrid::Cell& cell : cells) EXPECT_LT((cell.center - Vector2(1, 0)).norm(), 0.7);
}

}  // namespace
}  // namespace modules
