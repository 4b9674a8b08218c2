// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/VideoFrames.h"

#include <gtest/gtest.h>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/TestFolder.h"
#include "tests/logplayer/pictures/AviFile.h"

using namespace logplayer;
using robotlink::Image;
using robotlink::Rgb;

namespace {

/// 64 x 48 pixels of one color.
Image plain(Rgb color) {
  Image image(64, 48, robotlink::PixelFormat::kRgb8);
  for (std::size_t i = 0; i < image.data.size(); i += 3) {
    image.data[i] = color.r;
    image.data[i + 1] = color.g;
    image.data[i + 2] = color.b;
  }
  return image;
}

Rgb middleOf(const FrameSource::Frame& frame) {
  const auto raw = rawImage(dynamic_cast<const foxglove::CompressedImage&>(*frame.image));
  return robotlink::pixelRgb(robotlink::imageView(**raw), 32, 24);
}

void expectNear(Rgb is, Rgb shouldBe) {
  EXPECT_NEAR(is.r, shouldBe.r, 12);
  EXPECT_NEAR(is.g, shouldBe.g, 12);
  EXPECT_NEAR(is.b, shouldBe.b, 12);
}

class VideoFramesTest : public testing::Test {
 protected:
  VideoFramesTest() {
    for (const Rgb color : colors_) avi_.add(plain(color));
  }
  std::filesystem::path written(const std::string& bytes) const {
    std::ofstream(folder_ / "some.avi", std::ios::binary) << bytes;
    return folder_ / "some.avi";
  }

  const std::vector<Rgb> colors_{{200, 30, 30}, {30, 180, 40}, {40, 40, 220}, {230, 130, 20}};
  AviFile avi_{64, 48, 10};
  TestFolder folder_;
};

}  // namespace

TEST_F(VideoFramesTest, givesEachFrameWithItsColorsAndTime) {
  auto video = VideoFrames::open(written(avi_.bytes()));
  ASSERT_TRUE(video) << video.error().describe();
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const auto frame = video->next();
    ASSERT_TRUE(frame && *frame) << i;
    EXPECT_EQ((*frame)->width, 64);
    EXPECT_EQ((*frame)->height, 48);
    EXPECT_NEAR(robotlink::seconds((*frame)->time), 0.1 * static_cast<double>(i), 1e-3);
    expectNear(middleOf(**frame), colors_[i]);
    EXPECT_DOUBLE_EQ(video->share(), 0.25 * static_cast<double>(i + 1));
  }
  const auto end = video->next();
  ASSERT_TRUE(end);
  EXPECT_FALSE(*end);
}

TEST_F(VideoFramesTest, saysWhereAVideoBreaksOff) {
  for (int i = 0; i < 100; ++i) avi_.add(plain(colors_[0]));
  const std::string whole = avi_.bytes();
  auto video = VideoFrames::open(written(whole.substr(0, whole.size() / 2)));
  ASSERT_TRUE(video) << video.error().describe();
  robotlink::Result<std::optional<FrameSource::Frame>> frame = video->next();
  int count = 0;
  for (; frame && *frame; frame = video->next()) ++count;
  EXPECT_GT(count, 30);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().id, "video.truncated");
  EXPECT_EQ(frame.error().arguments.at(0), std::to_string(count));
  EXPECT_FALSE(*video->next()) << "after the error it is at its end";
}

TEST_F(VideoFramesTest, isKnownByItsFirstBytesOnly) {
  EXPECT_TRUE(isVideo(written(avi_.bytes())));
  using namespace std::string_literals;
  EXPECT_TRUE(isVideo(written("\0\0\0\x18"s + "ftypmp42........"s)));
  EXPECT_TRUE(isVideo(written("\x1a\x45\xdf\xa3............"s)));
  EXPECT_FALSE(isVideo(written("RIFF....WAVEfmt ...")));
  EXPECT_FALSE(isVideo(written("short")));
  EXPECT_FALSE(isVideo(folder_ / "none.avi"));
  EXPECT_FALSE(isVideo(folder_.path()));
}

TEST_F(VideoFramesTest, isRefusedWhereNothingCanBeDecoded) {
  const auto video = VideoFrames::open(written("RIFF\x10\0\0\0AVI nothing but noise"));
  ASSERT_FALSE(video);
  EXPECT_EQ(video.error().id, "video.open");
  EXPECT_EQ(video.error().where.file, (folder_ / "some.avi").string());
}
