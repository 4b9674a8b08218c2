// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Presets.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/session/KeyModes.h"
#include "robotlink/session/KeyPresets.h"
#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"

using namespace robotlink;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

class PresetsTest : public testing::Test {
 protected:
  static Preset keys(const Preset::Values& values) {
    Preset preset;
    preset.parts[Preset::kKeys] = values;
    return preset;
  }
  std::string errorOf(const std::string& text) const {
    const auto loaded = Presets::loadFile(home_.write("a.preset.json", text));
    return loaded ? "" : loaded.error().describe();
  }

  const TestFolder home_;
  const Presets presets_{home_ / "presets"};  // which is not there yet
};

}  // namespace

TEST_F(PresetsTest, whatIsSavedIsReadBackWithItsPartsOnly) {
  Preset preset = keys({{"image/camera", "every 3"}});
  preset.parts[Preset::kParameters] = Preset::Values{{"walking/gait step.height", "0.03"}};
  preset.parts[Preset::kViews] = Preset::Values();
  ASSERT_TRUE(presets_.save("my own", preset));
  EXPECT_THAT(presets_.names(), ElementsAre("my own"));
  EXPECT_EQ(presets_.load("my own").value(), preset);
  EXPECT_FALSE(presets_.load("other"));
  EXPECT_FALSE(presets_.save("../a", preset));
}

TEST_F(PresetsTest, settingsOfTheCameraThatDifferFromItsStartBelongToAPreset) {
  Session session;
  session.setRobots({"red1"});
  const auto push = [&](const char* path, PackagePtr message) {
    session.push({std::string("red1/") + path, Instant(fromSeconds(1)), std::move(message)});
    session.tick();
  };
  auto settings = std::make_shared<robotcontrol::CameraSettings>();
  for (const auto& [name, value] : {std::pair("exposure", 0.25), std::pair("gain", 1.0)}) {
    auto& setting = *settings->add_settings();
    setting.set_name(name);
    setting.set_value(value);
    setting.set_initial(1);
  }
  push("camera/settings", settings);
  EXPECT_FALSE(cameraSettings(session)) << "it may have changed since its key was switched off";
  auto table = std::make_shared<robotcontrol::KeyTable>();
  table->add_keys()->set_name("package/camera/settings");
  table->mutable_keys(0)->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  push("tables/keys", table);
  const auto known = cameraSettings(session);
  ASSERT_TRUE(known);
  EXPECT_EQ(*known, (Preset::Values{{"exposure", "0.25"}}));
  Preset now, wanted;
  now.parts[Preset::kCamera] = *known;
  wanted.parts[Preset::kCamera] = Preset::Values{{"gain", "2"}};
  ASSERT_TRUE(presets_.save("dark", wanted));
  EXPECT_EQ(presets_.load("dark").value(), wanted);
  EXPECT_THAT(differences(now, wanted),
              ElementsAre("camera: exposure is 0.25, not the default", "camera: gain is the default, not 2"));
  EXPECT_THAT(errorOf(R"({"format": "robotcontrol-preset", "version": 1,
                          "preset": {"camera": {"gain": "much"}}})"),
              HasSubstr("gain has to be a number, not 'much'"));
}

TEST_F(PresetsTest, olderFilesWithKeysAreReadAndReplaced) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_name("a");
  *key.mutable_mode() = keyModeOf("every-ms 40").value();
  ASSERT_TRUE(KeyPresets(home_ / "presets").save("old", table));
  EXPECT_THAT(presets_.names(), ElementsAre("old"));
  const auto loaded = presets_.load("old");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(*loaded, keys({{"a", "every-ms 40"}}));
  EXPECT_EQ(Presets::loadFile(home_ / "presets" / "old.keys.json").value(), *loaded);
  ASSERT_TRUE(presets_.save("old", *loaded));
  EXPECT_TRUE(std::filesystem::exists(home_ / "presets" / "old.preset.json"));
  EXPECT_FALSE(std::filesystem::exists(home_ / "presets" / "old.keys.json"));
}

TEST_F(PresetsTest, theyAreRenamedAndRemoved) {
  ASSERT_TRUE(presets_.save("a", keys({})));
  ASSERT_TRUE(presets_.save("b", keys({})));
  EXPECT_EQ(presets_.rename("a", "b").error().id, "preset.exists");
  ASSERT_TRUE(presets_.rename("a", "c"));
  EXPECT_THAT(presets_.names(), ElementsAre("b", "c"));
  ASSERT_TRUE(presets_.remove("b"));
  EXPECT_FALSE(presets_.remove("b"));
  EXPECT_THAT(presets_.names(), ElementsAre("c"));
}

TEST_F(PresetsTest, aFileOfAnotherShapeIsReportedWithItsName) {
  const std::string begin = R"({"format":"robotcontrol-preset","version":1,"preset":)";
  EXPECT_EQ(errorOf(begin + R"({"keys":{"a":"every 3"}}})"), "");
  EXPECT_THAT(errorOf(begin + R"({"keys":{"a":"seldom"}}})"), HasSubstr("a.preset.json"));
  EXPECT_THAT(errorOf(begin + R"({"keys":{"a":3}}})"), HasSubstr("has to be a text"));
  EXPECT_THAT(errorOf(begin + R"({"views":[]}})"), HasSubstr("has to be an object"));
  EXPECT_NE(errorOf("{}"), "");
}

TEST_F(PresetsTest, differencesAreThoseOfThePartsThatBothHave) {
  Preset now = keys({{"a", "always"}, {"b", "n 3"}}), wanted = keys({{"b", "n 3"}, {"c", "every 2"}});
  now.parts[Preset::kSolutions] = Preset::Values{{"walking", "gait"}};
  now.parts[Preset::kViews] = Preset::Values{{"layout", "1"}};
  wanted.parts[Preset::kViews] = Preset::Values{{"layout", "2"}};
  EXPECT_THAT(differences(now, wanted),
              ElementsAre("keys: a is always, not off", "keys: c is off, not every 2"));
  EXPECT_THAT(differences(now, now), IsEmpty());
}

TEST_F(PresetsTest, whatIsChosenNowComesFromTheTablesOfTheSelectedRobot) {
  Session session;
  session.setRobots({"red1"});
  auto keys = std::make_shared<robotcontrol::KeyTable>();
  keys->add_keys()->set_name("off");
  keys->add_keys()->set_name("on");
  *keys->mutable_keys(1)->mutable_mode() = keyModeOf("always").value();
  auto solutions = std::make_shared<robotcontrol::SolutionTable>();
  solutions->add_tasks()->set_name("walking");
  solutions->mutable_tasks(0)->set_active("gait");
  session.push({"red1/tables/keys", Instant{}, keys});
  session.push({"red1/tables/solutions", Instant{}, solutions});
  session.tick();
  EXPECT_EQ(keysThatAreOn(session), (Preset::Values{{"on", "always"}}));
  EXPECT_EQ(activeSolutions(session), (Preset::Values{{"walking", "gait"}}));
}

TEST(KeyModes, wordsAndModesCorrespond) {
  for (const char* words : {"off", "always", "n 3", "every 3", "every-ms 40"})
    EXPECT_EQ(inWords(keyModeOf(words).value()), words);
  for (const char* words : {"", "on", "always 3", "n", "n -1", "n x", "every 99999999", "n 3 4"})
    EXPECT_FALSE(keyModeOf(words)) << words;
}
