// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/StateStream.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace simcore {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Trust = StateStream::Trust;

enum class Phase : std::uint8_t { kRest, kWalk, kFall };

/// One value of each kind.
struct Sample {
  std::uint64_t steps = 0;
  bool isOn = false;
  Phase phase = Phase::kRest;
  double speed = 0, share = 0;
  std::uint16_t level = 0;
  robotlink::Vector3 place = robotlink::Vector3::Zero();
  robotlink::Pose2 ground;
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  std::string name;
  std::vector<bool> touched = {false, false, false};
  std::vector<double> list;

  void transfer(StateStream& stream) {
    stream.raw(steps);
    stream.flag(isOn);
    stream.choice(phase, Phase::kFall);
    stream.number(speed);
    stream.within(share, 0, 1);
    stream.upTo(level, std::uint16_t{500});
    stream.vector(place);
    stream.pose(ground);
    stream.pose(pose);
    stream.text(name);
    stream.bits(touched);
    stream.size(list, 10);
    for (double& value : list) stream.number(value);
  }
};

Sample sample() {
  Sample sample;
  sample.steps = 0xFEDCBA9876543210U;
  sample.isOn = true;
  sample.phase = Phase::kWalk;
  sample.speed = -0.1;
  sample.share = 1;
  sample.level = 500;
  sample.place = {1, 2, 3};
  sample.ground = {4, 5, 0.5};
  sample.pose = robotlink::Pose3(Eigen::Translation3d(1, -2, 0.25)) *
                Eigen::AngleAxisd(0.7, robotlink::Vector3::UnitX());
  sample.name = "red1";
  sample.touched = {true, false, true};
  sample.list = {0.5, -7};
  return sample;
}

/// The bytes that one call writes.
template <typename Write>
std::vector<std::uint8_t> written(Write write) {
  std::vector<std::uint8_t> bytes;
  StateStream stream(bytes);
  write(stream);
  return bytes;
}

std::vector<std::uint8_t> bytesOfNumber(double value) {
  return written([&](StateStream& stream) { stream.raw(value); });
}

std::vector<std::uint8_t> bytesOf(Sample value) {
  return written([&](StateStream& stream) { value.transfer(stream); });
}

TEST(StateStreamTest, whatIsWrittenIsReadToTheLastBit) {
  const std::vector<std::uint8_t> bytes = bytesOf(sample());
  StateStream stream(bytes, Trust::kForeign);
  Sample read;
  read.transfer(stream);
  EXPECT_TRUE(stream.complete());
  EXPECT_EQ(read.steps, 0xFEDCBA9876543210U);
  EXPECT_TRUE(read.isOn);
  EXPECT_EQ(read.phase, Phase::kWalk);
  EXPECT_EQ(read.level, 500);
  EXPECT_EQ(read.ground.heading, 0.5);
  EXPECT_EQ(read.pose.matrix(), sample().pose.matrix());
  EXPECT_EQ(read.name, "red1");
  EXPECT_EQ(read.touched, sample().touched);
  EXPECT_THAT(read.list, ElementsAre(0.5, -7));
  EXPECT_EQ(bytesOf(read), bytes);
}

TEST(StateStreamTest, bytesThatAreLeftMakeItIncompleteButNotBad) {
  std::vector<std::uint8_t> bytes = bytesOf(sample());
  bytes.push_back(0);
  StateStream stream(bytes, Trust::kForeign);
  Sample read;
  read.transfer(stream);
  EXPECT_TRUE(stream.good());
  EXPECT_FALSE(stream.complete());
}

TEST(StateStreamTest, aStateThatEndsEarlyIsBadWhereverItEnds) {
  const std::vector<std::uint8_t> bytes = bytesOf(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    for (const Trust trust : {Trust::kOwn, Trust::kForeign}) {
      const std::span<const std::uint8_t> cut(bytes.data(), size);
      StateStream stream(cut, trust);
      Sample read;
      read.transfer(stream);
      EXPECT_FALSE(stream.good()) << size;
    }
  }
}

TEST(StateStreamTest, whatCannotBeReadLeavesValuesAsTheyAre) {
  StateStream stream({}, Trust::kForeign);
  Sample kept = sample();
  kept.transfer(stream);
  EXPECT_FALSE(stream.good());
  EXPECT_EQ(kept.steps, sample().steps);
  EXPECT_EQ(kept.phase, Phase::kWalk);
  EXPECT_EQ(kept.speed, -0.1);
  EXPECT_EQ(kept.place, sample().place);
  EXPECT_EQ(kept.name, "red1");
  EXPECT_EQ(kept.touched, sample().touched);
  EXPECT_THAT(kept.list, IsEmpty()) << "but there is nothing to be walked through";
}

