// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/KeyPresets.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

using namespace robotlink;
using robotcontrol::KeyMode;
using robotcontrol::KeyTable;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

namespace {

class KeyPresetsTest : public testing::Test {
 protected:
  static void add(KeyTable& table, const std::string& name, KeyMode::Kind kind, std::uint32_t n = 0) {
    auto& key = *table.add_keys();
    key.set_name(name);
    key.mutable_mode()->set_kind(kind);
    key.mutable_mode()->set_n(n);
  }

  const TestFolder home_;
  const fs::path folder_ = home_ / "presets";  // which is not there yet
  KeyPresets presets_{folder_};
};

}  // namespace

TEST_F(KeyPresetsTest, whatIsSavedIsReadBackWithoutKeysThatAreOff) {
  KeyTable table;
  add(table, "a/always", KeyMode::ALWAYS);
  add(table, "b/off", KeyMode::OFF, 3);
  add(table, "c/times", KeyMode::N_TIMES, 3);
  add(table, "d/nth", KeyMode::EVERY_N, 25);
  add(table, "e/ms", KeyMode::EVERY_MS, 4'000'000'000U);
  ASSERT_TRUE(presets_.save("my ball_1", table).has_value());
  const auto loaded = presets_.load("my ball_1");
  ASSERT_TRUE(loaded.has_value());
  KeyTable expected;
  for (const auto& key : table.keys()) {
    if (key.mode().kind() != KeyMode::OFF) *expected.add_keys() = key;
  }
  EXPECT_EQ(loaded->SerializeAsString(), expected.SerializeAsString());
}

TEST_F(KeyPresetsTest, presetsAreListedReplacedAndRemoved) {
  EXPECT_THAT(presets_.names(), IsEmpty());
  ASSERT_TRUE(presets_.save("walk", {}).has_value());
  ASSERT_TRUE(presets_.save("ball", {}).has_value());
  ASSERT_TRUE(presets_.save("ball", {}).has_value());
  ASSERT_TRUE(writeFileAtomically(folder_ / "notes.txt", "x").has_value());
  EXPECT_THAT(presets_.names(), ElementsAre("ball", "walk"));
  EXPECT_TRUE(presets_.remove("ball").has_value());
  EXPECT_THAT(presets_.names(), ElementsAre("walk"));
  EXPECT_EQ(presets_.remove("ball").error().id, "preset.remove");
  EXPECT_EQ(presets_.load("ball").error().id, "preset.unknown");
}

TEST_F(KeyPresetsTest, namesThatWouldLeaveTheFolderAreRefused) {
  for (const std::string& name :
       std::vector<std::string>{"", "../x", "a/b", ".hidden", " x", std::string(61, 'x')}) {
    EXPECT_EQ(presets_.save(name, {}).error().id, "preset.name") << name;
    EXPECT_EQ(presets_.load(name).error().id, "preset.name") << name;
  }
}

TEST_F(KeyPresetsTest, aModeThatIsNoneIsReportedWithItsKey) {
  for (const char* mode : {"5", "{}", "{\"mode\": \"sometimes\"}", "{\"mode\": \"every-n\"}",
                           "{\"mode\": \"every-n\", \"n\": -1}", "{\"mode\": \"every-n\", \"n\": 5000000000}",
                           "{\"mode\": [], \"n\": 1}"}) {
    const std::string text = "{\"format\": \"robotcontrol-debug-keys\", \"version\": 1, \"keys\": {\"a/b\": ";
    ASSERT_TRUE(writeFileAtomically(folder_ / "p.keys.json", text + mode + "}}").has_value());
    const auto loaded = presets_.load("p");
    ASSERT_FALSE(loaded.has_value()) << mode;
    EXPECT_EQ(loaded.error().id, "preset.mode");
    EXPECT_THAT(loaded.error().describe(), HasSubstr("p.keys.json: the key a/b needs"));
  }
}
