// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/MessageKinds.h"

#include <gtest/gtest.h>

#include <set>

namespace logplayer::bhuman {
namespace {

TEST(MessageKinds, kindsHaveTheNamesOf2009) {
  struct Case {
    Kind kind;
    const char* name;
  };
  for (const Case& one :
       {Case{Kind::kProcessBegin, "ProcessBegin"}, Case{Kind::kProcessFinished, "ProcessFinished"},
        Case{Kind::kImage, "Image"}, Case{Kind::kJpegImage, "JPEGImage"}, Case{Kind::kJointData, "JointData"},
        Case{Kind::kSensorData, "SensorData"}, Case{Kind::kKeyStates, "KeyStates"},
        Case{Kind::kOdometryData, "OdometryData"}, Case{Kind::kCameraMatrix, "CameraMatrix"},
        Case{Kind::kImageCoordinateSystem, "ImageCoordinateSystem"}, Case{Kind::kText, "Text"}})
    EXPECT_EQ(kindName(idOf(one.kind)), one.name);
}

TEST(MessageKinds, everyIdHasANameOfItsOwn) {
  std::set<std::string> names;
  int known = 0;
  for (int id = 0; id < 256; ++id) {
    const auto byte = static_cast<std::uint8_t>(id);
    names.insert(kindName(byte));
    if (hasName(byte))
      ++known;
    else
      EXPECT_EQ(kindName(byte), "id " + std::to_string(id));
  }
  EXPECT_EQ(names.size(), 256U);
  EXPECT_EQ(known, 67);
}

TEST(MessageKinds, onlySomeHaveAFixedSize) {
  int fixed = 0;
  for (int id = 0; id < 256; ++id) {
    const auto size = fixedSize(static_cast<std::uint8_t>(id));
    if (!size) continue;
    ++fixed;
    EXPECT_GT(*size, 0U) << id;
    EXPECT_TRUE(hasName(static_cast<std::uint8_t>(id))) << id;
  }
  EXPECT_EQ(fixed, 8);
  EXPECT_EQ(fixedSize(idOf(Kind::kKeyStates)), 20U);
  EXPECT_FALSE(fixedSize(idOf(Kind::kImage)));
  EXPECT_FALSE(fixedSize(idOf(Kind::kText)));
}

}  // namespace
}  // namespace logplayer::bhuman
