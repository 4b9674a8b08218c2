// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/RawPicture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "foxglove/Image.pb.h"

namespace widgets {
namespace {

template <typename T>
foxglove::RawImage rawImage(const std::string& encoding, int width, const std::vector<T>& values) {
  foxglove::RawImage image;
  image.set_encoding(encoding);
  image.set_width(static_cast<std::uint32_t>(width));
  image.set_height(static_cast<std::uint32_t>(values.size()) / image.width());
  image.set_step(static_cast<std::uint32_t>(image.width() * sizeof(T)));
  image.set_data(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return image;
}

int grayAt(const QImage& picture, int x, int y) {
  const QRgb pixel = picture.pixel(x, y);
  EXPECT_EQ(qRed(pixel), qGreen(pixel));
  EXPECT_EQ(qRed(pixel), qBlue(pixel));
  return qRed(pixel);
}

TEST(RawPicture, depthsInMetersAreBrightWhereNear) {
  const float kNone = std::numeric_limits<float>::quiet_NaN(), kFar = std::numeric_limits<float>::infinity();
  const auto image = rawImage<float>("32FC1", 3, {1, 2, 3, kNone, kFar, -kFar});
  const QImage picture = rawPicture(image);
  ASSERT_EQ(picture.size(), QSize(3, 2));
  EXPECT_EQ(grayAt(picture, 0, 0), 255);
  EXPECT_GT(grayAt(picture, 1, 0), grayAt(picture, 2, 0));
  EXPECT_GT(grayAt(picture, 2, 0), 20) << "the farthest is not nothing";
  for (int x = 0; x < 3; ++x) EXPECT_EQ(grayAt(picture, x, 1), 0) << "what is no depth is black";
  EXPECT_EQ(describe(rawPixel(image, 1, 0).value()).toStdString(), "x   1  y   0   2.000 m");
  EXPECT_EQ(describe(rawPixel(image, 0, 1).value()).toStdString(), "x   0  y   1   –");
  EXPECT_FALSE(rawPixel(image, 3, 0));
}

TEST(RawPicture, depthsInMillimetersAreShownInMeters) {
  const auto image = rawImage<std::uint16_t>("16UC1", 3, {0, 1500, 4000});
  const QImage picture = rawPicture(image);
  EXPECT_EQ(grayAt(picture, 0, 0), 0);
  EXPECT_EQ(grayAt(picture, 1, 0), 255);
  EXPECT_LT(grayAt(picture, 2, 0), 100);
  EXPECT_EQ(rawPixel(image, 1, 0)->depth, 1.5);
  EXPECT_TRUE(std::isnan(*rawPixel(image, 0, 0)->depth));
}

TEST(RawPicture, brightnessesOfSixteenBitsAreScaled) {
  const auto image = rawImage<std::uint16_t>("mono16", 3, {100, 200, 300});
  const QImage picture = rawPicture(image);
  EXPECT_EQ(grayAt(picture, 0, 0), 0);
  EXPECT_NEAR(grayAt(picture, 1, 0), 127.5, 1);
  EXPECT_EQ(grayAt(picture, 2, 0), 255);
  EXPECT_EQ(rawPixel(image, 2, 0)->value, 300);
}

TEST(RawPicture, oneDepthEverywhereIsNear) {
  EXPECT_EQ(grayAt(rawPicture(rawImage<float>("32FC1", 2, {2, 2})), 1, 0), 255);
  EXPECT_EQ(grayAt(rawPicture(rawImage<std::uint16_t>("16UC1", 2, {0, 0})), 1, 0), 0);
}

TEST(RawPicture, otherEncodingsAreDrawnInTheirColors) {
  const auto image = rawImage<std::uint8_t>("rgb8", 3, {10, 20, 30});
  EXPECT_TRUE(rawPicture(image).isNull()) << "three bytes are one pixel";
  auto pixel = image;
  pixel.set_width(1);
  EXPECT_EQ(rawPicture(pixel).pixel(0, 0), qRgb(10, 20, 30));
  EXPECT_EQ(rawPixel(pixel, 0, 0)->rgb, (robotlink::Rgb{10, 20, 30}));
}

TEST(RawPicture, dataThatDoNotFitAreNoPicture) {
  auto image = rawImage<float>("32FC1", 2, {1, 2, 3, 4});
  image.mutable_data()->pop_back();
  EXPECT_TRUE(rawPicture(image).isNull());
  EXPECT_FALSE(rawPixel(image, 0, 0));
  image.set_width(0);
  EXPECT_TRUE(rawPicture(image).isNull());
  image = rawImage<float>("32FC1", 2, {1, 2, 3, 4});
  image.set_step(4);
  EXPECT_TRUE(rawPicture(image).isNull());
}

}  // namespace
}  // namespace widgets
