// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ClassPresets.h"

#include <gmock/gmock.h>

#include <set>

#include "robotlink/config/FieldDescription.h"

namespace {

using colortool::ClassPreset;
using colortool::ColorClasses;
using colortool::NamedColor;
using testing::ElementsAre;

TEST(ClassPresets, areFoundByTheirNames) {
  const ClassPreset* preset = colortool::findClassPreset("2002");
  ASSERT_NE(preset, nullptr);
  EXPECT_EQ(preset, &colortool::classPresets().front());
  EXPECT_THAT(preset->classes().names(),
              ElementsAre("orange", "yellow", "skyblue", "pink", "green", "white", "red", "blue", "black"));
  EXPECT_EQ(colortool::findClassPreset("2001"), nullptr);
}

TEST(ClassPresets, areChosenByTheColorsOfAField) {
  const std::vector<std::string> field2002{"green",   "white", "orange", "yellow",
                                           "skyblue", "pink",  "red",    "blue"};
  const std::vector<std::string> field2009{"green", "white", "orange", "yellow",
                                           "blue",  "black", "red",    "robotBlue"};
  EXPECT_EQ(colortool::presetFor(field2002).name, "2002");
  EXPECT_EQ(colortool::presetFor(field2009).name, "bhuman2009");
  EXPECT_EQ(colortool::presetFor({}).name, "2002");
}

TEST(ClassPresets, haveNoNameAndNoColorTwice) {
  std::set<std::string_view> presets;
  for (const ClassPreset& preset : colortool::classPresets()) {
    EXPECT_TRUE(presets.insert(preset.name).second) << preset.name;
    EXPECT_FALSE(preset.title.empty());
    std::set<std::string_view> names{"none", "background"};
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const auto& color : preset.colors) {
      EXPECT_TRUE(names.insert(color.name).second) << preset.name << ' ' << color.name;
      EXPECT_TRUE(colors.insert({color.rgb.r, color.rgb.g, color.rgb.b}).second) << color.name;
    }
  }
}

TEST(ClassPresets, ofTheFieldHaveTheFieldsColors) {
  const auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  ASSERT_TRUE(field);
  const ColorClasses classes = colortool::findClassPreset("2002")->classes();
  int compared = 0;
  for (int i = 1; i < classes.size(); ++i) {
    const robotlink::Rgb* color =
        field->color(classes.name(i) == "black" ? std::string_view("dark") : classes.name(i));
    ASSERT_NE(color, nullptr) << classes.name(i);
    EXPECT_EQ(classes.shownColor(i), *color) << classes.name(i);
    ++compared;
  }
  EXPECT_EQ(compared, 9);
}

TEST(ClassPresets, ofTheRealLogAreThoseOfItsTables) {
  EXPECT_THAT(colortool::findClassPreset("bhuman2009")->classes().names(),
              ElementsAre("orange", "yellow", "blue", "white", "green", "black", "red", "robotBlue"));
}

TEST(ClassPresets, areChosenByTheirNamesOrTheirClasses) {
  const auto choose = [](std::vector<std::string> names) { return colortool::chooseClasses(names); };
  EXPECT_EQ(choose({"2002"})->names(), colortool::findClassPreset("2002")->classes().names());
  const auto own = choose({"orange", "robotBlue", "wall"});
  ASSERT_TRUE(own);
  EXPECT_THAT(own->names(), ElementsAre("orange", "robotBlue", "wall"));
  EXPECT_EQ(own->shownColor(1), (robotlink::Rgb{255, 105, 0}));
  EXPECT_EQ(own->shownColor(2), (robotlink::Rgb{0, 200, 255}));
  EXPECT_EQ(own->shownColor(3), colortool::spareColor(3));
  for (const auto& [names, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"orange", "none"}, "'none' stands for pixels of no class and cannot be one"},
           {{"orange", ""}, "a class needs a name"},
           {{"a\nb"}, "a class's name has control characters"},
           {{"orange", " red"}, "a class's name begins or ends with a space"},
           {{"red", "blue", "red"}, "the class 'red' is named twice"}}) {
    const auto wrong = choose(names);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().text, says);
  }
}

TEST(ClassPresets, spareColorsCanBeToldApart) {
  for (int i = 1; i <= 12; ++i) {
    for (int j = 1; j < i; ++j) {
      const robotlink::Rgb a = colortool::spareColor(i), b = colortool::spareColor(j);
      EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 30) << i << ' ' << j;
    }
  }
}

TEST(ColorClasses, areNumberedFromOneAndHaveRoomForAByte) {
  std::vector<NamedColor> many(300, {"", {1, 2, 3}});
  for (std::size_t i = 0; i < many.size(); ++i) many[i].name = "class" + std::to_string(i + 1);
  const ColorClasses classes(many);
  ASSERT_EQ(classes.size(), ColorClasses::kMax + 1);
  EXPECT_EQ(classes.name(0), "none");
  EXPECT_EQ(classes.name(255), "class255");
  EXPECT_EQ(classes.index("class255"), 255);
  EXPECT_EQ(classes.index("class256"), ColorClasses::kNone);
  EXPECT_EQ(classes.names().front(), "class1");
  EXPECT_EQ(classes, ColorClasses(many));
  many[7].rgb = {9, 9, 9};
  EXPECT_NE(classes, ColorClasses(many));
}

}  // namespace
