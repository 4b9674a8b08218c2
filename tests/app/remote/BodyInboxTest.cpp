// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/BodyInbox.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using robotlink::Instant;
using std::chrono::milliseconds;

/// Two programs that command bodies.
class BodyInboxTest : public testing::Test {
 protected:
  /// Commands are told apart by their number.
  static robotcontrol::BodyCommands commands(std::uint64_t number) {
    robotcontrol::BodyCommands made;
    made.set_number(number);
    return made;
  }
  std::string put(const BodyInbox::Sender& from, std::uint64_t number, Instant now,
                  const std::string& robot = "red1") {
    return inbox_.put(robot, from, commands(number), now);
  }
  /// The number of what is taken; 0: there is nothing.
  std::uint64_t taken(const std::string& robot = "red1") {
    const auto newest = inbox_.take(robot);
    return newest ? newest->number() : 0;
  }

  static constexpr Instant kStart{std::chrono::seconds(100)};
  const BodyInbox::Sender first_{1, "Ann"}, second_{2, "Bob"};
  BodyInbox inbox_;
};

TEST_F(BodyInboxTest, theNewestCommandIsTakenOnce) {
  EXPECT_EQ(taken(), 0U);
  EXPECT_EQ(put(first_, 7, kStart), "");
  EXPECT_EQ(put(first_, 8, kStart), "");
  EXPECT_EQ(taken(), 8U);
  EXPECT_EQ(taken(), 0U);
}

TEST_F(BodyInboxTest, aBodyObeysOneProgramAtATime) {
  ASSERT_EQ(put(first_, 1, kStart), "");
  EXPECT_EQ(put(second_, 2, kStart + milliseconds(1999)),
            "red1 obeys the program of Ann; end that program first");
  EXPECT_EQ(taken(), 1U) << "what was refused replaces nothing";
  EXPECT_EQ(inbox_.commander("red1"), "Ann");
}

TEST_F(BodyInboxTest, aProgramThatIsSilentForTooLongIsGivenUp) {
  ASSERT_EQ(put(first_, 1, kStart), "");
  EXPECT_EQ(put(second_, 2, kStart + BodyInbox::kGivenUp), "");
  EXPECT_EQ(inbox_.commander("red1"), "Bob");
  EXPECT_EQ(taken(), 2U);
  EXPECT_NE(put(first_, 3, kStart + BodyInbox::kGivenUp + milliseconds(1)), "") << "now it is the other one";
}

TEST_F(BodyInboxTest, eachCommandKeepsTheBodyButNoRefusalDoes) {
  ASSERT_EQ(put(first_, 1, kStart), "");
  ASSERT_EQ(put(first_, 2, kStart + milliseconds(1500)), "");
  EXPECT_NE(put(second_, 3, kStart + milliseconds(3000)), "");
  EXPECT_EQ(put(second_, 4, kStart + milliseconds(3500)), "") << "two seconds after the last command";
}

TEST_F(BodyInboxTest, bodiesObeyDifferentPrograms) {
  ASSERT_EQ(put(first_, 1, kStart), "");
  EXPECT_EQ(put(second_, 2, kStart, "red2"), "");
  EXPECT_EQ(inbox_.commander("red1"), "Ann");
  EXPECT_EQ(inbox_.commander("red2"), "Bob");
  EXPECT_EQ(inbox_.commander("red3"), "");
  EXPECT_EQ(taken("red2"), 2U);
  EXPECT_EQ(taken("red1"), 1U);
  EXPECT_EQ(inbox_.commander("red1"), "Ann") << "also when all was taken";
}

}  // namespace
}  // namespace app
