// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/ParsedNumber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace robotlink {
namespace {

TEST(ParsedNumber, isAllOfTheText) {
  EXPECT_EQ(parsedNumber<int>("-12"), -12);
  EXPECT_EQ(parsedNumber<double>("1.5e3"), 1500);
  for (const char* text : {"", " 1", "1 ", "1x", "x", "1.5", "0x10", "+1", "-"}) {
    EXPECT_EQ(parsedNumber<int>(text), std::nullopt) << text;
  }
}

TEST(ParsedNumber, isInTheRangeOfItsType) {
  EXPECT_EQ(parsedNumber<std::uint8_t>("255"), 255);
  EXPECT_EQ(parsedNumber<std::uint8_t>("256"), std::nullopt);
  EXPECT_EQ(parsedNumber<unsigned>("-1"), std::nullopt);
  EXPECT_EQ(parsedNumber<double>("1e999"), std::nullopt);
  EXPECT_TRUE(std::isinf(*parsedNumber<double>("inf"))) << "whether that makes sense is up to the caller";
}

TEST(ParsedNumber, mayHaveAPlusInFilesOfPeople) {
  EXPECT_EQ(parsedNumberWithSign<int>("+3"), 3);
  EXPECT_EQ(parsedNumberWithSign<int>("-3"), -3);
  EXPECT_EQ(parsedNumberWithSign<int>("++3"), std::nullopt);
  EXPECT_EQ(parsedNumberWithSign<int>("+"), std::nullopt);
}

}  // namespace
}  // namespace robotlink
