// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/SensorErrors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

using testing::HasSubstr;

std::string wrongNoise(NoiseModel noise) {
  return wrongErrors({{NoiseModel{}, noise}});
}

TEST(SensorErrorsTest, oneNoiseIsThatOfAllChannelsAndSeveralAreOneForEach) {
  EXPECT_EQ(SensorErrors{}.of(0), NoiseModel{});
  const SensorErrors shared{{{.stddev = 2}}};
  EXPECT_EQ(shared.of(0).stddev, 2);
  EXPECT_EQ(shared.of(7).stddev, 2);
  const SensorErrors each{{{.stddev = 2}, {.stddev = 3}}};
  EXPECT_EQ(each.of(1).stddev, 3);
  EXPECT_EQ(each.of(2), NoiseModel{}) << "a channel without one is exact";
}

TEST(SensorErrorsTest, delayRateAndLostSamplesAreTiming) {
  EXPECT_FALSE((SensorErrors{{{.stddev = 2}}}.hasTiming()));
  EXPECT_TRUE((SensorErrors{.delay = 0.1}.hasTiming()));
  EXPECT_TRUE((SensorErrors{.rate = 30}.hasTiming()));
  EXPECT_TRUE((SensorErrors{.dropout = 0.1}.hasTiming()));
}

TEST(SensorErrorsTest, whatIsPossibleIsNotWrong) {
  EXPECT_STREQ(wrongErrors({}), "");
  EXPECT_EQ(wrongNoise({.mean = -5, .biasMean = -1, .driftTime = 10, .precision = 0.5}), "");
  EXPECT_STREQ(wrongErrors({{}, SensorErrors::kMaxDelay, 1e6, 1}), "") << "the ends are possible";
}

TEST(SensorErrorsTest, theFirstThingThatIsWrongIsSaidForAnyChannel) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_THAT(wrongNoise({.mean = bad}), HasSubstr("a mean")) << bad;
    EXPECT_THAT(wrongNoise({.biasMean = bad}), HasSubstr("a mean")) << bad;
  }
  for (const double bad : {nan, infinite, -0.1}) {
    EXPECT_THAT(wrongNoise({.stddev = bad}), HasSubstr("standard deviation")) << bad;
    EXPECT_THAT(wrongNoise({.biasStddev = bad}), HasSubstr("standard deviation")) << bad;
    EXPECT_THAT(wrongNoise({.driftStddev = bad}), HasSubstr("standard deviation")) << bad;
    EXPECT_THAT(wrongNoise({.driftTime = bad}), HasSubstr("time constant")) << bad;
    EXPECT_THAT(wrongNoise({.precision = bad}), HasSubstr("precision")) << bad;
    EXPECT_THAT(wrongErrors({.delay = bad}), HasSubstr("a delay must be between 0 and 1 s")) << bad;
    EXPECT_THAT(wrongErrors({.rate = bad}), HasSubstr("a rate")) << bad;
    EXPECT_THAT(wrongErrors({.dropout = bad}), HasSubstr("drop-out")) << bad;
  }
  EXPECT_THAT(wrongErrors({.delay = 1.01}), HasSubstr("a delay"));
  EXPECT_THAT(wrongErrors({.dropout = 1.01}), HasSubstr("drop-out"));
}

TEST(SensorErrorsTest, theyAreAPartOfAState) {
  SensorErrors errors{{{.mean = -1, .stddev = 0.5}, {.biasMean = 2, .precision = 0.1}}, 0.25, 20, 0.1};
  std::vector<std::uint8_t> bytes;
  StateStream out(bytes);
  transferErrors(out, errors);
  StateStream in(bytes, StateStream::Trust::kForeign);
  SensorErrors read;
  transferErrors(in, read);
  EXPECT_TRUE(in.complete());
  EXPECT_EQ(read, errors);
}

TEST(SensorErrorsTest, aStateOfOthersHasNoErrorsThatNobodyMayChoose) {
  const auto isRead = [](SensorErrors errors) {
    std::vector<std::uint8_t> bytes;
    StateStream out(bytes);
    transferErrors(out, errors);
    StateStream in(bytes, StateStream::Trust::kForeign);
    SensorErrors read;
    transferErrors(in, read);
    return in.good();
  };
  EXPECT_TRUE(isRead({{{.mean = -1e9}}}));
  EXPECT_FALSE(isRead({{{.mean = std::nan("")}}}));
  EXPECT_FALSE(isRead({{{.stddev = -1}}}));
  EXPECT_FALSE(isRead({.delay = 2}));
  EXPECT_FALSE(isRead({.dropout = 1.5}));
  EXPECT_FALSE(isRead({std::vector<NoiseModel>(2000)})) << "no sensor has so many channels";
}

}  // namespace
}  // namespace simcore
