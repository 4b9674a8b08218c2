// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugKey.h"

#include <gtest/gtest.h>

#include "robotlink/debugging/DebugContext.h"

using namespace robotlink;

namespace {

const ImageDrawingKey kFirstKey{"key-test/first", "The first"};
const PlotKey kSecondKey{"key-test/second", "The second"};

// In a child process, so that this program's keys stay as they are.
void declare(const char* name) {
  const ImageKey key{name, "help"};
}

}  // namespace

TEST(DebugKey, allKeysAreKnownBeforeMainByNameAndIndex) {
  ASSERT_LT(static_cast<std::size_t>(kSecondKey.index()), DebugKey::all().size());
  EXPECT_NE(kFirstKey.index(), kSecondKey.index());
  EXPECT_EQ(kFirstKey.name(), "key-test/first");
  EXPECT_EQ(DebugKey::all()[static_cast<std::size_t>(kSecondKey.index())].help, "The second");
  EXPECT_EQ(DebugKey::find("key-test/second"), kSecondKey.index());
  EXPECT_EQ(DebugKey::find("key-test/third"), -1);
}

TEST(DebugKey, itsTypeSaysOnWhichStreamItPublishes) {
  EXPECT_EQ(kFirstKey.stream(), "drawings/image/key-test/first");
  EXPECT_EQ(kSecondKey.stream(), "plots/key-test/second");
}

TEST(DebugKeyDeathTest, aNameThatIsDeclaredTwiceEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(declare("key-test/first"), "debug key \"key-test/first\": declared twice");
}

TEST(DebugKeyDeathTest, aNameThatIsNoPathEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const char* name : {"", "/a", "a/", "a//b", "Upper/case", "a b"}) {
    EXPECT_DEATH(declare(name), "a name is a path of lowercase letters");
  }
}

TEST(DebugKeyDeathTest, aKeyThatIsDeclaredAfterAContextWasMadeEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(
      {
        const ManualClock clock;
        const DebugContext debug("cognition", clock, {});
        declare("key-test/late");
      },
      "declare keys at namespace scope");
}
