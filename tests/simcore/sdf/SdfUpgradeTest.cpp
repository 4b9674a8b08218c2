// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfUpgrade.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace simcore {
namespace {

/// The text without line breaks and the blanks at their sides.
std::string compact(const std::string& text) {
  std::string result;
  bool isBreak = true;
  for (const char c : text) {
    if (c == '\n') isBreak = true;
    if (c == '\n' || (isBreak && c == ' ')) continue;
    isBreak = false;
    result += c;
  }
  return result;
}

/// What stands in <sdf> after the upgrade.
std::string upgraded(const std::string& content, int minor) {
  tinyxml2::XMLDocument document;
  document.Parse(("<sdf version=\"1." + std::to_string(minor) + "\">" + content + "</sdf>").c_str());
  EXPECT_FALSE(document.Error()) << document.ErrorStr();
  upgradeSdf(document, minor);
  EXPECT_STREQ(document.RootElement()->Attribute("version"), "1.9");
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  std::string text = compact(printer.CStr());
  const std::string head = "<sdf version=\"1.9\">", tail = "</sdf>";
  EXPECT_TRUE(text.starts_with(head)) << text;
  return text.substr(head.size(), text.size() - head.size() - tail.size());
}

TEST(SdfUpgrade, versionsAreRead) {
  struct Case {
    const char* text;
    int minor;
  };
  for (const Case& one :
       {Case{"1.2", 2}, Case{"1.12", 12}, Case{"1.4.1", 4}, Case{"1.", -1}, Case{"2.0", -1}, Case{"", -1},
        Case{"1.x", -1}, Case{"1.4x", -1}, Case{"1.-3", -1}, Case{"1.100", -1}})
    EXPECT_EQ(sdfMinorVersion(one.text), one.minor) << one.text;
}

TEST(SdfUpgrade, anEmptyDocumentStaysEmpty) {
  tinyxml2::XMLDocument document;
  upgradeSdf(document, 4);
  EXPECT_EQ(document.RootElement(), nullptr);
}

struct Upgrade {
  const char* what;
  int minor;
  const char *before, *after;
};

const Upgrade kUpgrades[] = {
    {"the frame of a pose", 6, R"(<pose frame="arm">1 0 0 0 0 0</pose>)",
     R"(<pose relative_to="arm">1 0 0 0 0 0</pose>)"},
    {"an empty frame of a pose", 6, R"(<pose frame="">1 0 0 0 0 0</pose>)", "<pose>1 0 0 0 0 0</pose>"},
    {"a frame that came later", 7, R"(<pose frame="arm">1 0 0 0 0 0</pose>)",
     R"(<pose frame="arm">1 0 0 0 0 0</pose>)"},
    {"an axis of 1.4 is in the model's frame", 4, "<axis><xyz>0 0 1</xyz></axis>",
     R"(<axis><xyz expressed_in="__model__">0 0 1</xyz></axis>)"},
    {"an axis of 1.5 is in the joint's frame", 5, "<axis><xyz>0 0 1</xyz></axis>",
     "<axis><xyz>0 0 1</xyz></axis>"},
    {"an axis says so itself", 6,
     "<axis><xyz>0 0 1</xyz><use_parent_model_frame>true</use_parent_model_frame></axis>",
     R"(<axis><xyz expressed_in="__model__">0 0 1</xyz></axis>)"},
    {"an axis says that it is not", 4,
     "<axis2><xyz>0 0 1</xyz><use_parent_model_frame>0</use_parent_model_frame></axis2>",
     "<axis2><xyz>0 0 1</xyz></axis2>"},
    {"an initial position", 6, "<axis><initial_position>1</initial_position><xyz>0 0 1</xyz></axis>",
     "<axis><xyz>0 0 1</xyz></axis>"},
    {"the gravity of the physics", 5,
     "<world><physics><gravity>0 0 -1</gravity><real_time_factor>1</real_time_factor></physics></world>",
     "<world><physics><real_time_factor>1</real_time_factor></physics><gravity>0 0 -1</gravity></world>"},
    {"a world without gravity", 5, "<world><physics/></world>", "<world><physics/></world>"},
    {"the noise that axes of an IMU shared", 4,
     "<imu><noise><type>gaussian</type><rate><mean>0.1</mean><stddev>0.2</stddev></rate></noise></imu>",
     R"(<imu><angular_velocity><x><noise type="gaussian"><mean>0.1</mean><stddev>0.2</stddev></noise></x>)"
     R"(<y><noise type="gaussian"><mean>0.1</mean><stddev>0.2</stddev></noise></y>)"
     R"(<z><noise type="gaussian"><mean>0.1</mean><stddev>0.2</stddev></noise></z></angular_velocity></imu>)"},
    {"names of flattened models", 7,
     R"(<model name="m"><link name="a::b"/><joint name="j"><parent>a::b</parent><child>m::c</child></joint></model>)",
     R"(<model name="m"><link name="a_b"/><joint name="j"><parent>a_b</parent><child>m_c</child></joint></model>)"},
    {"names of nested models", 8, R"(<model name="m"><joint name="a::b"/></model>)",
     R"(<model name="m"><joint name="a::b"/></model>)"},
    {"names of parts that nobody flattened", 7, R"(<joint name="j"><parent>a::b</parent></joint>)",
     R"(<joint name="j"><parent>a::b</parent></joint>)"},
};

TEST(SdfUpgrade, whatChangedBetweenVersionsIsRewritten) {
  for (const Upgrade& one : kUpgrades) EXPECT_EQ(upgraded(one.before, one.minor), one.after) << one.what;
}

TEST(SdfUpgrade, whatIsDeepInADocumentIsRewrittenToo) {
  EXPECT_EQ(
      upgraded(
          R"(<world><model><link><sensor><pose frame="x">0 0 0 0 0 0</pose></sensor></link></model></world>)",
          5),
      R"(<world><model><link><sensor><pose relative_to="x">0 0 0 0 0 0</pose></sensor></link></model></world>)");
}

}  // namespace
}  // namespace simcore
