// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/network/HostLookup.h"

#include <gmock/gmock.h>

#include <atomic>
#include <stdexcept>

namespace robotlink {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(HostLookup, addressesAndThisMachineAreKnownAtOnce) {
  const auto never = [](const std::string&) -> HostLookup::Outcome { throw std::logic_error("asked"); };
  for (const auto& [host, address] :
       {std::pair{"192.168.1.7", "192.168.1.7"}, {"::1", "::1"}, {"localhost", "127.0.0.1"}}) {
    const auto outcome = HostLookup::start(host, never)->outcome();
    ASSERT_TRUE(outcome && *outcome) << host;
    EXPECT_THAT(**outcome, ElementsAre(address));
  }
}

TEST(HostLookup, aNameThatIsLookedUpForLongKeepsNobodyWaiting) {
  const auto mayFinish = std::make_shared<std::atomic<bool>>(false);
  const auto lookup = HostLookup::start("red1", [mayFinish](const std::string& host) -> HostLookup::Outcome {
    mayFinish->wait(false);
    return std::vector{host + "'s address"};
  });
  EXPECT_FALSE(lookup->outcome().has_value());
  EXPECT_FALSE(lookup->wait(1ms).has_value());
  *mayFinish = true;
  mayFinish->notify_all();
  const auto outcome = lookup->wait(30s);
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_THAT(**outcome, ElementsAre("red1's address"));
}

TEST(HostLookup, whyANameIsNotFoundIsSaid) {
  const auto outcome = HostLookup::start("no-such-robot.invalid")->wait(30s);
  ASSERT_TRUE(outcome && !*outcome);
  EXPECT_THAT(outcome->error().text, HasSubstr("there is no machine named 'no-such-robot.invalid'"));
  const auto thrown = HostLookup::start("red1", [](const auto&) -> HostLookup::Outcome {
                        throw std::bad_alloc();
                      })->wait(30s);
  ASSERT_TRUE(thrown && !*thrown);
  EXPECT_THAT(thrown->error().text, HasSubstr("'red1' cannot be looked up"));
}

}  // namespace
}  // namespace robotlink
