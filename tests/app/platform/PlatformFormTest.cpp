// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformForm.h"

#include <gtest/gtest.h>

#include <limits>

using namespace app;
using Kind = PlatformField::Kind;

namespace {

const PlatformField kCount{.name = "count", .kind = Kind::kNumber, .initial = 1.0, .noun = "count", .max = 5};
const PlatformField kPort{.name = "port",
                          .kind = Kind::kNumber,
                          .initial = 8101.0,
                          .noun = "port",
                          .min = 1,
                          .max = 65535,
                          .toggle = "Open a port"};
const PlatformField kColor{
    .name = "color", .kind = Kind::kChoice, .noun = "color", .items = [] {
      return PlatformField::Items{{"Red", "red"}, {"Blue", "blue"}, {"Green", "green"}};
    }};

}  // namespace

TEST(PlatformForm, aWholeNumberHasNoFractionAndStaysInItsRange) {
  EXPECT_EQ(problemOf(kCount, 0.0), "");
  EXPECT_EQ(problemOf(kCount, 5.0), "");
  for (const double wrong : {1.5, -1.0, 6.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(problemOf(kCount, wrong), "the count must be a whole number between 0 and 5") << wrong;
}

TEST(PlatformForm, aNumberWithPlacesMayHaveAFraction) {
  PlatformField field = kCount;
  field.decimals = 1;
  field.unit = "m";
  EXPECT_EQ(problemOf(field, 1.5), "");
  EXPECT_EQ(problemOf(field, 5.5), "the count must be a number between 0 and 5 m");
}

TEST(PlatformForm, aNumberWithoutARangeIsOnlyFinite) {
  PlatformField field = kCount;
  field.max = 0;
  field.decimals = 3;
  EXPECT_EQ(rangeOf(field), "");
  EXPECT_EQ(problemOf(field, -1e12), "");
  EXPECT_EQ(problemOf(field, std::nan("")), "the count must be a number");
}

TEST(PlatformForm, aRangeReadsAsPeopleWriteNumbers) {
  EXPECT_EQ(rangeOf(kCount), "0 to 5");
  PlatformField field = kCount;
  field.min = 0.5;
  field.max = 9e15;
  EXPECT_EQ(rangeOf(field), "0.5 to 9000000000000000");
}

TEST(PlatformForm, aFieldWithATickBoxMayBeZero) {
  EXPECT_EQ(problemOf(kPort, 0.0), "");
  EXPECT_EQ(problemOf(kPort, 70000.0), "the port must be a whole number between 1 and 65535, or 0 for none");
}

TEST(PlatformForm, aChoiceIsOneOfItsItemsUnlessItCanBeEdited) {
  EXPECT_EQ(problemOf(kColor, std::string("blue")), "");
  EXPECT_EQ(problemOf(kColor, std::string()), "") << "nothing was chosen";
  EXPECT_EQ(problemOf(kColor, std::string("pink")), "the color must be red, blue or green, not 'pink'");
  PlatformField editable = kColor;
  editable.editable = true;
  EXPECT_EQ(problemOf(editable, std::string("pink")), "");
}

TEST(PlatformForm, aValueHasTheTypeOfItsField) {
  EXPECT_EQ(problemOf(kCount, true), "the count has a value of another type");
  EXPECT_EQ(problemOf(kColor, 1.0), "the color has a value of another type");
}

TEST(PlatformForm, theFirstWrongValueIsReported) {
  const PlatformForm form{.fields = {kCount, kPort, kColor}};
  EXPECT_EQ(problemOf(form, {}), "") << "what was left open is not wrong";
  EXPECT_EQ(problemOf(form, {{"color", std::string("pink")}, {"count", 9.0}}),
            "the count must be a whole number between 0 and 5");
}

TEST(PlatformForm, aFieldWithATickBoxDoesNotCountAtFirst) {
  const PlatformForm form{.fields = {kCount, kPort, kColor}};
  EXPECT_EQ(initialValues(form), (FormValues{{"count", 1.0}, {"port", 0.0}, {"color", std::string()}}));
}

TEST(PlatformForm, valuesOfAnotherTypeAreTheFallback) {
  const FormValues values{{"on", true}, {"text", std::string("a")}, {"number", 2.0}};
  EXPECT_TRUE(flagOf(values, "on"));
  EXPECT_TRUE(flagOf(values, "text", true));
  EXPECT_EQ(numberOf(values, "number"), 2);
  EXPECT_EQ(numberOf(values, "on", 7), 7);
  EXPECT_EQ(textOf(values, "text"), "a");
  EXPECT_EQ(textOf(values, "missing", "none"), "none");
}

TEST(PlatformForm, argumentsAreTheFieldsThatScriptsGive) {
  PlatformField hidden = kPort;
  hidden.isArgument = false;
  const PlatformForm form{.fields = {kCount, hidden, kColor}};
  ASSERT_EQ(form.arguments().size(), 2U);
  EXPECT_EQ(form.arguments()[1]->name, "color");
  EXPECT_EQ(form.field("port")->min, 1);
  EXPECT_EQ(form.field("nothing"), nullptr);
}
