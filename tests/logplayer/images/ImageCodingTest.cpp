// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/images/ImageCoding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "foxglove/Image.pb.h"
#include "robotlink/base/Random.h"
#include "robotlink/packages/Conversions.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

using namespace logplayer;
using robotlink::Image;
using robotlink::PixelFormat;

namespace {

/// Smooth in all channels, as camera images are, with a sharp edge.
Image testImage(int width, int height, PixelFormat format) {
  Image image(width, height, format);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    const double x = static_cast<double>(i % static_cast<std::size_t>(image.step()));
    const double y = static_cast<double>(i / static_cast<std::size_t>(image.step()));
    const double value =
        128 + 60 * std::sin(x / 70) + 50 * std::cos(y / 15) + (x > image.step() / 2 ? 15 : 0);
    image.data[i] = static_cast<std::uint8_t>(value);
  }
  return image;
}

/// Four components a pixel, each of them smooth.
std::vector<std::uint8_t> fourOf(int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < width * height; ++i) {
    for (int k = 0; k < 4; ++k)
      pixels.push_back(static_cast<std::uint8_t>(60 * k + i % width / 2 + i / width / 2));
  }
  return pixels;
}

int largestDifference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.format != b.format) return 256;
  int largest = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    largest = std::max(largest, std::abs(a.data[i] - b.data[i]));
  return largest;
}

std::vector<std::uint8_t> jpegOf(const Image& image, int quality = 90) {
  auto data = encodeJpeg(image.view(), quality);
  EXPECT_TRUE(data) << data.error().describe();
  return data ? *data : std::vector<std::uint8_t>();
}

}  // namespace

TEST(ImageCoding, aYuyvImageKeepsItsChannelsThroughJpeg) {
  for (const auto& [width, height] : {std::pair{320, 240}, {176, 144}, {6, 3}, {18, 17}, {2, 1}}) {
    const Image image = testImage(width, height, PixelFormat::kYuyv);
    const auto back = decodeJpeg(jpegOf(image, 100));
    ASSERT_TRUE(back) << back.error().describe();
    EXPECT_LE(largestDifference(image, *back), 8) << width << " x " << height;
  }
}

TEST(ImageCoding, jpegOfUsualQualityIsSmallAndClose) {
  const Image image = testImage(320, 240, PixelFormat::kYuyv);
  const auto data = jpegOf(image);
  EXPECT_LT(data.size(), image.data.size() / 6);
  EXPECT_LE(largestDifference(image, *decodeJpeg(data)), 25);
}

TEST(ImageCoding, grayAndRgbGoThroughJpeg) {
  const Image gray = testImage(33, 21, PixelFormat::kMono8);
  EXPECT_LE(largestDifference(gray, *decodeJpeg(jpegOf(gray, 100))), 3);

  const Image rgb = testImage(64, 48, PixelFormat::kRgb8);
  const auto back = decodeJpeg(jpegOf(rgb, 100));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->format, PixelFormat::kYuyv) << "JPEG stores YCbCr";
  const Image odd = testImage(63, 48, PixelFormat::kRgb8);
  EXPECT_EQ(decodeJpeg(jpegOf(odd))->format, PixelFormat::kRgb8) << "Yuyv has no odd widths";
}

TEST(ImageCoding, pngKeepsEveryValue) {
  for (const PixelFormat format : {PixelFormat::kRgb8, PixelFormat::kMono8}) {
    const Image image = testImage(63, 40, format);
    const auto data = encodePng(image.view());
    ASSERT_TRUE(data) << data.error().describe();
    EXPECT_EQ(*decodePng(*data), image);
  }
  const Image yuyv = testImage(64, 40, PixelFormat::kYuyv);
  EXPECT_EQ(*decodePng(*encodePng(yuyv.view())), toRgbImage(yuyv.view()));
}

TEST(ImageCoding, rowsWithGapsAreCodedWithoutThem) {
  const Image whole = testImage(64, 40, PixelFormat::kYuyv);
  robotlink::ImageView left = whole.view();
  left.width = 32;
  const auto back = decodeJpeg(*encodeJpeg(left, 100));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->width, 32);
  EXPECT_NEAR(back->row(39)[0], whole.row(39)[0], 8);
  EXPECT_EQ(decodePng(*encodePng(left))->width, 32);
}

