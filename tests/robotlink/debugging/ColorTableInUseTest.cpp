// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ColorTableInUse.h"

#include <gtest/gtest.h>

using namespace robotlink;

namespace {

robotcontrol::ColorTable tableFrom(const std::string& source) {
  robotcontrol::ColorTable table;
  table.add_class_names("orange");
  table.set_cells("\1");
  table.mutable_correction()->set_luma_r2(0.5);
  table.set_source(source);
  table.mutable_loaded()->set_seconds(1234);
  return table;
}

TEST(ColorTableInUse, saysWhereATableIsFromWithoutItsCells) {
  const auto table = tableFrom("/home/me/game.c64");
  const auto inUse = colorTableInUse(&table);
  EXPECT_EQ(inUse.source(), "/home/me/game.c64");
  EXPECT_EQ(inUse.class_names_size(), 1);
  EXPECT_EQ(inUse.loaded().seconds(), 1234);
  EXPECT_TRUE(inUse.cells().empty());
  EXPECT_FALSE(inUse.has_correction());
  EXPECT_EQ(describeColorTable(inUse), "The color table is now /home/me/game.c64");
}

TEST(ColorTableInUse, isTheBuiltInOneWithoutATableOrCells) {
  const robotcontrol::ColorTable takenBack;
  for (const robotcontrol::ColorTable* table :
       {static_cast<const robotcontrol::ColorTable*>(nullptr), &takenBack}) {
    EXPECT_EQ(colorTableInUse(table).source(), "built-in");
    EXPECT_EQ(describeColorTable(colorTableInUse(table)), "The color table is now the built-in one");
  }
}

TEST(ColorTableInUse, ofAnOlderProgramHasASourceThatSaysThatNobodyKnows) {
  const auto table = tableFrom("");
  EXPECT_EQ(colorTableInUse(&table).source(), "sent, from an unknown source");
}

}  // namespace
