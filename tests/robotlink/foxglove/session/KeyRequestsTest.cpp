// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyRequests.h"

#include <gmock/gmock.h>

#include "robotlink/foxglove/session/KeyModeText.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::KeyMode;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kDisc = "drawings/image/ball-percept/disc";

class KeyRequestsTest : public testing::Test {
 protected:
  KeyRequestsTest() { setTable("off"); }
  /// As the robot publishes it; one key draws, the other one plots, the third is that of a package.
  void setTable(const std::string& disc) {
    robotcontrol::KeyTable table;
    const auto add = [&](const std::string& name, const std::string& stream, const std::string& mode) {
      auto& key = *table.add_keys();
      key.set_name(name);
      key.set_stream(stream);
      *key.mutable_mode() = *keyModeOf(mode);
    };
    add("ball-percept/disc", kDisc, disc);
    add("motion/speed", "plots/motion/speed", "off");
    add("package/camera/image", "camera/image", "always");
    requests_.setTable("red1", table);
  }
  std::vector<std::string> takeSet() { return std::exchange(set_, {}); }

  std::vector<std::string> set_;
  KeyRequests requests_{[this](const std::string& robot, const std::string& key, const KeyMode& mode) {
    set_.push_back(robot + " " + key + " " + textOf(mode));
    // As a session's listener does.
    requests_.noteChosen(robot, key, mode);
  }};
};

