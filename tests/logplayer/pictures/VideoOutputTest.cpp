// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/VideoOutput.h"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "logplayer/pictures/VideoFrames.h"
#include "tests/TestFolder.h"

namespace logplayer {
namespace {

constexpr int kVideoWidth = 64, kVideoHeight = 48;

VideoOutput::Options optionsOf(double rate = 25) {
  VideoOutput::Options options;
  options.width = kVideoWidth;
  options.height = kVideoHeight;
  options.rate = rate;
  return options;
}

robotlink::Result<void> writeVideo(const std::filesystem::path& file, int frames,
                                   VideoOutput::Options options) {
  auto video = VideoOutput::create(file, options);
  if (!video) return tl::unexpected(video.error());
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kVideoWidth * kVideoHeight * 3));
  for (int i = 0; i < frames; ++i) {
    std::fill(pixels.begin(), pixels.end(), static_cast<std::uint8_t>(10 * i));
    if (auto done = video->write(pixels.data(), kVideoWidth * 3); !done) return done;
  }
  return video->finish();
}

int filesIn(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator all(folder);
  return static_cast<int>(std::distance(begin(all), end(all)));
}

class VideoOutputTest : public ::testing::TestWithParam<const char*> {
 protected:
  TestFolder folder_;
};

TEST_P(VideoOutputTest, framesAreReadBack) {
  const auto file = folder_.path() / (std::string("made") + GetParam());
  const auto done = writeVideo(file, 12, optionsOf());
  ASSERT_TRUE(done) << done.error().describe();
  EXPECT_TRUE(isVideo(file));
  auto read = VideoFrames::open(file);
  ASSERT_TRUE(read);
  int frames = 0;
  double last = 0;
  while (true) {
    const auto frame = read->next();
    ASSERT_TRUE(frame);
    if (!*frame) break;
    ++frames;
    last = robotlink::seconds((*frame)->time);
    EXPECT_EQ((*frame)->width, kVideoWidth);
  }
  EXPECT_EQ(frames, 12);
  EXPECT_NEAR(last, 11 / 25.0, 0.01);
  EXPECT_EQ(filesIn(folder_.path()), 1);
}

TEST_P(VideoOutputTest, nothingIsLeftWithoutFinish) {
  {
    auto video = VideoOutput::create(folder_.path() / (std::string("made") + GetParam()), optionsOf());
    ASSERT_TRUE(video);
    const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kVideoWidth * kVideoHeight * 3));
    ASSERT_TRUE(video->write(pixels.data(), kVideoWidth * 3));
  }
  EXPECT_EQ(filesIn(folder_.path()), 0);
}

TEST_P(VideoOutputTest, aFullDiskKeepsTheOldFile) {
  const auto file = folder_.path() / (std::string("made") + GetParam());
  std::ofstream(file) << "old";
  auto options = optionsOf();
  int looks = 0;
  options.freeSpace = [&looks](const auto&) { return ++looks < 3 ? VideoOutput::kMinFree : 0; };
  const auto done = writeVideo(file, 40, options);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().id, "file.full");
  EXPECT_EQ(filesIn(folder_.path()), 1);
  EXPECT_EQ(std::filesystem::file_size(file), 3U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, VideoOutputTest, ::testing::Values(".avi", ".mp4"),
                         [](const auto& kind) { return std::string(kind.param + 1); });

TEST(VideoOutputNames, anotherSuffixIsRefusedWithThoseThatWork) {
  TestFolder folder;
  const auto done = VideoOutput::create(folder.path() / "made.mkv", optionsOf());
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().text.find(".mp4"), std::string::npos) << done.error().text;
  EXPECT_NE(done.error().text.find("not in .mkv"), std::string::npos) << done.error().text;
}

TEST(VideoOutputNames, aMissingFolderIsReported) {
  TestFolder folder;
  const auto done = VideoOutput::create(folder.path() / "none" / "made.avi", optionsOf());
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().text.find("there is no folder"), std::string::npos) << done.error().text;
}

TEST(VideoOutputNames, sizesAndRatesHaveLimits) {
  TestFolder folder;
  EXPECT_FALSE(VideoOutput::create(folder.path() / "made.avi", optionsOf(0)));
  auto options = optionsOf();
  options.width = 4;
  EXPECT_FALSE(VideoOutput::create(folder.path() / "made.avi", options));
  EXPECT_EQ(VideoOutput::evenSize(641), 640);
}

}  // namespace
}  // namespace logplayer
