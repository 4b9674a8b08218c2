// SPDX-License-Identifier: GPL-3.0-or-later
// A table learned from what one Aibo saw, and scored on what the others saw: real ones, and made ones.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>

#include "colortool/votes/ColorVotes.h"
#include "colortool/votes/TableCleanUp.h"
#include "robotlink/base/Random.h"
#include "tests/colortool/AiboPatches.h"
#include "tests/game/Data.h"

namespace {

using colortool::ColorTable;
using colortool::ColorVotes;
using colortool::TableCleanUp;

using Colors = std::vector<robotlink::YCbCr>;
using Session = std::map<std::string, Colors>;  // by label

constexpr std::size_t kPixelsOfAStroke = 29;

std::map<std::string, Session> sessions(const std::vector<AiboPixel>& pixels) {
  std::map<std::string, Session> result;
  for (const AiboPixel& pixel : pixels) result[pixel.session][pixel.label].push_back(pixel.color);
  return result;
}

/// Learns from as many pixels of each color as a stroke has, chosen at random.
ColorTable learned(const Session& session, unsigned seed) {
  ColorVotes votes(static_cast<int>(session.size()) + 1);
  std::mt19937 random(seed);
  std::uint8_t colorClass = 0;
  for (const auto& [label, colors] : session) {
    ++colorClass;
    for (std::size_t i = 0; i < kPixelsOfAStroke; ++i)
      votes.add(ColorTable::cellOf(colors[random() % colors.size()]), colorClass, ColorVotes::kUnit);
  }
  TableCleanUp cleanUp;
  return cleanUp.clean(votes.update(), votes.sampledCells(), {});
}

struct RobotScore {
  std::uint64_t right = 0, all = 0;
  double share() const { return static_cast<double>(right) / static_cast<double>(all); }
};

void addScore(RobotScore& score, const ColorTable& table, const Session& session) {
  std::uint8_t colorClass = 0;
  for (const auto& [label, colors] : session) {
    ++colorClass;
    for (const robotlink::YCbCr color : colors) score.right += table.classOf(color) == colorClass ? 1 : 0;
    score.all += colors.size();
  }
}

/// Pixels of three cameras, which see the same seven colors each with a cast of its own, and with noise.
std::vector<AiboPixel> madePatches() {
  const std::map<std::string, robotlink::YCbCr> colors{
      {"blue", {60, 160, 110}},  {"green", {80, 105, 100}}, {"lightblue", {130, 165, 95}},
      {"pink", {120, 120, 180}}, {"red", {80, 110, 190}},   {"white", {200, 128, 128}},
      {"yellow", {150, 70, 150}}};
  robotlink::Random random(7);
  std::vector<AiboPixel> pixels;
  const auto seen = [&random](std::uint8_t value, double cast, double noise) {
    return static_cast<std::uint8_t>(std::clamp(value + cast + noise * random.normal(), 0.0, 255.0));
  };
  for (const double cast : {-1.0, 0.0, 1.0}) {
    for (const auto& [label, color] : colors) {
      for (int i = 0; i < 300; ++i) {
        pixels.push_back(
            {"a day, cast " + std::to_string(cast),
             label,
             {seen(color.y, 2 * cast, 4), seen(color.cb, cast, 1.5), seen(color.cr, -cast, 1.5)}});
      }
    }
  }
  return pixels;
}

/// The parameter is the source of the pixels.
class CrossRobot : public testing::TestWithParam<std::string> {};

TEST_P(CrossRobot, aTableOfOneAiboSortsTheColorsOfTheOthers) {
  const auto robots = sessions(GetParam() == "real" ? readAiboPatches() : madePatches());
  if (robots.empty())
    GTEST_SKIP() << "the labeled pixels are not in ../shared/data/colour/ers7, or xz is missing";
  ASSERT_GE(robots.size(), 2U);
  RobotScore total;
  for (const auto& [teacher, session] : robots) {
    ASSERT_EQ(session.size(), 7U) << teacher;
    RobotScore score;
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const ColorTable table = learned(session, seed);
      for (const auto& [pupil, other] : robots) {
        if (pupil != teacher) addScore(score, table, other);
      }
    }
    // One of the robots sees green nearly as blue as others see light blue.
    EXPECT_GT(score.share(), 0.996) << "learned from " << teacher;
    total.right += score.right;
    total.all += score.all;
  }
  std::printf("%.3f %% of the colors that other robots saw\n", 100 * total.share());
  EXPECT_GE(total.share(), 0.998) << total.right << " of " << total.all;
}

INSTANTIATE_TEST_SUITE_P(Pixels, CrossRobot, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
