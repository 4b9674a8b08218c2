// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Spelling.h"

#include <gtest/gtest.h>

using namespace robotlink;

namespace {

TEST(SpellingTest, theNearestCandidateIsFound) {
  EXPECT_EQ("ball-model", nearest("ball-modell", {"ball-percept", "ball-model", "motion"}));
  EXPECT_EQ("motion", nearest("motoin", {"ball-model", "motion"}));
  EXPECT_EQ("a", nearest("b", {"a", "c"})) << "the first of equally near ones";
}

TEST(SpellingTest, whatIsFarAwayIsNotMeant) {
  EXPECT_EQ("", nearest("cooking", {"ball-model", "motion"}));
  EXPECT_EQ("", nearest("word", {}));
}

TEST(SpellingTest, aSuggestionNamesTheNearestOrTheChoice) {
  EXPECT_EQ("; did you mean 'motion'?", suggestion("motoin", {"ball-model", "motion"}));
  EXPECT_EQ("; there are stand, walk", suggestion("somersault", {"stand", "walk"}));
  EXPECT_EQ("; there is walk", suggestion("somersault", {"walk"}));
  EXPECT_EQ("", suggestion("walk", {}));
}

}  // namespace
