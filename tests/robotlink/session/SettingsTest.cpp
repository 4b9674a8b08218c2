// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Settings.h"

#include <gmock/gmock.h>

#include <limits>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

using namespace robotlink;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

class SettingsTest : public testing::Test {
 protected:
  void write(const std::string& text) { ASSERT_TRUE(writeFileAtomically(file_, text).has_value()); }
  Settings loaded() {
    Settings settings(file_);
    const auto result = settings.load();
    error_ = result ? Error{} : result.error();
    return settings;
  }

  const TestFolder folder_;
  const fs::path file_ = folder_ / "deep" / "settings.json";
  Error error_;
};

}  // namespace

TEST_F(SettingsTest, whatIsSavedIsReadBack) {
  Settings settings(file_);
  settings.set("views/image-1/zoom", 2.5);
  settings.set("views/image-1/drawings", std::vector<std::string>{"ball-percept/circle", "lines"});
  settings.set("views/image-1/grid", true);
  settings.set("perspective", "Play \"two\"\n\xc3\xa9");
  settings.set("count", 3);
  ASSERT_TRUE(settings.save().has_value());
  const Settings again = loaded();
  EXPECT_EQ(again.all(), settings.all());
  EXPECT_EQ(again.number("views/image-1/zoom", 0), 2.5);
  EXPECT_EQ(again.text("perspective", ""), "Play \"two\"\n\xc3\xa9");
}

TEST_F(SettingsTest, whatIsAbsentOrOfAnotherTypeHasItsDefault) {
  Settings settings(file_);
  EXPECT_EQ(settings.number("x", 7), 7);
  settings.set("x", "text");
  EXPECT_EQ(settings.number("x", 7), 7);
  settings.set("y", std::numeric_limits<double>::infinity());
  EXPECT_FALSE(settings.all().contains("y"));
}

TEST_F(SettingsTest, aNameIsRemovedWithAllBelowIt) {
  Settings settings(file_);
  for (const char* name : {"views/image-1", "views/image-1/zoom", "views/image-10/zoom"})
    settings.set(name, 1);
  settings.remove("views/image-1");
  ASSERT_EQ(settings.all().size(), 1U);
  EXPECT_EQ(settings.all().begin()->first, "views/image-10/zoom");
}

TEST_F(SettingsTest, noFileIsNoError) {
  EXPECT_TRUE(loaded().all().empty());
  EXPECT_EQ(error_, Error{});
}

TEST_F(SettingsTest, nothingIsWrittenIfNothingHasChanged) {
  Settings settings(file_);
  ASSERT_TRUE(settings.save().has_value());
  EXPECT_FALSE(fs::exists(file_));
  settings.set("a", 1);
  ASSERT_TRUE(settings.save().has_value());
  fs::remove(file_);
  settings.set("a", 1);
  ASSERT_TRUE(settings.save().has_value());
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(SettingsTest, aBrokenFileIsKeptAsideAndDefaultsAreUsed) {
  write("{\n  \"format\": \"robotcontrol-settings\",\n  oops\n}");
  EXPECT_TRUE(loaded().all().empty());
  EXPECT_EQ(error_.id, "settings.syntax");
  EXPECT_EQ(error_.where.line, 3);
  EXPECT_EQ(error_.where.column, 3);
  EXPECT_THAT(error_.describe(), HasSubstr("settings.json.broken"));
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_THAT(readFile(folder_ / "deep" / "settings.json.broken").value(), HasSubstr("oops"));
  EXPECT_TRUE(loaded().all().empty());
  EXPECT_EQ(error_, Error{});
}

TEST_F(SettingsTest, filesThatAreNoneOfOursAreRefused) {
  const std::string format = "\"format\": \"robotcontrol-settings\"";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "settings.syntax"},
      {"[]", "settings.format"},
      {"{\"format\": 5}", "settings.format"},
      {"{" + format + "}", "settings.version"},
      {"{" + format + ", \"version\": \"1\"}", "settings.version"},
      {"{" + format + ", \"version\": 2, \"settings\": {}}", "settings.newer"},
      {"{" + format + ", \"version\": 1, \"settings\": []}", "settings.format"},
      {"{" + format + ", \"version\": 1, \"settings\": {\"a\": 1e999}}", "settings.syntax"},
      {std::string(100'000, '['), "settings.syntax"},
      {"{\"a\": " + std::string(1000, '[') + std::string(1000, ']') + "}", "settings.syntax"}};
  for (const auto& [text, id] : cases) {
    write(text);
    loaded();
    EXPECT_EQ(error_.id, id) << text.substr(0, 80);
  }
}

TEST_F(SettingsTest, aValueOfAnUnknownKindIsSkippedAlone) {
  write(
      "{\"format\": \"robotcontrol-settings\", \"version\": 1, \"settings\": {\"a\": {}, \"b\": [1], \"c\": "
      "null, \"d\": 4}}");
  EXPECT_EQ(loaded().all().size(), 1U);
  EXPECT_EQ(error_, Error{});
}
