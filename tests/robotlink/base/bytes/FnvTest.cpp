// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/bytes/Fnv.h"

#include <gtest/gtest.h>

namespace robotlink {
namespace {

TEST(Fnv1a, hasTheHashesOfItsAuthors) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(Fnv1a, takesBytesBeyondAsciiAsPositive) {
  EXPECT_NE(fnv1a("\xff"), fnv1a(""));
  EXPECT_EQ(fnv1a("\xff"), (0xcbf29ce484222325U ^ 0xffU) * 0x100000001b3U);
}

}  // namespace
}  // namespace robotlink
