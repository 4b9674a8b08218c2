// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/Stereogram.h"

#include <gtest/gtest.h>

using widgets::inGray;
using widgets::stereogram;

namespace {

constexpr int kWidth = 300, kHeight = 8;

QImage flat(int gray) {
  QImage image(kWidth, kHeight, QImage::Format_RGB32);
  image.fill(qRgb(gray, gray, gray));
  return image;
}

/// Whether a row repeats itself after so many pixels everywhere between two columns.
bool repeats(const QImage& image, int period, int from, int to) {
  for (int x = from; x + period < to; ++x)
    if (image.pixel(x, 4) != image.pixel(x + period, 4)) return false;
  return true;
}

}  // namespace

TEST(Stereogram, whatIsFarRepeatsAfterHalfTheDistanceOfTheEyes) {
  // 300 pixels: eyes are 100 pixels apart.
  EXPECT_TRUE(repeats(stereogram(flat(0)), 50, 0, kWidth));
  EXPECT_FALSE(repeats(stereogram(flat(0)), 40, 0, kWidth));
}

TEST(Stereogram, whatIsNearRepeatsSooner) {
  // (1 - 1/3) * 100 / (2 - 1/3)
  EXPECT_TRUE(repeats(stereogram(flat(255)), 40, 0, kWidth));
}

TEST(Stereogram, itHasDotsOfTwoColorsAndIsTheSameEachTime) {
  const QImage picture = stereogram(flat(0));
  int white = 0;
  for (int x = 0; x < kWidth; ++x) white += qGray(picture.pixel(x, 0)) == 255 ? 1 : 0;
  EXPECT_GT(white, kWidth / 4);
  EXPECT_LT(white, 3 * kWidth / 4);
  EXPECT_EQ(picture, stereogram(flat(0)));
  EXPECT_EQ(picture.size(), QSize(kWidth, kHeight));
}

TEST(Stereogram, tinyAndMissingImagesAreFine) {
  EXPECT_TRUE(stereogram({}).isNull());
  QImage one(1, 1, QImage::Format_RGB32);
  one.fill(Qt::white);
  EXPECT_EQ(stereogram(one).size(), QSize(1, 1));
}

TEST(Stereogram, grayKeepsTheBrightness) {
  QImage image(1, 1, QImage::Format_RGB32);
  image.fill(qRgb(200, 100, 0));
  const QRgb gray = inGray(image).pixel(0, 0);
  EXPECT_EQ(qRed(gray), qBlue(gray));
  EXPECT_EQ(qRed(gray), qGray(qRgb(200, 100, 0)));
}
