// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/PictureFrames.h"

#include <gtest/gtest.h>

#include <fstream>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "tests/TestFolder.h"

using namespace logplayer;

namespace {

class PictureFramesTest : public testing::Test {
 protected:
  std::string write(const std::string& name, int width) const {
    const robotlink::Image image(width, 2, robotlink::PixelFormat::kRgb8);
    const auto data = name.ends_with(".png") ? encodePng(image.view()) : encodeJpeg(image.view());
    std::string bytes(data->begin(), data->end());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return bytes;
  }

  TestFolder folder_;
};

}  // namespace

TEST_F(PictureFramesTest, areInNaturalOrderAndUnchanged) {
  const std::string ten = write("frame-10.png", 10), nine = write("frame-9.jpg", 9),
                    two = write("frame-002.png", 2);
  std::ofstream(folder_ / "notes.txt") << "no picture";
  auto pictures = PictureFrames::open(folder_.path());
  ASSERT_TRUE(pictures) << pictures.error().describe();
  int count = 0;
  for (const auto& [width, bytes] : {std::pair{2, two}, {9, nine}, {10, ten}}) {
    const auto frame = pictures->next();
    ASSERT_TRUE(frame && *frame);
    EXPECT_EQ((*frame)->width, width);
    EXPECT_EQ((*frame)->height, 2);
    EXPECT_EQ((*frame)->time, PictureFrames::kPeriod * count++);
    const auto& image = dynamic_cast<const foxglove::CompressedImage&>(*(*frame)->image);
    EXPECT_EQ(image.data(), bytes);
    EXPECT_EQ(image.format(), width == 9 ? "jpeg" : "png");
  }
  EXPECT_FALSE(*pictures->next());
  EXPECT_DOUBLE_EQ(pictures->share(), 1);
}

TEST_F(PictureFramesTest, nameABrokenOneAndGoOn) {
  write("a.png", 4);
  std::ofstream(folder_ / "b.png") << "not a picture";
  write("c.png", 4);
  auto pictures = PictureFrames::open(folder_.path());
  ASSERT_TRUE(pictures);
  EXPECT_TRUE(pictures->next());
  const auto broken = pictures->next();
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().where.file, (folder_ / "b.png").string());
  EXPECT_TRUE(*pictures->next());
}

TEST_F(PictureFramesTest, needAPicture) {
  EXPECT_FALSE(isPictureFolder(folder_.path()));
  EXPECT_FALSE(PictureFrames::open(folder_.path()));
  write("a.png", 4);
  EXPECT_TRUE(isPictureFolder(folder_.path()));
  EXPECT_FALSE(isPictureFolder(folder_ / "a.png"));
}
