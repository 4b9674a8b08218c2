// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/JsonOutput.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using nlohmann::json;

TEST(JsonOutput, isIndentedAndEndsItsLine) {
  EXPECT_EQ(jsonOutput(json{{"a", 1}}), "{\n  \"a\": 1\n}\n");
  EXPECT_EQ(jsonMessage(json{{"a", 1}}), "{\"a\":1}");
}

TEST(JsonOutput, aTerminalObeysNothingInIt) {
  // Escape is escaped by all who write JSON; DEL and the second set of control characters are not.
  const std::string text =
      "a\x1b\x7f\xc2\x9b"
      "2J\xc2\xa0\u00e9";
  const std::string output = jsonOutput(json(text));
  EXPECT_EQ(output, "\"a\\u001b\\u007f\\u009b2J\xc2\xa0\u00e9\"\n");
  EXPECT_EQ(json::parse(output).get<std::string>(), text) << "whoever reads it gets the same";
}

TEST(JsonOutput, bytesThatAreNoTextAreReplaced) {
  const json value{{"name", "old\xe9.log"}, {"cut", "\xc2"}};
  const json read = json::parse(jsonOutput(value));
  EXPECT_EQ(read.at("name"), "old\ufffd.log");
  EXPECT_EQ(read.at("cut"), "\ufffd");
  EXPECT_NE(jsonMessage(value).find("\ufffd"), std::string::npos);
}

TEST(JsonOutput, aTextThatIsCutInTheMiddleOfALetterStaysAsItIs) {
  EXPECT_EQ(withControlsEscaped("\xc2"), "\xc2");
  EXPECT_EQ(withControlsEscaped(""), "");
}

}  // namespace
}  // namespace app
