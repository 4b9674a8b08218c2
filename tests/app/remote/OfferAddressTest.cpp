// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OfferAddress.h"

#include <gmock/gmock.h>

namespace app {
namespace {

using testing::ElementsAre;

const std::vector<std::string> kLocal{"127.0.0.1", "10.0.0.5", "192.168.1.7"};

TEST(OfferAddress, withoutOneItIsTheDefaultPortOfThisMachineOnly) {
  const auto address = parseOfferAddress("");
  ASSERT_TRUE(address);
  EXPECT_EQ(toString(*address), "127.0.0.1:8765");
}

TEST(OfferAddress, othersConnectToTheAddressItself) {
  EXPECT_THAT(offerUrls("wss", {"192.168.1.7", 8765}, kLocal), ElementsAre("wss://192.168.1.7:8765"));
  EXPECT_THAT(offerUrls("ws", {"::1", 1}, kLocal), ElementsAre("ws://[::1]:1"));
}

TEST(OfferAddress, whatStandsForAllNetworksIsShownAsTheirAddresses) {
  for (const char* all : {"0.0.0.0", "::"})
    EXPECT_THAT(offerUrls("wss", {all, 8765}, kLocal),
                ElementsAre("wss://10.0.0.5:8765", "wss://192.168.1.7:8765"));
  EXPECT_THAT(offerUrls("wss", {"0.0.0.0", 8765}, {"127.0.0.1"}), ElementsAre("wss://127.0.0.1:8765"));
}

}  // namespace
}  // namespace app
