// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/Expression.h"

#include <gmock/gmock.h>

namespace robotlink {
namespace {

using testing::HasSubstr;

using Values = std::vector<std::optional<FieldValue>>;

FieldValue numeric(double number) {
  return {number, std::nullopt};
}
FieldValue textual(const std::string& text) {
  return {std::nullopt, text};
}

std::optional<double> result(const std::string& text, const Values& values = {}) {
  auto expression = Expression::parse(text);
  EXPECT_TRUE(expression) << text << ": " << expression.error().describe();
  if (!expression) return std::nullopt;
  EXPECT_EQ(expression->inputs().size(), values.size()) << text;
  return expression->value(values);
}

Error refusal(const std::string& text) {
  const auto expression = Expression::parse(text);
  EXPECT_FALSE(expression) << text;
  return expression ? Error{} : expression.error();
}

std::vector<std::string> inputs(const std::string& text, const std::vector<std::string>& streams = {}) {
  const auto expression = Expression::parse(text, streams);
  EXPECT_TRUE(expression) << text << ": " << expression.error().describe();
  std::vector<std::string> all;
  for (const ExpressionInput& input : expression->inputs())
    all.push_back(input.stream + "|" + input.path.text());
  return all;
}

TEST(Expression, computesAsInC) {
  EXPECT_EQ(result("1 + 2 * 3"), 7);
  EXPECT_EQ(result("2 ^ 3"), 8);
  EXPECT_EQ(result("!(1 > 2) && 3 <= 3"), 1);
  EXPECT_EQ(result("1 == 2 || 1 != 2"), 1);
  EXPECT_EQ(result("1 < 2 ? 10 : 20"), 10);
  EXPECT_EQ(result("-1.5e1"), -15);
  EXPECT_EQ(result("max(1, 2, mod(7, 4))"), 3);
  EXPECT_NEAR(*result("cos(pi)"), -1, 1e-12);
  EXPECT_EQ(result("true + false"), 1);
}

TEST(Expression, valuesAreFoundInIt) {
  EXPECT_THAT(
      inputs("models/ball.position.x > 1 && red1/joints/states.joints[name=\"a b\"].position<2"),
      testing::ElementsAre("models/ball|position.x", "red1/joints/states|joints[name=\"a b\"].position"));
  EXPECT_THAT(inputs("simulation.time-3 + simulation.time"), testing::ElementsAre("simulation|time"));
  EXPECT_THAT(inputs("a/b.x / c.y"), testing::ElementsAre("a/b|x", "c|y"));
  EXPECT_THAT(inputs("drawings/image/ball-percept/disc.circles"),
              testing::ElementsAre("drawings/image/ball-percept/disc|circles"));
}

TEST(Expression, knownStreamsMayHaveOtherCharacters) {
  EXPECT_THAT(inputs("/odom.pose.x - 1 > /odom.pose.x", {"/odom"}), testing::ElementsAre("/odom|pose.x"));
  EXPECT_THAT(inputs("/a.b c/d.x", {"/a", "/a.b c/d"}), testing::ElementsAre("/a.b c/d|x"));
}

TEST(Expression, namesOfStreamsMayBeginWithASlash) {
  EXPECT_THAT(inputs("/odom.pose.x - 1 > 2 * /tf/a.y"), testing::ElementsAre("/odom|pose.x", "/tf/a|y"));
  EXPECT_THAT(inputs("a.x /b.y"), testing::ElementsAre("a|x", "b|y")) << "behind a value it divides";
  EXPECT_FALSE(Expression::parse("/ a.x"));
}

TEST(Expression, usesTheValuesInTheirOrder) {
  EXPECT_EQ(result("b.x - a.y", {numeric(5), numeric(3)}), 2);
  EXPECT_EQ(result("a.x + a.x", {numeric(5)}), 10);
}

TEST(Expression, comparesTexts) {
  EXPECT_EQ(result("a.state == \"RUNNING\"", {textual("RUNNING")}), 1);
  EXPECT_EQ(result("a.state != \"RUNNING\" && b.x", {textual("RUNNING"), numeric(1)}), 0);
  EXPECT_EQ(result("a.state =~ \"^R.*G$\"", {textual("RUNNING")}), 1);
  EXPECT_EQ(result("a.state=~\"(?i)run\"", {textual("RUNNING")}), 1);
  EXPECT_EQ(result("a.text == \"say \\\"a\\\"\"", {textual("say \"a\"")}), 1);
  EXPECT_EQ(result("a.state == \"ON\" || a.state > 2", {FieldValue{3, "OFF"}}), 1);
}

TEST(Expression, hasNoValueWhereOneOfItsValuesIsUnknownOrATextInsteadOfANumber) {
  EXPECT_EQ(result("a.x > 1 || true", {std::nullopt}), std::nullopt);
  EXPECT_EQ(result("!(a.x > 1)", {std::nullopt}), std::nullopt);
  EXPECT_EQ(result("a.x > 1", {textual("2")}), std::nullopt);
  EXPECT_EQ(result("a.x == \"2\"", {numeric(2)}), std::nullopt);
  EXPECT_EQ(result("sqrt(a.x)", {numeric(-1)}), std::nullopt);
}

TEST(Expression, saysWhatIsWrongAndWhere) {
  EXPECT_EQ(refusal("").where.column, 1);
  EXPECT_EQ(refusal("1 +").where.column, 4);
  EXPECT_EQ(refusal("(a.x > 1").where.column, 9);
  EXPECT_THAT(refusal("a.x = 1").text, HasSubstr("write =="));
  EXPECT_EQ(refusal("a.x = 1").where.column, 5);
  EXPECT_THAT(refusal("ball > 1").text, HasSubstr("STREAM.FIELD"));
  EXPECT_THAT(refusal("1, 2").text, HasSubstr("commas"));
  EXPECT_THAT(refusal("a.state == RUNNING").text, HasSubstr("in quotation marks: \"RUNNING\""));
  EXPECT_EQ(refusal("a.state == RUNNING").where.column, 12);
  EXPECT_EQ(refusal("\"a\" == b.x").where.column, 1);
  EXPECT_EQ(refusal("b.x == \"a").where.column, 8);
  EXPECT_THAT(refusal("b.x =~ \"(\"").text, HasSubstr("not a valid regular expression"));
  EXPECT_EQ(refusal("b.x =~ 1").where.column, 5);
  EXPECT_EQ(refusal("1 + b.x[").where.column, 8);
  EXPECT_EQ(refusal("models/ball.position.x 2").where.column, 24);
  EXPECT_EQ(refusal("1 $ 2").where.column, 3);
  EXPECT_EQ(refusal("3x").where.column, 1);
  EXPECT_EQ(refusal("foo(1)").where.column, 1);
  EXPECT_THAT(refusal(std::string(Expression::kMaxLength + 1, '1')).text, HasSubstr("longer"));
}

TEST(Expression, streamsAreRenamedWhereverTheyStand) {
  const auto expression = Expression::parse("sqrt(a/b.x^2 + c.y) > a/b.x || c.y =~ \"a/b.x\"");
  ASSERT_TRUE(expression);
  EXPECT_EQ(expression->withStreams([](const std::string& stream) { return "red1/" + stream; }),
            "sqrt(red1/a/b.x^2 + red1/c.y) > red1/a/b.x || red1/c.y =~ \"a/b.x\"");
}

TEST(Expression, aSingleValueMayBeAText) {
  auto one = Expression::parse("hosting.state");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->valueOrText(Values{textual("RUNNING")})->text, "RUNNING");
  EXPECT_EQ(one->valueOrText(Values{std::nullopt}), std::nullopt);
  auto more = Expression::parse("hosting.state + 1");
  ASSERT_TRUE(more);
  EXPECT_EQ(more->valueOrText(Values{textual("RUNNING")}), std::nullopt);
  EXPECT_EQ(more->valueOrText(Values{numeric(2)})->number, 3);
}

TEST(FieldValue, textsAreToldApartByNumbers) {
  EXPECT_EQ(textual("").asNumber(), 2166136261.0);
  EXPECT_EQ(textual("a").asNumber(), 3826002220.0) << "as published for FNV-1a";
  EXPECT_NE(textual("walk").asNumber(), textual("stand").asNumber());
  EXPECT_EQ(numeric(3).asNumber(), 3);
  EXPECT_EQ(FieldValue().asNumber(), std::nullopt);
}

}  // namespace
}  // namespace robotlink