TEST(ImageCoding, fourComponentsAreYieldedAsTheyWereCoded) {
  const auto pixels = fourOf(64, 48);
  const auto jpeg = bhuman::fourComponentJpeg(pixels, 64, 48);
  const auto quads = decodeJpegQuads(jpeg, 64 * 48);
  ASSERT_TRUE(quads) << quads.error().describe();
  EXPECT_EQ(quads->damage, "");
  ASSERT_EQ(quads->data.size(), pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) ASSERT_NEAR(quads->data[i], pixels[i], 12) << i;
  EXPECT_EQ(decodeJpegQuads(jpeg, 64 * 48 - 1).error().id, "image.size");
  EXPECT_EQ(decodeJpegQuads(jpegOf(testImage(64, 48, PixelFormat::kYuyv)), 64 * 48).error().id, "image.jpeg");
}

TEST(ImageCoding, fourInksOfAdobeAreShownInTheirColors) {
  const std::vector<std::uint8_t> red = {255, 0, 0, 255};  // inverted, as Adobe's programs store them
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 16 * 16; ++i) pixels.insert(pixels.end(), red.begin(), red.end());
  auto jpeg = bhuman::fourComponentJpeg(pixels, 16, 16);
  auto image = decodeJpeg(jpeg);
  ASSERT_TRUE(image) << image.error().describe();
  ASSERT_EQ(image->format, PixelFormat::kRgb8);
  EXPECT_NEAR(image->data[0], 255, 3);
  EXPECT_NEAR(image->data[1], 0, 3);
  const auto adobe = std::search(jpeg.begin(), jpeg.end(), std::begin("Adobe"), std::end("Adobe") - 1);
  ASSERT_NE(adobe, jpeg.end());
  *adobe = 'a';  // and so it is of others
  image = decodeJpeg(jpeg);
  ASSERT_TRUE(image) << image.error().describe();
  EXPECT_NEAR(image->data[0], 0, 3);
}

TEST(ImageCoding, endlessScansAreRefused) {
  auto jpeg = jpegOf(testImage(16, 16, PixelFormat::kYuyv));
  const std::vector<std::uint8_t> scan = {0xFF, 0xDA, 0, 12, 3, 1, 0, 2, 0x11, 3, 0x11, 0, 63, 0};
  for (int i = 0; i < 200; ++i) jpeg.insert(jpeg.end() - 2, scan.begin(), scan.end());
  EXPECT_NE(decodeJpeg(jpeg).error().text.find("too many scans"), std::string::npos);
}

TEST(ImageCoding, whatIsNoImageIsRefusedInWords) {
  const std::vector<std::uint8_t> text{'h', 'e', 'l', 'l', 'o'};
  EXPECT_EQ(decodeJpeg(text).error().id, "image.jpeg");
  EXPECT_NE(decodeJpeg(text).error().text.find("Not a JPEG file"), std::string::npos);
  EXPECT_EQ(decodePng(text).error().id, "image.png");
  EXPECT_EQ(decodeJpeg({}).error().id, "image.jpeg");
  EXPECT_EQ(decodePng({}).error().id, "image.png");
  EXPECT_EQ(encodeJpeg({}).error().id, "image.empty");
  EXPECT_EQ(encodePng({}).error().id, "image.empty");
  robotlink::ImageView odd = testImage(4, 4, PixelFormat::kYuyv).view();
  odd.width = 3;
  EXPECT_EQ(encodeJpeg(odd).error().id, "image.width");
}

TEST(ImageCoding, aSizeThatIsClaimedTakesNoMemory) {
  std::vector<std::uint8_t> jpeg = jpegOf(testImage(16, 16, PixelFormat::kMono8));
  for (std::size_t i = 0; i + 9 < jpeg.size(); ++i) {
    if (jpeg[i] != 0xFF || jpeg[i + 1] != 0xC0) continue;
    std::fill_n(jpeg.begin() + static_cast<std::ptrdiff_t>(i) + 5, 4, std::uint8_t{0xFE});
  }
  EXPECT_EQ(decodeJpeg(jpeg).error().id, "image.size");

  std::vector<std::uint8_t> png = *encodePng(testImage(16, 16, PixelFormat::kMono8).view());
  png[16] = png[20] = 0x10;  // of the width and height, big endian, in the header's chunk
  EXPECT_EQ(decodePng(png).error().id.rfind("image.", 0), 0U);
}

