// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/VersionedFile.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace robotlink {
namespace {

const VersionedFormat kFormat{"robotcontrol-things", 2, "things", 4096};

class VersionedFileTest : public testing::Test {
 protected:
  /// What is wrong with a file of this text; empty if nothing is.
  std::string problem(const std::string& text) {
    folder_.write("things.json", text);
    const auto read = readVersioned(file_, kFormat);
    return read ? "" : read.error().id;
  }
  static std::string object(const std::string& version, const std::string& things) {
    return "{\"format\": \"robotcontrol-things\", \"version\": " + version + ", \"things\": " + things + "}";
  }

  const TestFolder folder_;
  const std::filesystem::path file_ = folder_ / "things.json";
};

TEST_F(VersionedFileTest, contentsAreReadBackAndSayTheirFormatFirst) {
  const nlohmann::json things{{"a", 1}, {"b", {1.5, "\xC3\xA4", nullptr}}};
  ASSERT_TRUE(writeVersioned(file_, kFormat, things));
  EXPECT_EQ(readVersioned(file_, kFormat).value(), things);
  EXPECT_EQ(readFile(file_).value().rfind("{\n  \"format\": \"robotcontrol-things\",\n  \"version\": 2,", 0),
            0U);
  EXPECT_EQ(folder_.contents(), "things.json") << "nothing beside it";
}

TEST_F(VersionedFileTest, aMissingFileIsEmpty) {
  EXPECT_EQ(readVersioned(folder_ / "none.json", kFormat).value(), nlohmann::json::object());
}

TEST_F(VersionedFileTest, olderVersionsAreReadAndNewerOnesAreNot) {
  EXPECT_EQ(problem(object("1", "{}")), "");
  EXPECT_EQ(problem(object("2", "{}")), "");
  EXPECT_EQ(problem(object("3", "{}")), "settings.newer");
  for (const char* version : {"0", "-1", "1.5", "\"2\"", "null"})
    EXPECT_EQ(problem(object(version, "{}")), "settings.version") << version;
}

TEST_F(VersionedFileTest, otherFilesAreRefused) {
  for (const char* text : {"[]", "1", "{}", "{\"format\": \"robotcontrol-settings\", \"version\": 1}"})
    EXPECT_EQ(problem(text), "settings.format") << text;
  EXPECT_EQ(problem(object("2", "[]")), "settings.format");
  EXPECT_NE(problem(std::string(5000, ' ')), "") << "larger than such a file may be";
}

TEST_F(VersionedFileTest, whatIsNoJsonIsSaidWithItsPlace) {
  folder_.write("things.json", "{\n  \"format\": oops\n}");
  const auto read = readVersioned(file_, kFormat);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().describe().find("things.json:2:"), std::string::npos) << read.error().describe();
  EXPECT_EQ(problem(""), "settings.syntax");
  std::string deep = "1";
  for (int i = 0; i < 100; ++i) deep = "[" + deep + "]";
  EXPECT_EQ(problem(object("2", "{\"a\": " + deep + "}")), "settings.syntax");
}

TEST_F(VersionedFileTest, anUnusableFileIsKeptAside) {
  folder_.write("things.json", "mine");
  folder_.write("things.json.broken", "older");
  const Error error = keepAside(file_, {"settings.syntax", "this is not valid JSON", {}, {}});
  EXPECT_EQ(folder_.contents(), "things.json.broken");
  EXPECT_EQ(readFile(folder_ / "things.json.broken").value(), "mine");
  EXPECT_NE(error.text.find("it was kept as things.json.broken"), std::string::npos) << error.text;
}

}  // namespace
}  // namespace robotlink
