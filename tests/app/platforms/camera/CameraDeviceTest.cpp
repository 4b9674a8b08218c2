// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraDevice.h"

#include <gtest/gtest.h>

#include <array>

#include "logplayer/images/ImageCoding.h"
#include "tests/app/platforms/camera/FakeCamera.h"

namespace app {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;
using test::FakeCamera;

/// A gray image with one value for each pixel in turn.
std::string yuyvBytes(std::uint32_t width, std::uint32_t height, std::uint32_t step, std::uint8_t first) {
  std::string bytes;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t i = 0; i < step; ++i)
      bytes += static_cast<char>(i >= 2 * width ? 99 : (i % 2 == 1 ? 128 : first + y * width + i / 2));
  }
  return bytes;
}

/// What a JPEG of that has.
std::string jpegBytes(int width, int height, std::uint8_t luma) {
  Image image(width, height, PixelFormat::kYuyv);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = i % 2 == 1 ? 128 : luma;
  const auto bytes = *logplayer::encodeJpeg(image.view());
  return {bytes.begin(), bytes.end()};
}

/// Removes the segments of a JPEG with the tables of its Huffman code, as cameras do.
std::string withoutHuffmanTables(const std::string& jpeg) {
  std::string result = jpeg.substr(0, 2);
  std::size_t at = 2;
  while (at + 4 < jpeg.size()) {
    const auto marker = static_cast<std::uint8_t>(jpeg[at + 1]);
    const std::size_t length =
        2 + 256U * static_cast<std::uint8_t>(jpeg[at + 2]) + static_cast<std::uint8_t>(jpeg[at + 3]);
    if (marker == 0xda) break;
    if (marker != 0xc4) result += jpeg.substr(at, length);
    at += length;
  }
  return result + jpeg.substr(at);
}

std::string problemOf(const CameraAddress& address, FakeCamera& camera) {
  const auto device = CameraDevice::open(address, camera);
  return device ? std::string() : device.error().text;
}

TEST(CameraDevice, uncompressedImagesComeFirst) {
  FakeCamera camera;
  const auto device = CameraDevice::open({.device = "/dev/video0"}, camera);
  ASSERT_TRUE(device) << device.error().text;
  EXPECT_EQ((*device)->title(), "Fake camera");
  EXPECT_EQ((*device)->mode().format, "YUYV");
  EXPECT_EQ((*device)->mode().rate, 30);
  camera.give(yuyvBytes(8, 4, 16, 20));
  const auto image = (*device)->next(0);
  ASSERT_TRUE(image && *image) << (image ? "no image" : image.error().text);
  EXPECT_EQ((*image)->format, PixelFormat::kYuyv);
  EXPECT_EQ((*image)->width, 8);
  EXPECT_EQ((*image)->height, 4);
  EXPECT_EQ(robotlink::yuyvPixel((*image)->view(), 3, 2).y, 20 + 2 * 8 + 3);
}

TEST(CameraDevice, rowsMayHaveGaps) {
  FakeCamera camera;
  camera.step = 32;
  auto device = CameraDevice::open({.device = "/dev/video0"}, camera);
  camera.give(yuyvBytes(8, 4, 32, 0));
  const auto image = (*device)->next(0);
  ASSERT_TRUE(image && *image);
  EXPECT_EQ(robotlink::yuyvPixel((*image)->view(), 7, 3).y, 31);
}

TEST(CameraDevice, motionJpegIsDecodedAlsoWithoutItsTables) {
  FakeCamera camera;
  camera.width = 32, camera.height = 16;
  auto device = CameraDevice::open({.device = "/dev/video0", .format = "MJPG"}, camera);
  ASSERT_TRUE(device) << device.error().text;
  EXPECT_EQ(camera.chosenFormat(), std::uint32_t{V4L2_PIX_FMT_MJPEG});
  const std::string jpeg = jpegBytes(32, 16, 77);
  const std::string bare = withoutHuffmanTables(jpeg);
  ASSERT_LT(bare.size(), jpeg.size());
  for (const std::string& bytes : {jpeg, bare}) {
    camera.give(bytes);
    const auto image = (*device)->next(0);
    ASSERT_TRUE(image && *image) << (image ? "no image" : image.error().text);
    EXPECT_NEAR(robotlink::pixelYCbCr((*image)->view(), 5, 5).y, 77, 2);
  }
}

