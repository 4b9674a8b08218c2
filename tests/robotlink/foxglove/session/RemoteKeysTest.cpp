// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/RemoteKeys.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

using robotcontrol::KeyMode;
using robotcontrol::SetKey;

SetKey keyRequest(const std::string& name, KeyMode::Kind kind) {
  SetKey request;
  request.set_name(name);
  request.mutable_mode()->set_kind(kind);
  return request;
}

class RemoteKeysTest : public testing::Test {
 protected:
  RemoteKeysTest() {
    for (const char* name : {"disc", "circle"}) {
      auto& key = *table_.add_keys();
      key.set_name(name);
      key.set_stream(std::string("drawings/") + name);
    }
    table_.add_keys()->set_name("no-stream");
    keys_.setTable(table_);
  }
  void setMode(int key, KeyMode::Kind kind) {
    table_.mutable_keys(key)->mutable_mode()->set_kind(kind);
    keys_.setTable(table_);
  }
  robotcontrol::KeyTable table_;
  RemoteKeys keys_;
};

TEST_F(RemoteKeysTest, aKeyThatIsSwitchedOnBeforeTheTableComesIsASubscriptionThen) {
  RemoteKeys early;
  const auto on = early.set(keyRequest("disc", KeyMode::ALWAYS));
  EXPECT_TRUE(on.isForwarded) << "the robot says whether it has this key";
  EXPECT_TRUE(on.hasChanged);
  early.setTable(table_);
  EXPECT_TRUE(early.wants("drawings/disc"));
  EXPECT_EQ(early.shown().keys(0).mode().kind(), KeyMode::ALWAYS);
  const auto off = early.set(keyRequest("disc", KeyMode::OFF));
  EXPECT_TRUE(off.isChoice) << "the robot is told, too";
  EXPECT_FALSE(early.choice("disc").has_value());
  EXPECT_FALSE(early.wants("drawings/disc"));
}

TEST_F(RemoteKeysTest, aKeyThatIsSwitchedOnHereIsASubscription) {
  EXPECT_FALSE(keys_.wants("drawings/disc"));
  const auto on = keys_.set(keyRequest("disc", KeyMode::ALWAYS));
  EXPECT_FALSE(on.isForwarded);
  EXPECT_TRUE(on.hasChanged);
  EXPECT_TRUE(keys_.wants("drawings/disc"));
  EXPECT_TRUE(keys_.wants("drawings/disc/curve"));
  EXPECT_FALSE(keys_.wants("drawings/disc2"));
  EXPECT_EQ(keys_.shown().keys(0).mode().kind(), KeyMode::ALWAYS);
  const auto off = keys_.set(keyRequest("disc", KeyMode::OFF));
  EXPECT_FALSE(off.isForwarded);
  EXPECT_FALSE(keys_.wants("drawings/disc"));
}

TEST_F(RemoteKeysTest, aKeyThatIsOnForThisClientAloneIsShownAsOn) {
  EXPECT_EQ(keys_.shown(table_).keys(1).mode().kind(), KeyMode::OFF);
  keys_.set(keyRequest("circle", KeyMode::ALWAYS));
  EXPECT_EQ(keys_.shown(table_).keys(1).mode().kind(), KeyMode::ALWAYS);
  setMode(1, KeyMode::EVERY_N);
  EXPECT_EQ(keys_.shown(table_).keys(1).mode().kind(), KeyMode::EVERY_N);
}

TEST_F(RemoteKeysTest, whatTheRobotSwitchedOnItselfIsWantedAndSwitchedOffThere) {
  setMode(0, KeyMode::EVERY_N);
  EXPECT_TRUE(keys_.wants("drawings/disc"));
  EXPECT_TRUE(keys_.set(keyRequest("disc", KeyMode::OFF)).isForwarded);
  EXPECT_FALSE(keys_.wants("drawings/disc"));
  EXPECT_EQ(keys_.shown().keys(0).mode().kind(), KeyMode::OFF);
  keys_.setUnsent();
  EXPECT_EQ(keys_.takeUnsent(), std::vector<std::string>{"disc"});
  EXPECT_EQ(keys_.choice("disc")->kind(), KeyMode::OFF);
  const auto on = keys_.set(keyRequest("disc", KeyMode::ALWAYS));
  EXPECT_TRUE(on.isChoice);
  EXPECT_FALSE(keys_.choice("disc"));
}

TEST_F(RemoteKeysTest, otherModesAndKeysWithoutAStreamAreTheRobots) {
  EXPECT_TRUE(keys_.set(keyRequest("disc", KeyMode::N_TIMES)).isForwarded);
  EXPECT_TRUE(keys_.wants("drawings/disc"));
  EXPECT_TRUE(keys_.set(keyRequest("no-stream", KeyMode::ALWAYS)).isForwarded);
  EXPECT_TRUE(keys_.set(keyRequest("unknown", KeyMode::ALWAYS)).isForwarded);
  // They end with the connection, and what is not counted is chosen again.
  keys_.setUnsent();
  EXPECT_EQ(keys_.takeUnsent(), std::vector<std::string>{"no-stream"});
}

TEST_F(RemoteKeysTest, afterANumberOfTimesAKeyIsSwitchedOnForGood) {
  keys_.set(keyRequest("disc", KeyMode::N_TIMES));
  const auto on = keys_.set(keyRequest("disc", KeyMode::ALWAYS));
  EXPECT_TRUE(on.isChoice);
  EXPECT_FALSE(keys_.choice("disc"));
}

TEST_F(RemoteKeysTest, aModeIsChosenForThisClientAloneAndToldAgainAfterACut) {
  SetKey every = keyRequest("disc", KeyMode::EVERY_N);
  every.mutable_mode()->set_n(3);
  const auto outcome = keys_.set(every);
  EXPECT_TRUE(outcome.isChoice);
  EXPECT_FALSE(outcome.isForwarded);
  EXPECT_TRUE(keys_.wants("drawings/disc"));
  EXPECT_EQ(keys_.shown().keys(0).mode().n(), 3U);
  EXPECT_TRUE(keys_.takeUnsent().empty());
  keys_.setUnsent();
  EXPECT_EQ(keys_.takeUnsent(), std::vector<std::string>{"disc"});
  EXPECT_TRUE(keys_.set(keyRequest("disc", KeyMode::OFF)).isChoice);
  EXPECT_FALSE(keys_.choice("disc"));
}

TEST_F(RemoteKeysTest, keysOfChannelsAreNeverForwarded) {
  RemoteKeys keys;
  keys.setChannelKeys(table_);
  EXPECT_FALSE(keys.set(keyRequest("disc", KeyMode::EVERY_N)).isForwarded);
  EXPECT_EQ(keys.shown().keys(0).mode().kind(), KeyMode::ALWAYS);
  EXPECT_FALSE(keys.set(keyRequest("disc", KeyMode::OFF)).isForwarded);
  EXPECT_EQ(keys.shown().keys(0).mode().kind(), KeyMode::OFF);
}

}  // namespace
}  // namespace robotlink::websocket
