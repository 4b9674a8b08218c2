// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraAddress.h"

#include <gtest/gtest.h>

namespace app {
namespace {

TEST(CameraAddress, hasADeviceAndWhatIsAskedOfIt) {
  const auto address =
      parseCameraAddress("camera:///dev/video2?size=320x240&rate=12.5&format=MJPG&brightness=-4");
  ASSERT_TRUE(address) << address.error().text;
  EXPECT_EQ(*address, (CameraAddress{.device = "/dev/video2",
                                     .width = 320,
                                     .height = 240,
                                     .rate = 12.5,
                                     .format = "MJPG",
                                     .controls = {{"brightness", -4}}}));
  EXPECT_EQ(toString(*address), "camera:///dev/video2?size=320x240&rate=12.5&format=MJPG&brightness=-4");
}

TEST(CameraAddress, theDeviceAloneIsEnough) {
  EXPECT_EQ(toString(*parseCameraAddress("/dev/video0")), "camera:///dev/video0");
  EXPECT_EQ(toString(*parseCameraAddress("camera:///dev/v4l/by-id/usb-Cam-index0")),
            "camera:///dev/v4l/by-id/usb-Cam-index0");
}

TEST(CameraAddress, othersAreNone) {
  EXPECT_TRUE(isCameraAddress("camera:///dev/video0"));
  EXPECT_TRUE(isCameraAddress("/dev/video1"));
  EXPECT_FALSE(isCameraAddress("/dev/ttyUSB0"));
  EXPECT_FALSE(isCameraAddress("match.mp4"));
}

TEST(CameraAddress, whatIsWrongIsNamed) {
  const auto problem = [](const std::string& source) {
    const auto address = parseCameraAddress(source);
    return address ? std::string() : address.error().text;
  };
  EXPECT_NE(problem("camera://").find("there is no device"), std::string::npos);
  EXPECT_NE(problem("/dev/video0?size=0x4").find("a size is"), std::string::npos);
  EXPECT_NE(problem("/dev/video0?size=640").find("a size is"), std::string::npos);
  EXPECT_NE(problem("/dev/video0?rate=nan").find("a rate is"), std::string::npos);
  EXPECT_NE(problem("/dev/video0?format=MJPEG").find("four letters"), std::string::npos);
  EXPECT_NE(problem("/dev/video0?brightness=much").find("\"brightness\" is a whole number"),
            std::string::npos);
  EXPECT_NE(problem("/dev/video0?=3").find("whole number"), std::string::npos);
}

}  // namespace
}  // namespace app
