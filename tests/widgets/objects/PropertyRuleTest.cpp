// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertyRule.h"

#include <gmock/gmock.h>

namespace widgets {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const char* typed, const char* name, int count = 1) {
  const auto numbers =
      propertyNumbers(QString::fromUtf8(typed), name, count, QString::fromUtf8(name), QStringLiteral("kg"));
  return numbers ? std::string() : numbers.error().text;
}

TEST(PropertyRule, numbersAreReadWithBlanksBetweenThem) {
  const auto size = propertyNumbers(QStringLiteral(" 1  2.5 1e-1 "), "size", 3, {}, {});
  ASSERT_TRUE(size.has_value());
  EXPECT_THAT(*size, ElementsAre(1, 2.5, 0.1));
  EXPECT_THAT(refusal("1 2", "size", 3), HasSubstr("3 numbers"));
  EXPECT_THAT(refusal("", "mass"), HasSubstr("mass takes 1 number;"));
  EXPECT_THAT(refusal("1,5", "mass"), HasSubstr("1,5 is not a number"));
  EXPECT_THAT(refusal("nan", "mass"), HasSubstr("not a number"));
}

TEST(PropertyRule, whatNothingCanHaveIsRefusedWithItsRange) {
  EXPECT_EQ(refusal("0.1", "mass"), "");
  EXPECT_EQ(refusal("0", "mass"), "mass must be above 0 and at most 100000 kg");
  EXPECT_THAT(refusal("-1", "friction"), HasSubstr("from 0 to 1000"));
  EXPECT_EQ(refusal("0", "friction"), "");
  EXPECT_THAT(refusal("1.5", "dropout"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(refusal("1 4", "opening_angles", 2), HasSubstr("from 0.01 to 3"));
  EXPECT_THAT(refusal("-1 4", "range", 2), HasSubstr("from 0 to 1000"));
  EXPECT_EQ(refusal("-12", "anything else"), "");
  EXPECT_NE(refusal("1e9", "anything else"), "");
}

TEST(PropertyRule, momentsOfInertiaAreThoseOfABody) {
  for (const char* possible : {"1 1 1 0 0 0", "0.1 0.1 0.2 0 0 0", "2 2 2 0.5 -0.5 0.1"})
    EXPECT_EQ(refusal(possible, "inertia", 6), "") << possible;
  for (const char* impossible : {"0 1 1 0 0 0", "-1 1 1 0 0 0", "1 1 3 0 0 0", "1 1 1 2 0 0"})
    EXPECT_THAT(refusal(impossible, "inertia", 6), HasSubstr("These moments of inertia are impossible"))
        << impossible;
  EXPECT_THAT(refusal("1 1 1", "inertia", 6), HasSubstr("6 numbers"));
}

}  // namespace
}  // namespace widgets
