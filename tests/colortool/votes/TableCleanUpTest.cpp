// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/TableCleanUp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "colortool/votes/ColorVotes.h"
#include "tests/colortool/PlainCleanUp.h"

namespace colortool {
namespace {

/// All cells from `first` to `last` in each channel, both inclusive.
void setBlock(ColorTable& table, std::array<int, 3> first, std::array<int, 3> last, std::uint8_t colorClass) {
  for (int y = first[0]; y <= last[0]; ++y) {
    for (int cb = first[1]; cb <= last[1]; ++cb) {
      for (int cr = first[2]; cr <= last[2]; ++cr) table.setCell(y, cb, cr, colorClass);
    }
  }
}

std::size_t cleanedCell(int y, int cb, int cr) {
  return static_cast<std::size_t>(y * 4096 + cb * 64 + cr);
}

/// Three classes, of which 1 has a sample at (20, 20, 20) and 2 at (50, 50, 50).
class TableCleanUpTest : public testing::Test {
 protected:
  TableCleanUpTest() {
    sampled_[1].set(cleanedCell(20, 20, 20));
    sampled_[2].set(cleanedCell(50, 50, 50));
    setBlock(raw_, {10, 10, 10}, {30, 30, 30}, 1);
  }
  const ColorTable& clean(const CleanUpOptions& options = {}) {
    return cleanUp_.clean(raw_, sampled_, options);
  }

  ColorTable raw_;
  std::vector<CellSet> sampled_ = std::vector<CellSet>(4);
  TableCleanUp cleanUp_;
};

TEST_F(TableCleanUpTest, whatIsConnectedWithASampleStays) {
  raw_.setCell(31, 31, 31, 1);
  EXPECT_EQ(clean(), raw_);
}

TEST_F(TableCleanUpTest, islandsWithoutASampleGo) {
  raw_.setCell(40, 31, 31, 1);
  setBlock(raw_, {40, 40, 40}, {45, 45, 45}, 2);
  EXPECT_EQ(clean().cell(40, 31, 31), 0);
  EXPECT_EQ(clean().cell(42, 42, 42), 0) << "the sample of its class is elsewhere";
  EXPECT_EQ(clean().cell(10, 30, 10), 1);
  EXPECT_EQ(clean({false, true}), raw_);
  sampled_[2].set(cleanedCell(44, 44, 44));
  EXPECT_EQ(clean().cell(42, 42, 42), 2);
}

TEST_F(TableCleanUpTest, holesOfOneClassAreFilledUnlessBackgroundWasSampledThere) {
  setBlock(raw_, {15, 15, 15}, {16, 16, 16}, 0);
  EXPECT_EQ(clean().cell(15, 16, 15), 1);
  EXPECT_EQ(clean({true, false}), raw_);
  sampled_[0].set(cleanedCell(16, 16, 16));
  EXPECT_EQ(clean(), raw_);
}

TEST_F(TableCleanUpTest, whatOpensToTheSidesOrToAnotherClassIsNoHole) {
  setBlock(raw_, {15, 15, 10}, {15, 15, 20}, 0);
  EXPECT_EQ(clean().cell(15, 15, 20), 0) << "opens to the outside";
  sampled_[2].set(cleanedCell(15, 15, 10));
  raw_.setCell(15, 15, 10, 2);
  EXPECT_EQ(clean().cell(15, 15, 20), 0) << "closed by another class";
  raw_.setCell(15, 15, 10, 1);
  EXPECT_EQ(clean().cell(15, 15, 20), 1);
  setBlock(raw_, {0, 40, 40}, {5, 45, 45}, 3);
  sampled_[3].set(cleanedCell(3, 43, 43));
  raw_.setCell(0, 42, 42, 0);
  EXPECT_EQ(clean().cell(0, 42, 42), 0) << "at a side of the cube";
}

TEST_F(TableCleanUpTest, anIslandInsideOfAClassBecomesOfIt) {
  setBlock(raw_, {15, 15, 15}, {16, 16, 16}, 2);
  EXPECT_EQ(clean().cell(15, 15, 15), 1);
  EXPECT_EQ(clean({true, false}).cell(15, 15, 15), 0);
}

/// Blobs of votes, then all kinds of noise: few cells, many, and so many that there are holes.
ColorTable randomTable(std::mt19937& random, int classes) {
  ColorTable table;
  for (int i = 0; i < 12; ++i) {
    std::array<int, 3> first{}, last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = static_cast<int>(random() % 64);
      last[axis] = std::min(63, first[axis] + static_cast<int>(random() % 30));
    }
    setBlock(table, first, last, static_cast<std::uint8_t>(random() % static_cast<unsigned>(classes)));
  }
  for (std::size_t i = random() % 60000; i > 0; --i) {
    const auto at = [&] { return static_cast<int>(random() % 64); };
    table.setCell(at(), at(), at(), static_cast<std::uint8_t>(random() % static_cast<unsigned>(classes)));
  }
  return table;
}

TEST(TableCleanUp, randomTablesAreCleanedAsCellByCellWhateverWasBefore) {
  std::mt19937 random(11);
  TableCleanUp remembers;
  for (int round = 0; round < 12; ++round) {
    const int classes = 2 + static_cast<int>(random() % 5);
    const ColorTable raw = randomTable(random, classes);
    std::vector<CellSet> sampled(static_cast<std::size_t>(classes));
    for (int i = 0; i < 200; ++i) sampled[random() % sampled.size()].set(random() % ColorTable::kCellCount);
    const CleanUpOptions options{random() % 4 != 0, random() % 4 != 0};
    const ColorTable& cleaned = remembers.clean(raw, sampled, options);
    const std::vector<std::uint8_t> expected = plainCleanUp(raw, sampled, options);
    ASSERT_TRUE(std::ranges::equal(cleaned.cells(), expected)) << "round " << round;
    ASSERT_EQ(TableCleanUp().clean(raw, sampled, options), cleaned) << "round " << round;
  }
}

/// As in use: strokes come and go, and only some classes change from call to call.
TEST(TableCleanUp, smallChangesAreFollowedExactly) {
  std::mt19937 random(5);
  TableCleanUp remembers;
  ColorVotes votes(5, {6, 0.5, 0.4, 1});
  for (int step = 0; step < 24; ++step) {
    const robotlink::YCbCr color{static_cast<std::uint8_t>(random()),
                                 static_cast<std::uint8_t>(80 + random() % 90),
                                 static_cast<std::uint8_t>(80 + random() % 90)};
    votes.add(ColorTable::cellOf(color), static_cast<std::uint8_t>(random() % 5),
              (step % 3 == 2 ? -20 : 20) * ColorVotes::kUnit);
    const ColorTable& raw = votes.update();
    const ColorTable& cleaned = remembers.clean(raw, votes.sampledCells(), {});
    std::vector<CellSet> sampled(5);
    for (const auto& sample : votes.samples()) sampled[sample.colorClass].set(sample.cell);
    ASSERT_EQ(cleaned, TableCleanUp().clean(raw, sampled, {})) << "step " << step;
    if (step % 5 != 0) continue;
    ASSERT_TRUE(std::ranges::equal(cleaned.cells(), plainCleanUp(raw, sampled, {}))) << "step " << step;
  }
}

TEST(TableCleanUp, withoutSamplesNothingIsSupported) {
  ColorTable raw;
  setBlock(raw, {10, 10, 10}, {30, 30, 30}, 200);
  EXPECT_EQ(TableCleanUp().clean(raw, {}, {}), ColorTable());
  EXPECT_EQ(TableCleanUp().clean(raw, {}, {false, true}), raw);
}

}  // namespace
}  // namespace colortool