TEST_F(KeyRequestsTest, aKeyIsOnWhileSomebodySubscribesToWhatItPublishes) {
  requests_.setSubscribers("red1", kDisc, {"a"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc always"));
  requests_.setSubscribers("red1", kDisc, {"a", "b"});
  requests_.setSubscribers("red1", kDisc, {"b"});
  setTable("always");
  EXPECT_THAT(takeSet(), IsEmpty());
  requests_.setSubscribers("red1", kDisc, {});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc off"));
}

TEST_F(KeyRequestsTest, aKeyIsOnDemandUntilATableSaysThatItIsOffAgain) {
  const auto onDemand = [&] { return requests_.onDemand("red1").contains("ball-percept/disc"); };
  EXPECT_FALSE(onDemand());
  requests_.setSubscribers("red1", kDisc, {"a"});
  setTable("always");
  EXPECT_TRUE(onDemand());
  requests_.setSubscribers("red1", kDisc, {});
  setTable("always");
  EXPECT_TRUE(onDemand());
  setTable("off");
  EXPECT_FALSE(onDemand());
  setTable("always");
  EXPECT_FALSE(onDemand());
}

TEST_F(KeyRequestsTest, aKeyThatIsOnAlreadyStaysAsItIs) {
  setTable("every 3");
  requests_.setSubscribers("red1", kDisc, {"a"});
  requests_.setSubscribers("red1", "camera/image", {"a"});
  requests_.setSubscribers("red1", kDisc, {});
  requests_.setSubscribers("red1", "camera/image", {});
  EXPECT_THAT(takeSet(), IsEmpty());
}

TEST_F(KeyRequestsTest, whatSomebodyElseSetsMeanwhileHolds) {
  requests_.setSubscribers("red1", kDisc, {"a"});
  takeSet();
  requests_.noteChosen("red1", "ball-percept/disc", *keyModeOf("every 200 ms"));
  setTable("every 200 ms");
  requests_.setSubscribers("red1", kDisc, {});
  EXPECT_THAT(takeSet(), IsEmpty());
}

TEST_F(KeyRequestsTest, aKeyThatSomebodySwitchesOffStaysOffUntilTheNextSubscription) {
  requests_.setSubscribers("red1", kDisc, {"a"});
  takeSet();
  requests_.noteChosen("red1", "ball-percept/disc", KeyMode());
  setTable("off");
  EXPECT_THAT(takeSet(), IsEmpty());
  requests_.setSubscribers("red1", kDisc, {});
  requests_.setSubscribers("red1", kDisc, {"a"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc always"));
}

TEST_F(KeyRequestsTest, aTableThatIsOlderThanTheRequestChangesNothing) {
  requests_.setSubscribers("red1", kDisc, {"a"});
  takeSet();
  setTable("off");
  EXPECT_THAT(takeSet(), IsEmpty());
  requests_.setSubscribers("red1", kDisc, {});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc off"));
}

TEST_F(KeyRequestsTest, aModeThatAClientChoosesEndsWithItAndOthersStay) {
  const std::string disc = "ball-percept/disc";
  const auto choose = [&](const std::string& client, const std::string& mode) {
    const auto asked = requests_.choose("red1", disc, client, *keyModeOf(mode));
    return asked ? textOf(*asked) : "";
  };
  EXPECT_EQ(choose("a", "every 3"), "every 3");
  setTable("every 3");
  EXPECT_EQ(textOf(*requests_.ownMode("red1", disc)), "off");
  EXPECT_THAT(requests_.onDemand("red1").at(disc), ElementsAre("a"));
  EXPECT_EQ(choose("b", "every 2"), "every 2");
  setTable("every 2");
  requests_.setClients({"a", "c"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc every 3"));
  requests_.setSubscribers("red1", kDisc, {"c"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc always"));
  requests_.setClients({"c"});
  EXPECT_THAT(takeSet(), IsEmpty()) << "c still subscribes";
  requests_.setSubscribers("red1", kDisc, {});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc off"));
}

TEST_F(KeyRequestsTest, aModeThatAClientChoosesLeavesOthersWhatTheyWant) {
  const std::string disc = "ball-percept/disc";
  const auto choose = [&](const std::string& client, const std::string& mode) {
    const auto asked = requests_.choose("red1", disc, client, *keyModeOf(mode));
    return asked ? textOf(*asked) : "";
  };
  requests_.setSubscribers("red1", kDisc, {"a", "b"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc always"));
  for (const char* mode : {"every 50", "3 times", "every 200 ms", "off"}) EXPECT_EQ(choose("a", mode), "");
  // Each client that has chosen a mode gets at least that.
  EXPECT_EQ(choose("b", "every 50"), "every 50");
  EXPECT_EQ(choose("a", "every 20"), "every 20");
  EXPECT_EQ(choose("a", "every 70"), "every 50");
  EXPECT_EQ(choose("a", "3 times"), "");
  EXPECT_EQ(choose("a", "every 200 ms"), "always") << "which of them is more is not known";
  requests_.setClients({"a"});
  EXPECT_THAT(takeSet(), IsEmpty()) << "b still subscribes";
}

TEST_F(KeyRequestsTest, whoeverSubscribesGetsAtLeastWhatTheRobotPublishesByItself) {
  setTable("every 5");
  requests_.setSubscribers("red1", kDisc, {"a", "b"});
  EXPECT_FALSE(requests_.choose("red1", "ball-percept/disc", "a", *keyModeOf("every 50")));
  EXPECT_TRUE(requests_.choose("red1", "ball-percept/disc", "a", *keyModeOf("every 2")));
  setTable("every 2");
  requests_.setClients({"b"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc every 5"));
}

TEST_F(KeyRequestsTest, aNumberOfTimesCountsAnewEachTimeItIsChosen) {
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(requests_.choose("red1", "ball-percept/disc", "a", *keyModeOf("3 times")));
}

TEST_F(KeyRequestsTest, whatTheProgramAskedForStaysWhenAClientThatChoseAnotherModeHasGone) {
  setTable("every 3");
  EXPECT_TRUE(requests_.choose("red1", "ball-percept/disc", "a", KeyMode()));
  setTable("off");
  requests_.setClients({});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc every 3"));
}

TEST_F(KeyRequestsTest, whoSwitchesAKeyOffKeepsItFromNobodyElse) {
  requests_.setSubscribers("red1", kDisc, {"a", "b"});
  takeSet();
  EXPECT_FALSE(requests_.choose("red1", "ball-percept/disc", "a", KeyMode())) << "b subscribes";
  requests_.setSubscribers("red1", kDisc, {"a"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 ball-percept/disc off"));
}

TEST_F(KeyRequestsTest, whatSomebodyElseSetsHoldsAlsoAgainstChoices) {
  EXPECT_TRUE(requests_.choose("red1", "ball-percept/disc", "a", *keyModeOf("every 3")));
  requests_.noteChosen("red1", "ball-percept/disc", *keyModeOf("always"));
  requests_.setClients({});
  EXPECT_THAT(takeSet(), IsEmpty());
}

TEST_F(KeyRequestsTest, aCurveIsThatOfItsKeyButALongerNameIsNot) {
  requests_.setSubscribers("red1", "plots/motion/speedometer", {"a"});
  EXPECT_THAT(takeSet(), IsEmpty());
  requests_.setSubscribers("red1", "plots/motion/speed/x", {"a"});
  requests_.setSubscribers("red1", "plots/motion/speed/y", {"b"});
  EXPECT_THAT(takeSet(), ElementsAre("red1 motion/speed always"));
  EXPECT_THAT(requests_.clientsByKey("red1").at("motion/speed"), ElementsAre("a", "b"));
  requests_.setSubscribers("red1", "plots/motion/speed/x", {});
  EXPECT_THAT(takeSet(), IsEmpty());
}

TEST_F(KeyRequestsTest, aSubscriptionThatCameBeforeTheTableOfKeysCountsThen) {
  requests_.setSubscribers("red2", kDisc, {"a"});
  EXPECT_THAT(takeSet(), IsEmpty());
  robotcontrol::KeyTable table;
  table.add_keys()->set_name("ball-percept/disc");
  table.mutable_keys(0)->set_stream(kDisc);
  requests_.setTable("red2", table);
  EXPECT_THAT(takeSet(), ElementsAre("red2 ball-percept/disc always"));
}

TEST(KeyModeText, allModesAreReadAsTheyAreWritten) {
  for (const char* text : {"off", "always", "5 times", "every 3", "every 200 ms"}) {
    const auto mode = keyModeOf(text);
    ASSERT_TRUE(mode) << text;
    EXPECT_EQ(textOf(*mode), text);
  }
  for (const char* text : {"", "on", "0 times", "every -1", "every 3ms", "every 99999999999"}) {
    EXPECT_FALSE(keyModeOf(text)) << text;
  }
}

}  // namespace
}  // namespace robotlink::websocket
