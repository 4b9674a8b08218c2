// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/ColorVotes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace colortool {
namespace {

using robotlink::YCbCr;

constexpr YCbCr kOrange{150, 90, 190}, kGreen{90, 110, 100}, kWall{180, 126, 130};

void add(ColorVotes& votes, YCbCr color, std::uint8_t colorClass, int pixels = 20) {
  votes.add(ColorTable::cellOf(color), colorClass, pixels * ColorVotes::kUnit);
}

TEST(ColorVotes, withoutSamplesNothingIsOfAClass) {
  ColorVotes votes(3);
  EXPECT_EQ(votes.update(), ColorTable());
}

TEST(ColorVotes, samplesReachTheirNeighborsFartherInBrightness) {
  ColorVotes votes(3);
  add(votes, kOrange, 1);
  add(votes, kGreen, 2);
  const ColorTable& table = votes.update();
  EXPECT_EQ(table.classOf(kOrange), 1);
  EXPECT_EQ(table.classOf({150, 98, 182}), 1);
  EXPECT_EQ(table.classOf({190, 90, 190}), 1) << "brighter by 40";
  EXPECT_EQ(table.classOf({150, 130, 190}), 0) << "another hue, by 40";
  EXPECT_EQ(table.classOf(kGreen), 2);
  EXPECT_EQ(table.classOf(kWall), 0);
}

TEST(ColorVotes, backgroundTakesWhatIsNearerToIt) {
  ColorVotes votes(2);
  add(votes, {150, 112, 148}, 1);
  EXPECT_EQ(votes.update().classOf({150, 126, 132}), 1);
  add(votes, {150, 128, 130}, 0);
  EXPECT_EQ(votes.update().classOf({150, 126, 132}), 0);
  EXPECT_EQ(votes.update().classOf({150, 112, 148}), 1);
}

TEST(ColorVotes, aColorThatMustNotBeOfAClassIsNot) {
  ColorVotes votes(2);
  add(votes, {150, 120, 140}, 1);
  const YCbCr near{150, 132, 140};
  ASSERT_EQ(votes.update().classOf(near), 1);
  add(votes, near, 1, -20);
  EXPECT_EQ(votes.update().classOf(near), 0);
  EXPECT_EQ(votes.update().classOf({150, 112, 140}), 1);
}

/// The tables on the way there are met again on the way back, in any order of what is taken away. Things need
/// more votes near gray, by how many samples they have in all.
TEST(ColorVotes, takingSamplesAwayLeavesExactlyWhatWasThere) {
  std::mt19937 random(7);
  struct Step {
    std::size_t cell;
    std::uint8_t colorClass;
    int pixels;
  };
  std::vector<Step> steps;
  std::vector<ColorTable> tables;
  ColorVotes votes(4);
  votes.setThings({false, true, false, true});
  for (int i = 0; i < 60; ++i) {
    // A few cells, so that they are hit again and again.
    const YCbCr color{static_cast<std::uint8_t>(100 + random() % 16),
                      static_cast<std::uint8_t>(100 + random() % 40),
                      static_cast<std::uint8_t>(100 + random() % 40)};
    steps.push_back({ColorTable::cellOf(color), static_cast<std::uint8_t>(random() % 4),
                     static_cast<int>(random() % 3000) - 300});
    tables.push_back(votes.update());
    votes.add(steps.back().cell, steps.back().colorClass, steps.back().pixels);
  }
  const ColorTable all = votes.update();
  for (std::size_t i = steps.size(); i-- > 0;) {
    votes.add(steps[i].cell, steps[i].colorClass, -steps[i].pixels);
    ASSERT_EQ(votes.update(), tables[i]) << i;
  }
  std::ranges::shuffle(steps, random);
  for (const Step& step : steps) votes.add(step.cell, step.colorClass, step.pixels);
  EXPECT_EQ(votes.update(), all);
}

TEST(ColorVotes, changedOptionsApplyToAllThatWasAdded) {
  ColorVotes early(3, {.radius = 5, .brightnessWeight = 0.5}), late(3);
  for (ColorVotes* votes : {&early, &late}) {
    add(*votes, kOrange, 1);
    add(*votes, kGreen, 2, 200);
    add(*votes, kWall, 0);
  }
  EXPECT_NE(early.update(), late.update());
  late.setOptions(early.options());
  EXPECT_EQ(early.update(), late.update());
}

TEST(ColorVotes, manySamplesWithAWideKernelDoNotOverflow) {
  ColorVotes votes(
      2, {.radius = VoteOptions::kMaxRadius, .brightnessWeight = VoteOptions::kMinBrightnessWeight});
  for (int y = 0; y < 256; y += 16) {
    for (int cb = 96; cb < 160; cb += 4) {
      for (int cr = 96; cr < 160; cr += 4) {
        add(votes,
            {static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr)}, 1,
            1'000'000);
      }
    }
  }
  const ColorTable& table = votes.update();
  for (int y = 0; y < 256; y += 4) EXPECT_EQ(table.classOf({static_cast<std::uint8_t>(y), 128, 128}), 1) << y;
}

