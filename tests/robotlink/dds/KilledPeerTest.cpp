// SPDX-License-Identifier: GPL-3.0-or-later
// Links to a program of the operating system that is killed, started again, and built from other sources.
#include <gtest/gtest.h>

#include <csignal>
#include <mutex>

#include "robotlink/dds/ProgramNet.h"
#include "tests/Eventually.h"
#include "tests/app/StartedProgram.h"
#include "tests/robotlink/dds/TestNodes.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

class KilledPeerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(node_);
    ASSERT_TRUE(net_.link(receiver_, "from"));
  }
  std::unique_ptr<StartedProgram> start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{std::to_string(testDomain())};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<StartedProgram>(DDS_PEER, std::filesystem::temp_directory_path(), arguments);
  }
  bool receives() {
    const auto before = receiver_.taken();
    return eventually([&] {
      to_.step();
      return receiver_.taken() > before + 2;
    });
  }

  std::mutex mutex_;  // protects reports_
  std::vector<std::string> reports_;
  SteadyClock clock_;
  std::shared_ptr<dds::Node> node_ = openTestNode();
  dds::ProgramNet net_{node_, {"robot", "planning"}, clock_, {{}, [this](const std::string& text) {
                                                                const std::lock_guard lock(mutex_);
                                                                reports_.push_back(text);
                                                              }}};
  TestProcess to_{"to", clock_};
  Receiver<Ball> receiver_{to_, "ball", Blocking::kNo};
};

TEST_F(KilledPeerTest, aProgramThatIsKilledIsMissedAndRejoinsWhenItIsStartedAgain) {
  auto peer = start();
  ASSERT_TRUE(receives());
  peer->send(SIGKILL);
  peer->waitUnread();
  EXPECT_TRUE(eventually([&] { return !receiver_.connected(); })) << "nobody said goodbye";
  EXPECT_LT(0, numberIn(receiver_)) << "the last package stays";
  const auto generation = receiver_.generation();
  peer = start();
  EXPECT_TRUE(receives());
  EXPECT_EQ(generation + 1, receiver_.generation());
}

TEST_F(KilledPeerTest, aProgramThatIsStartedAgainAtOnceTakesThePlaceOfTheOldOne) {
  for (std::uint64_t i = 1; i <= 3; ++i) {
    const auto peer = start();
    ASSERT_TRUE(eventually([&] { return receiver_.generation() == i; }));
    ASSERT_TRUE(receives());
    peer->send(SIGKILL);
    peer->waitUnread();
  }
}

TEST_F(KilledPeerTest, aProgramOfAnotherVersionIsRefusedUntilTheRightOneIsStarted) {
  auto peer = start({"other-version"});
  ASSERT_TRUE(eventually([&] {
    const std::lock_guard lock(mutex_);
    return !reports_.empty();
  }));
  EXPECT_EQ(
      "Program planning refuses ball of program vision: the two were built from different versions of "
      "this package. Build both from the same sources.",
      reports_.front());
  EXPECT_FALSE(receiver_.connected());
  EXPECT_EQ(0U, receiver_.taken());
  peer->send(SIGKILL);
  peer->waitUnread();
  peer = start();
  EXPECT_TRUE(receives());
}

}  // namespace
}  // namespace robotlink::test
