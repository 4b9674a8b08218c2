// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/LinkLimits.h"

#include <gmock/gmock.h>

#include "tests/TestFolder.h"

namespace app {
namespace {

using Images = LinkLimits::Images;

constexpr char kUrl[] = "ws://10.0.0.7:8765", kLongerUrl[] = "ws://10.0.0.7:87650";
const LinkLimits kNarrow{.bytesPerSecond = 3e5, .images = Images::kPng, .imagesPerSecond = 5};

TEST(LinkLimits, waysToSendImagesHaveNames) {
  for (const Images images : {Images::kAutomatic, Images::kRaw, Images::kJpeg, Images::kPng})
    EXPECT_EQ(imagesNamed(nameOf(images)), images) << nameOf(images);
  EXPECT_STREQ(nameOf(Images::kJpeg), "jpeg");
  for (const char* name : {"", "JPEG", "jpg", "none"}) EXPECT_EQ(imagesNamed(name), std::nullopt) << name;
}

TEST(LinkLimits, areSaidInWordsOnlyAsFarAsThereAreSome) {
  EXPECT_EQ(inWords({}), "");
  EXPECT_EQ(inWords(kNarrow), ", at most 300 kB/s, images as PNG, 5 images a second");
  EXPECT_EQ(inWords({.bytesPerSecond = 1e6}), ", at most 1.0 MB/s");
  EXPECT_EQ(inWords({.bytesPerSecond = 12.34e6}), ", at most 12.3 MB/s");
  EXPECT_EQ(inWords({.images = Images::kJpeg}), ", images as JPEG");
  EXPECT_EQ(inWords({.images = Images::kRaw, .imagesPerSecond = 0.5}), ", images raw, 0.5 images a second");
}

class LinkLimitsMemoryTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "links.json"; }
  /// What a later run of the workbench finds.
  LinkLimits later(const std::string& url = kUrl) const { return LinkLimitsMemory(file()).limits(url); }

  const TestFolder folder_;
};

TEST_F(LinkLimitsMemoryTest, whatWasChosenHoldsInTheNextRun) {
  LinkLimitsMemory memory(file());
  memory.choose(kUrl, kNarrow);
  EXPECT_EQ(memory.limits(kUrl), kNarrow);
  EXPECT_EQ(later(), LinkLimits()) << "not before it is saved";
  ASSERT_TRUE(memory.save());
  EXPECT_EQ(later(), kNarrow);
  EXPECT_EQ(later(kLongerUrl), LinkLimits());
}

TEST_F(LinkLimitsMemoryTest, nothingIsWrittenUnlessSomethingWasChosen) {
  LinkLimitsMemory memory(file());
  memory.choose(kUrl, {});
  EXPECT_EQ(memory.version(), 0U);
  EXPECT_TRUE(memory.save());
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(LinkLimitsMemoryTest, theVersionSaysWhetherSomethingHasChanged) {
  LinkLimitsMemory memory(file());
  memory.choose(kUrl, kNarrow);
  EXPECT_EQ(memory.version(), 1U);
  memory.choose(kUrl, kNarrow);
  EXPECT_EQ(memory.version(), 1U) << "the same again";
  memory.choose(kLongerUrl, kNarrow);
  EXPECT_EQ(memory.version(), 2U);
}

TEST_F(LinkLimitsMemoryTest, limitsThatAreTakenBackAreThoseOfOneUrl) {
  LinkLimitsMemory memory(file());
  memory.choose(kUrl, kNarrow);
  memory.choose(kLongerUrl, kNarrow);
  memory.choose(kUrl, {});
  ASSERT_TRUE(memory.save());
  EXPECT_EQ(later(), LinkLimits());
  EXPECT_EQ(later(kLongerUrl), kNarrow);
}

TEST_F(LinkLimitsMemoryTest, aFileThatCannotBeReadLimitsNothingAndIsKept) {
  folder_.write("links.json", "{rubbish");
  EXPECT_EQ(later(), LinkLimits());
  EXPECT_EQ(folder_.contents(), "links.json.broken");
}

TEST_F(LinkLimitsMemoryTest, whatMakesNoSenseInAFileLimitsNothing) {
  folder_.write("links.json", R"({"format": "robotcontrol-settings", "version": 1, "settings": {
      "ws://10.0.0.7:8765/bytes-per-second": -5, "ws://10.0.0.7:8765/images": "gif",
      "ws://10.0.0.7:8765/images-per-second": "many"}})");
  EXPECT_EQ(later(), LinkLimits());
  EXPECT_EQ(folder_.contents(), "links.json") << "it could be read";
}

TEST_F(LinkLimitsMemoryTest, aFileThatCannotBeWrittenIsReportedOnceForEachChange) {
  folder_.write("taken", "no folder");
  LinkLimitsMemory memory(folder_ / "taken" / "links.json");
  memory.choose(kUrl, kNarrow);
  EXPECT_FALSE(memory.save());
  EXPECT_TRUE(memory.save()) << "it was said";
  memory.choose(kUrl, {.bytesPerSecond = 1});
  EXPECT_FALSE(memory.save());
}

}  // namespace
}  // namespace app
