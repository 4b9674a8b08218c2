// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/ProgramPresence.h"

#include <gmock/gmock.h>

#include "tests/robotlink/dds/TestNodes.h"

namespace robotlink::test {
namespace {

using dds::ProgramPresence;
using testing::HasSubstr;

Result<std::unique_ptr<ProgramPresence>> claim(const std::string& program, const std::string& where,
                                               const std::string& robot = "red1") {
  return ProgramPresence::claim(openTestNode(), {robot, program, where}, [](const std::string&) {});
}

TEST(ProgramPresenceTest, aSecondProgramWithTheSameNameIsRefusedWithThePlaceOfTheFirst) {
  auto first = claim("plan", "process 1 on robot");
  ASSERT_TRUE(first) << first.error().describe();
  const auto second = claim("plan", "process 2 on desk");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().id, "spread.twice");
  EXPECT_THAT(second.error().text, HasSubstr("program plan of red1 runs already, as process 1 on robot"));
  EXPECT_TRUE(claim("drive", "process 3 on desk"));
  EXPECT_TRUE(claim("plan", "process 4 on desk", "red2"));
  EXPECT_TRUE(claim("plan", "process 1 on robot")) << "itself";
}

TEST(ProgramPresenceTest, theNameIsFreeWhenTheProgramHasEnded) {
  auto first = claim("walk", "process 1 on robot");
  ASSERT_TRUE(first);
  ASSERT_FALSE(claim("walk", "process 2 on robot"));
  first->reset();
  EXPECT_TRUE(claim("walk", "process 2 on robot"));
}

TEST(ProgramPresenceTest, aPlaceHasProcessAndMachine) {
  EXPECT_THAT(ProgramPresence::here(), testing::MatchesRegex("process [0-9]+ on .+"));
}

}  // namespace
}  // namespace robotlink::test
