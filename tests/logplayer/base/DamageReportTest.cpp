// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/DamageReport.h"

#include <gmock/gmock.h>

namespace logplayer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

mcap::Damage damageAt(std::uint64_t offset, const std::string& what) {
  mcap::Damage damage;
  damage.offset = offset;
  damage.what = what;
  return damage;
}

TEST(DamageReport, nothingIsSaidOfAWholeFile) {
  EXPECT_THAT(describeDamage("a.mcap", true, {}), IsEmpty());
}

TEST(DamageReport, aFileThatWasNotClosedMayHaveLostItsEnd) {
  EXPECT_THAT(describeDamage("a.mcap", false, {}),
              ElementsAre("a.mcap: the file was not closed: its end may be missing"));
  // What is known in detail says more.
  EXPECT_THAT(describeDamage("a.mcap", false, {damageAt(7, "it ends")}),
              ElementsAre("a.mcap: at byte 7: it ends"));
}

TEST(DamageReport, placesAreNamed) {
  EXPECT_THAT(describeDamage("logs/a.mcap", true,
                             {damageAt(0, "it is empty"), damageAt(1'000'000'000'000, "a chunk is lost")}),
              ElementsAre("logs/a.mcap: it is empty", "logs/a.mcap: at byte 1000000000000: a chunk is lost"));
}

TEST(DamageReport, veryManyPlacesAreCounted) {
  std::vector<mcap::Damage> damage(20, damageAt(1, "x"));
  EXPECT_EQ(describeDamage("a", true, damage).size(), 20U);
  damage.resize(123, damageAt(2, "y"));
  const auto report = describeDamage("a", true, damage);
  ASSERT_EQ(report.size(), 21U);
  EXPECT_EQ(report.back(), "a: and 103 more damaged places");
}

}  // namespace
}  // namespace logplayer
