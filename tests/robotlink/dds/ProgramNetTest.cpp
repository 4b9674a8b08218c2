// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/ProgramNet.h"

#include <gtest/gtest.h>

#include <mutex>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/dds/Fingerprint.h"
#include "robotlink/dds/LocalAddresses.h"
#include "robotlink/dds/ReceivingEnd.h"
#include "robotlink/dds/SendingEnd.h"
#include "robotlink/packages/Packages.h"
#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

/// What programs report, from any thread.
class Reports {
 public:
  std::function<void(const std::string&)> sink() {
    return [this](const std::string& text) {
      const std::lock_guard lock(mutex_);
      texts_.push_back(text);
    };
  }
  std::vector<std::string> texts() const {
    const std::lock_guard lock(mutex_);
    return texts_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
};

TEST(ProgramNetTest, anotherVersionOfAPackageIsRefusedWithTheNamesOfBothSides) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  SteadyClock clock;
  Reports sending, receiving;
  dds::ProgramNet old(here, {"robot", "vision"}, clock,
                      {[](const auto& type) { return dds::fingerprintOf(type) + 1; }, sending.sink()});
  dds::ProgramNet young(there, {"robot", "planning"}, clock, {{}, receiving.sink()});
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> sender(from, "ball", Blocking::kYes);
  Receiver<Ball> receiver(to, "ball", Blocking::kYes);
  ASSERT_TRUE(old.link(sender, "from") && young.link(receiver, "from"));
  ASSERT_TRUE(eventually([&] { return sender.connected(); }));
  sender.send(ball(1));
  ASSERT_TRUE(eventually([&] { return !sending.texts().empty() && !receiving.texts().empty(); }));
  EXPECT_EQ(
      "Program planning refuses ball of program vision: the two were built from different versions of "
      "this package. Build both from the same sources.",
      receiving.texts().front());
  EXPECT_EQ(receiving.texts(), sending.texts());
  EXPECT_FALSE(sender.connected());
  EXPECT_FALSE(receiver.connected());
  EXPECT_TRUE(from.tryBeginFrame()) << "a receiver that refuses holds nothing back";
  EXPECT_FALSE(to.tryBeginFrame());
  sender.send(ball(2));
  EXPECT_EQ(1U, receiving.texts().size());
}

TEST(ProgramNetTest, aPackageOfAnotherTypeThanItsNameSaysIsRefused) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  SteadyClock clock;
  Reports reports;
  dds::ProgramNet sending(here, {"robot", "vision"}, clock, {});
  dds::ProgramNet receiving(there, {"robot", "planning"}, clock, {{}, reports.sink()});
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> sender(from, "models/ball", Blocking::kNo);
  AnyReceiver receiver(to, "models/ball", Blocking::kNo);
  ASSERT_TRUE(sending.link(sender, "from") && receiving.link(receiver, "from"));
  ASSERT_TRUE(eventually([&] { return sender.connected(); }));
  sender.send(ball(1));
  EXPECT_TRUE(eventually([&] { return !reports.texts().empty(); }));
  to.step();
  EXPECT_EQ(nullptr, receiver.value());
}

TEST(ProgramNetTest, aReceiverFollowsASenderThatIsMadeAgain) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  SteadyClock clock;
  dds::ProgramNet sending(here, {"robot", "vision"}, clock, {});
  dds::ProgramNet receiving(there, {"robot", "planning"}, clock, {});
  TestProcess to("to", clock);
  Receiver<Ball> receiver(to, "ball", Blocking::kNo);
  ASSERT_TRUE(receiving.link(receiver, "from"));
  EXPECT_EQ(0U, receiver.generation());
  for (int i = 1; i <= 3; ++i) {
    TestProcess from("from", clock);
    Sender<Ball> sender(from, "ball", Blocking::kYes);
    ASSERT_TRUE(sending.link(sender, "from"));
    ASSERT_TRUE(eventually([&] { return sender.connected() && receiver.connected(); }));
    sender.send(ball(i));
    ASSERT_TRUE(eventually([&] {
      to.step();
      return numberIn(receiver) == i;
    }));
    EXPECT_EQ(static_cast<std::uint64_t>(i), receiver.generation());
    EXPECT_EQ(0U, receiver.missed());
  }
  EXPECT_TRUE(eventually([&] { return !receiver.connected(); }));
}

