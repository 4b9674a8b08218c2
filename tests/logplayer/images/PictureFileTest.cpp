// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/images/PictureFile.h"

#include <gmock/gmock.h>

#include "logplayer/images/ImageCoding.h"
#include "tests/TestFolder.h"

namespace logplayer {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;
using testing::ElementsAre;
using testing::HasSubstr;

/// The bytes of a .yuyv picture whose first pixels have these.
std::string yuyvBytes(const std::string& first) {
  std::string bytes(std::size_t{320} * 240 * 4, '\x80');
  bytes.replace(0, first.size(), first);
  return bytes;
}

class PictureFileTest : public testing::Test {
 protected:
  std::string errorOf(const std::filesystem::path& file) const {
    const auto image = readPicture(file);
    EXPECT_FALSE(image) << file;
    return image ? std::string() : image.error().describe();
  }

  const TestFolder folder_;
};

TEST_F(PictureFileTest, aPictureIsKnownByItsEndingInAnyCase) {
  for (const char* name : {"a.png", "a.JPG", "b/a.jpeg", "a.b.yuyv", "a.Png"})
    EXPECT_TRUE(isPictureFile(name)) << name;
  for (const char* name : {"a.txt", "png", "a.png.txt", "a.jpg2", "", "a."})
    EXPECT_FALSE(isPictureFile(name)) << name;
}

TEST_F(PictureFileTest, squarePixelsHaveTheSecondLumaOfEachPairAndTheMeanChroma) {
  // Two pairs: Y0 Cb Y1 Cr.
  const auto file = folder_.write("a.yuyv", yuyvBytes({10, 100, 20, 50, 30, 103, 40, 60}));
  const auto image = readPicture(file);
  ASSERT_TRUE(image) << image.error().describe();
  EXPECT_EQ(image->width, 320);
  EXPECT_EQ(image->height, 240);
  EXPECT_EQ(image->format, PixelFormat::kYuyv);
  EXPECT_EQ(image->data[0], 20);
  EXPECT_EQ(image->data[1], 102) << "the mean is rounded up";
  EXPECT_EQ(image->data[2], 40);
  EXPECT_EQ(image->data[3], 55);
  EXPECT_EQ(image->data.back(), 0x80);
}

TEST_F(PictureFileTest, theMeanOfBrightChromaDoesNotOverflow) {
  const auto file = folder_.write("a.yuyv", yuyvBytes(std::string(8, '\xFF')));
  const auto image = readPicture(file);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->data[1], 255);
}

TEST_F(PictureFileTest, allPixelsAreTwiceAsMany) {
  const std::string bytes = yuyvBytes({1, 2, 3, 4});
  const auto image = readPicture(folder_.write("a.yuyv", bytes), YuyvPixels::kAll);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 640);
  EXPECT_EQ(image->height, 240);
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), image->data.begin(), image->data.end(),
                         [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
}

TEST_F(PictureFileTest, aYuyvFileOfAnotherSizeSaysWhichOneItNeeds) {
  EXPECT_THAT(errorOf(folder_.write("small.yuyv", "1234")),
              testing::AllOf(HasSubstr("small.yuyv: "), HasSubstr("307200 in all; this file has 4")));
  EXPECT_THAT(errorOf(folder_.write("large.yuyv", yuyvBytes("") + "x")), HasSubstr("this file has 307201"));
}

TEST_F(PictureFileTest, whatCannotBeDecodedOrFoundIsNamed) {
  EXPECT_THAT(errorOf(folder_.write("broken.png", "no picture")), HasSubstr("broken.png"));
  EXPECT_THAT(errorOf(folder_.write("empty.jpg", "")), HasSubstr("empty.jpg"));
  EXPECT_THAT(errorOf(folder_ / "missing.png"), HasSubstr("missing.png"));
}

TEST_F(PictureFileTest, picturesOfAFolderAreSortedAndOthersStayInTheirOrder) {
  for (const char* name : {"in/b.png", "in/a.jpg", "in/c.txt", "in/deep/d.png", "z.txt", "y.png"})
    folder_.write(name, "");
  std::filesystem::create_directory(folder_ / "in/folder.png");
  const auto files = pictureFiles({folder_ / "z.txt", folder_ / "in", folder_ / "y.png"});
  ASSERT_TRUE(files) << files.error().describe();
  std::vector<std::string> names;
  for (const auto& file : *files) names.push_back(file.filename());
  EXPECT_THAT(names, ElementsAre("z.txt", "a.jpg", "b.png", "y.png"))
      << "what is named is taken whatever it is; folders in folders are not looked into";
}

TEST_F(PictureFileTest, whereThereIsNoPictureTheFolderIsNamed) {
  folder_.write("a.txt", "");
  const auto files = pictureFiles({folder_.path()});
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().describe(), HasSubstr(folder_.path().string() + ": there are no pictures here"));
  EXPECT_FALSE(pictureFiles({}));
}

}  // namespace
}  // namespace logplayer