TEST(ColorVotes, aBallInTheShadeIsStillOrange) {
  ColorVotes votes(3), near(3, {.shading = 0});
  for (ColorVotes* each : {&votes, &near}) {
    add(*each, {160, 80, 190}, 1);
    add(*each, kGreen, 2);
  }
  const YCbCr shaded{67, 104, 159};  // half the light
  EXPECT_EQ(votes.update().classOf(shaded), 1);
  EXPECT_EQ(near.update().classOf(shaded), 0) << "that is what the shade is for";
}

TEST(ColorVotes, whatIsNearlyGrayIsNoThingUnlessManySamplesSaySo) {
  ColorVotes votes(3);
  votes.setThings({false, true, false});
  add(votes, {100, 138, 118}, 1, 2);  // a bluish goal, two pixels of it
  add(votes, {100, 100, 100}, 2, 2);
  const YCbCr wall{100, 129, 126};
  EXPECT_EQ(votes.update().classOf(wall), 0);
  EXPECT_EQ(votes.update().classOf({100, 142, 112}), 1);
  votes.setThings({false, false, false});
  EXPECT_EQ(votes.update().classOf(wall), 1) << "of the ground nothing more is asked";
  votes.setThings({false, true, false});
  add(votes, wall, 1, 20);
  EXPECT_EQ(votes.update().classOf(wall), 1) << "a stroke there counts more";
}

/// The samples of a class add up also where there are none.
TEST(ColorVotes, moreStrokesDoNotTakeMoreOfTheWall) {
  const YCbCr wall{95, 136, 122}, goal{90, 150, 106};
  std::mt19937 random(3);
  const auto near = [&random](YCbCr color) {
    return YCbCr{static_cast<std::uint8_t>(color.y + random() % 24 - 12),
                 static_cast<std::uint8_t>(color.cb + random() % 12 - 6),
                 static_cast<std::uint8_t>(color.cr + random() % 12 - 6)};
  };
  ColorVotes votes(2);
  votes.setThings({false, true});
  for (int stroke = 1; stroke <= 30; ++stroke) {
    for (int i = 0; i < 29; ++i) add(votes, near(goal), 1, 1);
    const ColorTable& table = votes.update();
    ASSERT_EQ(table.classOf(wall), 0) << "after " << stroke << " strokes";
    ASSERT_EQ(table.classOf(goal), 1) << "after " << stroke << " strokes";
  }
  add(votes, wall, 1, 29);
  EXPECT_EQ(votes.update().classOf(wall), 1) << "who paints it wants it";
  add(votes, wall, 1, -29);
  EXPECT_EQ(votes.update().classOf(wall), 0) << "and it can be undone";
}

TEST(ColorVotes, aPaleBallInTheShadeIsNotLostToRed) {
  // A real ball in the light, a robot, and the ball in the shade: duller, of nearly the same hue.
  const YCbCr ball{131, 87, 178}, robot{86, 110, 178}, dull{102, 97, 175};
  ColorVotes votes(3);
  votes.setThings({false, true, true});
  for (const int off : {-4, 0, 4}) {
    const auto at = [off](YCbCr color) {
      return YCbCr{static_cast<std::uint8_t>(color.y + 3 * off), color.cb,
                   static_cast<std::uint8_t>(color.cr + off / 2)};
    };
    add(votes, at(ball), 1, 10);
    add(votes, at(robot), 2, 10);
    add(votes, {static_cast<std::uint8_t>(86 + off), 106, 178}, 2, 10);
  }
  EXPECT_EQ(votes.update().classOf(dull), 1);
}

TEST(ColorVotes, whatMustNotBeReachesNoFartherThanASample) {
  ColorVotes votes(2);
  add(votes, {160, 80, 190}, 1);
  const YCbCr shaded{67, 104, 159};
  ASSERT_EQ(votes.update().classOf(shaded), 1);
  add(votes, {160, 92, 178}, 1, -100);
  EXPECT_EQ(votes.update().classOf(shaded), 1);
  EXPECT_EQ(votes.update().classOf({160, 92, 178}), 0);
}

TEST(ColorVotes, theMarginIsSmallBetweenClassesAndLargeWithinThem) {
  ColorVotes votes(3);
  add(votes, {150, 100, 150}, 1);
  add(votes, {150, 124, 150}, 2);
  votes.update();
  EXPECT_GT(votes.margin(ColorTable::cellOf({150, 100, 150})), 0.5);
  EXPECT_LT(votes.margin(ColorTable::cellOf({150, 112, 150})), 0.3);
  EXPECT_EQ(votes.margin(ColorTable::cellOf({150, 30, 60})), 1) << "surely nothing";
  EXPECT_EQ(votes.classesOf(ColorTable::cellOf({150, 112, 150}), 0.5), 0b11);
  EXPECT_EQ(votes.classesOf(ColorTable::cellOf({150, 100, 150}), 0.5), 0b01);
}

}  // namespace
}  // namespace colortool