TEST(CameraDevice, ofSeveralImagesTheNewestCounts) {
  FakeCamera camera;
  auto device = CameraDevice::open({.device = "/dev/video0"}, camera);
  for (const std::uint8_t first : std::array<std::uint8_t, 3>{1, 2, 3})
    camera.give(yuyvBytes(8, 4, 16, first));
  auto image = (*device)->next(0);
  ASSERT_TRUE(image && *image);
  EXPECT_EQ(robotlink::yuyvPixel((*image)->view(), 0, 0).y, 3);
  image = (*device)->next(0);
  EXPECT_TRUE(image && !*image);
}

TEST(CameraDevice, damagedImagesAreLeftOut) {
  FakeCamera camera;
  auto device = CameraDevice::open({.device = "/dev/video0"}, camera);
  camera.give(yuyvBytes(8, 4, 16, 1).substr(0, 50));
  auto image = (*device)->next(0);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().id, "camera.damaged");
  camera.give(yuyvBytes(8, 4, 16, 1), V4L2_BUF_FLAG_ERROR);
  image = (*device)->next(0);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().id, "camera.damaged");
  // All memory is the driver's again.
  for (int i = 0; i < 9; ++i) {
    camera.give(yuyvBytes(8, 4, 16, 1));
    image = (*device)->next(0);
    EXPECT_TRUE(image && *image);
  }
}

TEST(CameraDevice, anUnpluggedCameraIsGone) {
  FakeCamera camera;
  auto device = CameraDevice::open({.device = "/dev/video0"}, camera);
  camera.unplug(true);
  const auto image = (*device)->next(0);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().id, "camera.gone");
}

TEST(CameraDevice, whatIsOpenedIsClosed) {
  FakeCamera camera;
  { auto device = CameraDevice::open({.device = "/dev/video0"}, camera); }
  EXPECT_EQ(camera.opened(), 0);
  EXPECT_EQ(camera.mapped(), 0);
  EXPECT_NE(problemOf({.device = "/dev/video0", .controls = {{"sound", 1}}}, camera), "");
  EXPECT_EQ(camera.opened(), 0);
}

TEST(CameraDevice, controlsAndRateAreSet) {
  FakeCamera camera;
  auto device = CameraDevice::open({.device = "/dev/video0",
                                    .rate = 12.5,
                                    .controls = {{"brightness", 33}, {"exposure_time_absolute", 7}}},
                                   camera);
  ASSERT_TRUE(device) << device.error().text;
  EXPECT_EQ(camera.values[FakeCamera::kBrightness], 33);
  EXPECT_EQ(camera.values[FakeCamera::kExposure], 7);
  EXPECT_DOUBLE_EQ((*device)->mode().rate, 12.5);
  EXPECT_EQ((*device)->controls().size(), 2U);
  const auto tooMuch = (*device)->set("brightness", 256);
  ASSERT_FALSE(tooMuch);
  EXPECT_NE(tooMuch.error().text.find("brightness is 0 to 255, not 256"), std::string::npos);
}

TEST(CameraDevice, whatIsMissingIsNamed) {
  FakeCamera camera;
  const auto has = [&](const std::string& text, const CameraAddress& address = {.device = "/dev/video0"}) {
    const std::string problem = problemOf(address, camera);
    return problem.find(text) != std::string::npos ? testing::AssertionSuccess()
                                                   : testing::AssertionFailure() << problem;
  };
  EXPECT_TRUE(
      has("it has brightness, exposure_time_absolute", {.device = "/dev/video0", .controls = {{"gain", 1}}}));
  EXPECT_TRUE(has("it has MJPG, YUYV", {.device = "/dev/video0", .format = "NV12"}));
  camera.formats = {v4l2_fourcc('H', '2', '6', '4')};
  EXPECT_TRUE(has("does not offer a format that can be decoded; it has H264"));
  camera.formats = {V4L2_PIX_FMT_YUYV};
  camera.width = 7;
  EXPECT_TRUE(has("7x4 YUYV"));
  camera.capabilities = V4L2_CAP_VIDEO_OUTPUT;
  EXPECT_TRUE(has("takes no images"));
  camera.refusal = EACCES;
  EXPECT_TRUE(has("group video"));
  camera.refusal = EBUSY;
  EXPECT_TRUE(has("another program uses it"));
  camera.unplug(true);
  EXPECT_TRUE(has("is the camera plugged in?"));
}

TEST(CameraDevice, camerasAreListedWithTheirTitles) {
  FakeCamera camera;
  const auto cameras = camerasHere(camera);
  ASSERT_FALSE(cameras.empty());
  EXPECT_EQ(cameras.front(), (std::pair<std::string, std::string>{"/dev/video0", "Fake camera"}));
  EXPECT_EQ(camera.opened(), 0);
}

}  // namespace
}  // namespace app