TEST(ImageCoding, cutAndDamagedImagesNeverDoHarm) {
  const Image image = testImage(48, 40, PixelFormat::kYuyv);
  const auto jpeg = jpegOf(image);
  const auto png = *encodePng(image.view());
  for (std::size_t size = 0; size < jpeg.size(); ++size) {
    const auto cut = decodeJpeg(std::span(jpeg).first(size));
    if (cut) {
      EXPECT_EQ(cut->width, 48);
    }
  }
  const auto four = bhuman::fourComponentJpeg(fourOf(48, 40), 48, 40);
  for (std::size_t size = 0; size < four.size(); ++size) {
    const auto cut = decodeJpegQuads(std::span(four).first(size), 10000);
    if (!cut) continue;
    EXPECT_EQ(cut->width, 48);
    EXPECT_TRUE(!cut->damage.empty() || size + 2 >= four.size()) << size;
  }
  for (std::size_t size = 0; size + 12 < png.size(); ++size)
    EXPECT_FALSE(decodePng(std::span(png).first(size))) << size;

  robotlink::Random random(1);
  for (int i = 0; i < 3000; ++i) {
    auto damaged = i % 2 == 0 ? jpeg : png;
    const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(damaged.size()));
    damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1U << (i % 8)));
    static_cast<void>(i % 2 == 0 ? decodeJpeg(damaged) : decodePng(damaged));
  }
}

TEST(ImageCoding, messagesKeepTimeAndFrame) {
  foxglove::RawImage raw;
  const Image image = testImage(64, 48, PixelFormat::kYuyv);
  robotlink::assign(raw, image.view(), robotlink::Instant(std::chrono::milliseconds(486749)), "nao/camera");
  for (const auto code : {&jpegImage, &pngImage}) {
    const auto compressed = code(raw);
    ASSERT_TRUE(compressed) << compressed.error().describe();
    const auto back = rawImage(**compressed);
    ASSERT_TRUE(back) << back.error().describe();
    EXPECT_EQ((*back)->frame_id(), "nao/camera");
    EXPECT_EQ((*back)->timestamp().SerializeAsString(), raw.timestamp().SerializeAsString());
    EXPECT_EQ((*back)->width(), 64U);
    EXPECT_FALSE(robotlink::imageView(**back).empty());
  }
}

TEST(ImageCoding, imagesOfAllFormatsAreSentAndCoded) {
  for (const PixelFormat format : robotlink::kPixelFormats) {
    SCOPED_TRACE(robotlink::encodingName(format));
    const Image image = testImage(64, 48, format);
    foxglove::RawImage raw;
    robotlink::assign(raw, image.view(), robotlink::Instant(std::chrono::seconds(1)), "camera");
    const robotlink::ImageView view = robotlink::imageView(raw);
    ASSERT_FALSE(view.empty());
    EXPECT_EQ(toRgbImage(view), toRgbImage(image.view()));
    const auto png = encodePng(image.view());
    ASSERT_TRUE(png) << png.error().describe();
    const auto back = decodePng(*png);
    ASSERT_TRUE(back);
    EXPECT_EQ(toRgbImage(back->view()), toRgbImage(image.view()));
    EXPECT_TRUE(encodeJpeg(image.view()));
    raw.mutable_data()->pop_back();  // it says that it is larger than it is
    EXPECT_TRUE(robotlink::imageView(raw).empty());
  }
}

TEST(ImageCoding, messagesThatHoldNoImageAreRefused) {
  foxglove::CompressedImage other;
  other.set_format("webp");
  EXPECT_NE(rawImage(other).error().text.find("'webp'"), std::string::npos);
  foxglove::RawImage bayer;
  bayer.set_encoding("bayer_rggb8");
  EXPECT_NE(jpegImage(bayer).error().text.find("'bayer_rggb8'"), std::string::npos);
}