TEST(ProgramNetTest, whatIsSentWhileNobodyReceivesIsNotKept) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  SteadyClock clock;
  dds::ProgramNet sending(here, {"robot", "vision"}, clock, {});
  dds::ProgramNet receiving(there, {"robot", "planning"}, clock, {});
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> sender(from, "ball", Blocking::kYes);
  ASSERT_TRUE(sending.link(sender, "from"));
  sender.send(ball(1));
  EXPECT_EQ(0U, sending.sendingEnd(sender)->written());
  EXPECT_TRUE(from.tryBeginFrame());
  Receiver<Ball> receiver(to, "ball", Blocking::kNo);
  ASSERT_TRUE(receiving.link(receiver, "from"));
  ASSERT_TRUE(eventually([&] { return sender.connected(); }));
  EXPECT_EQ(0U, receiving.receivingEnd(receiver)->arrived());
}

/// Sends a package once; receivers that come afterwards, one after the other, get it, too.
template <typename T>
void expectToReachWhoComesLater(const Package<T>& package, const std::shared_ptr<const T>& sent) {
  SCOPED_TRACE(package.name);
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  SteadyClock clock;
  dds::ProgramNet sending(here, {"robot", "body"}, clock, {});
  dds::ProgramNet receiving(there, {"robot", "head"}, clock, {});
  TestProcess debug("debug", clock);
  Sender<T> sender(debug, package.name, Blocking::kNo);
  ASSERT_TRUE(sending.link(sender, "debug"));
  sender.send(sent);
  for (int i = 0; i < 2; ++i) {
    TestProcess process("process", clock);
    Receiver<T> receiver(process, package.name, Blocking::kNo);
    ASSERT_TRUE(receiving.link(receiver, "debug"));
    EXPECT_TRUE(eventually([&] {
      process.step();
      return receiver.get() != nullptr && receiver.get()->SerializeAsString() == sent->SerializeAsString();
    }));
  }
}

TEST(ProgramNetTest, whatTheUserChoseIsAlsoForWhoComesLater) {
  auto table = std::make_shared<robotcontrol::ColorTable>();
  table->set_source("hall.c64");
  expectToReachWhoComesLater<robotcontrol::ColorTable>(kColorTable, table);
  auto goal = std::make_shared<robotcontrol::DriveGoal>();
  goal->mutable_pose_in_field()->set_x(3);
  expectToReachWhoComesLater<robotcontrol::DriveGoal>(kDriveGoal, goal);
}

TEST(ProgramNetTest, robotsOnOneNetworkDoNotMeet) {
  const auto here = openTestNode();
  ASSERT_TRUE(here);
  SteadyClock clock;
  dds::ProgramNet one(here, {"one", "vision"}, clock, {});
  dds::ProgramNet two(here, {"two", "planning"}, clock, {});
  dds::ProgramNet alsoTwo(here, {"two", "vision"}, clock, {});
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> sender(from, "ball", Blocking::kNo);
  Sender<Ball> right(from, "ball", Blocking::kNo);
  Receiver<Ball> receiver(to, "ball", Blocking::kNo);
  ASSERT_TRUE(one.link(sender, "from") && two.link(receiver, "from") && alsoTwo.link(right, "from"));
  ASSERT_TRUE(eventually([&] { return right.connected() && receiver.connected(); }));
  EXPECT_FALSE(sender.connected());
}

TEST(ProgramNetTest, aDomainOrAnInterfaceThatDoesNotExistIsRefused) {
  const auto domain = dds::Node::open({.domain = 231, .address = {}, .peers = {}, .multicast = false});
  ASSERT_FALSE(domain);
  EXPECT_EQ("a DDS domain is a number from 0 to 230, not 231", domain.error().text);
  ::testing::internal::CaptureStderr();
  const auto interface =
      dds::Node::open({.domain = 1, .address = "203.0.113.254", .peers = {}, .multicast = false});
  EXPECT_EQ("", ::testing::internal::GetCapturedStderr()) << "DDS writes nothing itself";
  ASSERT_FALSE(interface);
  EXPECT_EQ("DDS cannot be used on the address 203.0.113.254: no network interface of this machine has it",
            interface.error().text);
}

TEST(ProgramNetTest, anInterfaceThatIsDownIsNamed) {
  const std::vector<dds::LocalInterface> interfaces{{"eth0", "192.0.2.2", true},
                                                    {"wlan0", "192.0.2.3", false}};
  EXPECT_EQ("", dds::whyNotUsable("192.0.2.2", interfaces));
  EXPECT_EQ("its network interface wlan0 is down", dds::whyNotUsable("192.0.2.3", interfaces));
  EXPECT_EQ("no network interface of this machine has it", dds::whyNotUsable("192.0.2.4", interfaces));
}

}  // namespace
}  // namespace robotlink::test
