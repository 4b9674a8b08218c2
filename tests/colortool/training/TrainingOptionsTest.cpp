// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/TrainingOptions.h"

#include <gtest/gtest.h>

#include "colortool/votes/ColorVotes.h"

namespace colortool {
namespace {

TEST(TrainingOptionsTest, eachOptionIsWhatItWasSetTo) {
  for (const TrainingOption& option : trainingOptions()) {
    for (const double value : {option.least, option.most}) {
      const auto changed = withOption({}, option.name, value);
      ASSERT_TRUE(changed) << option.name;
      EXPECT_EQ(option.get(*changed), value) << option.name;
      // And only that one.
      TrainingSettings back = *changed;
      option.set(back, option.get({}));
      EXPECT_EQ(back, TrainingSettings{}) << option.name;
    }
    const double usual = option.get({});
    EXPECT_GE(usual, option.least) << option.name;
    EXPECT_LE(usual, option.most) << option.name;
  }
}

TEST(TrainingOptionsTest, noOptionGoesBeyondWhatTheTrainingHeeds) {
  for (const TrainingOption& option : trainingOptions()) {
    for (const double value : {option.least, option.most}) {
      const auto changed = withOption({}, option.name, value);
      ASSERT_TRUE(changed) << option.name;
      const VoteOptions heeded = ColorVotes(2, changed->votes).options();
      TrainingSettings back = *changed;
      back.votes = heeded;
      EXPECT_EQ(option.get(back), value) << option.name;
    }
  }
}

TEST(TrainingOptionsTest, whatCannotBeIsRefusedWithWhatCan) {
  EXPECT_NE(withOption({}, "radios", 3).error().text.find("radius, brightness-weight"), std::string::npos);
  EXPECT_NE(withOption({}, "radius", 25).error().text.find("between 2 and 24"), std::string::npos);
  EXPECT_FALSE(withOption({}, "radius", std::nan("")));
  EXPECT_FALSE(withOption({}, "fill-holes", 0.5));
}

TEST(TrainingOptionsTest, methodsHaveNames) {
  for (const TrainingMethod method :
       {TrainingMethod::kVotes, TrainingMethod::kGaussians, TrainingMethod::kSupportVectors})
    EXPECT_EQ(trainingMethod(nameOf(method)), method);
  EXPECT_NE(trainingMethod("magic").error().text.find("votes, gaussians, support-vectors"),
            std::string::npos);
}

}  // namespace
}  // namespace colortool