TEST(StateStreamTest, afterAnImpossibleValueNothingMoreIsRead) {
  std::vector<std::uint8_t> bytes = bytesOfNumber(7);
  const std::vector<std::uint8_t> more = bytesOfNumber(0.5);
  bytes.insert(bytes.end(), more.begin(), more.end());
  StateStream stream(bytes, Trust::kForeign);
  double first = 0.25, second = 0.25;
  stream.within(first, 0, 1);
  stream.within(second, 0, 1);
  EXPECT_FALSE(stream.good());
  EXPECT_EQ(first, 0.25);
  EXPECT_EQ(second, 0.25);
}

TEST(StateStreamTest, numbersOfOthersAreFiniteAndOfSensibleSize) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), kInfinite, -kInfinite, 1.1e7, -1.1e7}) {
    const std::vector<std::uint8_t> bytes = bytesOfNumber(bad);
    StateStream stream(bytes, Trust::kForeign);
    double value = 3;
    stream.number(value);
    EXPECT_FALSE(stream.good()) << bad;
    EXPECT_EQ(value, 3) << bad;
  }
  const std::vector<std::uint8_t> bytes = bytesOfNumber(-StateStream::kMaxNumber);
  StateStream stream(bytes, Trust::kForeign);
  double value = 3;
  stream.number(value);
  EXPECT_TRUE(stream.good());
  EXPECT_EQ(value, -1e7);
}

TEST(StateStreamTest, aSimulationThatBlewUpReadsItsOwnNumbers) {
  const std::vector<std::uint8_t> bytes = bytesOfNumber(std::nan(""));
  StateStream stream(bytes, Trust::kOwn);
  double value = 3;
  stream.number(value);
  EXPECT_TRUE(stream.complete());
  EXPECT_TRUE(std::isnan(value));
}

TEST(StateStreamTest, aSizeIsNeitherLargerThanAllowedNorThanWhatIsLeft) {
  const auto sizeRead = [](std::uint32_t size, std::size_t most, std::size_t left) {
    std::vector<std::uint8_t> bytes = written([&](StateStream& stream) { stream.raw(size); });
    bytes.resize(bytes.size() + left);
    // Sizes are not trusted even in what this program has written.
    StateStream stream(bytes, Trust::kOwn);
    std::vector<std::uint8_t> list = {1, 2, 3};
    stream.size(list, most);
    return stream.good() ? static_cast<int>(list.size()) : list.empty() ? -1 : -2;
  };
  EXPECT_EQ(sizeRead(4, 4, 4), 4);
  EXPECT_EQ(sizeRead(0, 4, 0), 0);
  EXPECT_EQ(sizeRead(5, 4, 100), -1);
  EXPECT_EQ(sizeRead(4, 4, 3), -1);
  EXPECT_EQ(sizeRead(0xFFFFFFFFU, 0xFFFFFFFFU, 8), -1);
}

TEST(StateStreamTest, aFlagIsZeroOrOne) {
  const std::vector<std::uint8_t> bytes = {2};
  for (const bool before : {false, true}) {
    StateStream foreign(bytes, Trust::kForeign);
    bool flag = before;
    foreign.flag(flag);
    EXPECT_FALSE(foreign.good());
    EXPECT_EQ(flag, before);
    StateStream again(bytes, Trust::kForeign);
    std::vector<bool> bits = {before};
    again.bits(bits);
    EXPECT_FALSE(again.good());
    EXPECT_EQ(bits[0], before);
  }
}

TEST(StateStreamTest, anEnumeratorThatDoesNotExistIsBadWhoeverWroteIt) {
  for (const Trust trust : {Trust::kOwn, Trust::kForeign}) {
    const std::vector<std::uint8_t> bytes = {3};
    StateStream stream(bytes, trust);
    Phase phase = Phase::kWalk;
    stream.choice(phase, Phase::kFall);
    EXPECT_FALSE(stream.good());
    EXPECT_EQ(phase, Phase::kWalk);
  }
}

TEST(StateStreamTest, aTextIsNotLongerThanWhatIsLeft) {
  const std::vector<std::uint8_t> bytes = {0xFF, 0xFF, 0xFF, 0x7F, 'a', 'b'};
  StateStream stream(bytes, Trust::kOwn);
  std::string text = "before";
  stream.text(text);
  EXPECT_FALSE(stream.good());
  EXPECT_EQ(text, "before");
}

TEST(StateStreamTest, whatIsRequiredCountsOnlyForStatesOfOthers) {
  const std::vector<std::uint8_t> bytes = {1};
  StateStream foreign(bytes, Trust::kForeign), own(bytes, Trust::kOwn);
  foreign.require(false);
  own.require(false);
  EXPECT_FALSE(foreign.good());
  EXPECT_TRUE(own.good());
  own.fail();
  EXPECT_FALSE(own.good());
  std::vector<std::uint8_t> out;
  StateStream writing(out);
  writing.require(false);
  EXPECT_TRUE(writing.good());
}

}  // namespace
}  // namespace simcore
