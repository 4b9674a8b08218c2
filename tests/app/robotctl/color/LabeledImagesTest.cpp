// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/color/LabeledImages.h"

#include <gmock/gmock.h>

#include "app/platforms/simulated/world/TrueClasses.h"
#include "foxglove/Image.pb.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/packages/Conversions.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;
using testing::ElementsAre;
using testing::HasSubstr;

class LabeledImagesTest : public testing::Test {
 protected:
  static foxglove::RawImage raw(const Image& image, int ms) {
    foxglove::RawImage message;
    robotlink::assign(message, image.view(), robotlink::Instant(std::chrono::milliseconds(ms)), "camera");
    return message;
  }
  static void add(LabeledImages& images, int ms, const std::string& robot = "red1") {
    Image classes(4, 2, PixelFormat::kMono8);
    classes.row(1)[3] = 7;
    images.add(robot, raw(Image(4, 2, PixelFormat::kYuyv), ms), raw(classes, ms));
  }
  LabeledImages make(std::chrono::milliseconds period) const {
    return LabeledImages::create(folder_ / "out", period).value();
  }
  std::vector<std::string> names(const char* part) const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out" / part))
      if (entry.path().extension() == ".png") all.push_back(entry.path().filename());
    std::ranges::sort(all);
    return all;
  }

  const TestFolder folder_;
};

TEST_F(LabeledImagesTest, anImageAndItsClassesHaveTheSameName) {
  auto images = make(std::chrono::milliseconds(0));
  add(images, 1200);
  EXPECT_EQ(images.written(), 1);
  EXPECT_TRUE(images.outcome());
  EXPECT_THAT(names("images"), ElementsAre("red1-001200.png"));
  EXPECT_THAT(names("labels"), ElementsAre("red1-001200.png"));
  const auto labels = logplayer::readPicture(folder_ / "out" / "labels" / "red1-001200.png");
  ASSERT_TRUE(labels) << labels.error().describe();
  EXPECT_EQ(labels->format, PixelFormat::kMono8);
  EXPECT_EQ(labels->row(1)[3], 7) << "the number itself";
  EXPECT_EQ(logplayer::readPicture(folder_ / "out" / "images" / "red1-001200.png")->width, 4);
}

TEST_F(LabeledImagesTest, thereIsOnePerRobotAndPeriod) {
  auto images = make(std::chrono::milliseconds(1000));
  for (const int ms : {0, 40, 1010, 1990, 2000, 2040}) add(images, ms);
  add(images, 40, "red2");
  EXPECT_THAT(names("images"),
              ElementsAre("red1-000000.png", "red1-001010.png", "red1-002000.png", "red2-000040.png"))
      << "at multiples of the period, although one was late";
}

TEST_F(LabeledImagesTest, withoutAPeriodAllAreWritten) {
  auto images = make(std::chrono::milliseconds(0));
  for (const int ms : {0, 40, 80}) add(images, ms);
  EXPECT_EQ(images.written(), 3);
}

TEST_F(LabeledImagesTest, theNumbersOfClassesAreNamedBesideThem) {
  make(std::chrono::milliseconds(0));
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out" / "labels"))
    text += robotlink::readFile(entry.path()).value_or("");
  for (const std::string& name : TrueClasses::classes().names()) EXPECT_THAT(text, HasSubstr(name));
}

TEST_F(LabeledImagesTest, afterAFailureNothingMoreIsWritten) {
  auto images = make(std::chrono::milliseconds(0));
  std::filesystem::remove_all(folder_ / "out" / "images");
  folder_.write("out/images", "a file where the folder has to be");
  add(images, 0);
  EXPECT_FALSE(images.outcome());
  std::filesystem::remove(folder_ / "out" / "images");
  add(images, 40);
  EXPECT_EQ(images.written(), 0);
  EXPECT_FALSE(images.outcome()) << "the first failure stays";
}

TEST_F(LabeledImagesTest, aFolderThatCannotBeMadeIsNamed) {
  folder_.write("taken", "no folder");
  const auto made = LabeledImages::create(folder_ / "taken", std::chrono::seconds(1));
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().describe(), HasSubstr("taken/images"));
  EXPECT_THAT(made.error().text, HasSubstr("cannot make this folder for labeled images"));
}

}  // namespace
}  // namespace app
