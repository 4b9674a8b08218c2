// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogAttachments.h"

#include <gmock/gmock.h>

#include <fstream>

#include "robotlink/base/AtomicFile.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using ::testing::HasSubstr;

class LogAttachmentsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    SampleLog{.frames = 20}.write(log());
    std::ofstream(folder_ / "note.txt") << "a note";
  }
  std::filesystem::path log() const { return folder_ / "a.mcap"; }

  TestFolder folder_;
};

}  // namespace

TEST_F(LogAttachmentsTest, aFileInCapitalsHasTheTypeOfOneInSmallLetters) {
  std::ofstream(folder_ / "PLAN.PNG") << "a picture";
  ASSERT_TRUE(attach(log(), folder_ / "PLAN.PNG", {}));
  const auto all = attachmentsOf(log());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 1U);
  EXPECT_EQ(all->front().mediaType, "image/png");
}

TEST_F(LogAttachmentsTest, aFileIsAttachedListedAndTakenOut) {
  ASSERT_TRUE(attach(log(), folder_ / "note.txt", {}));
  ASSERT_TRUE(attach(log(), folder_ / "note.txt", {.name = "other", .mediaType = "text/x-other"}));
  const auto all = attachmentsOf(log());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ(all->front().name, "note.txt");
  EXPECT_EQ(all->front().mediaType, "text/plain");
  EXPECT_EQ(all->front().bytes, 6U);
  EXPECT_EQ(all->back().mediaType, "text/x-other");
  ASSERT_TRUE(extractAttachment(log(), "other", folder_ / "out.txt", false));
  EXPECT_EQ(robotlink::readFile(folder_ / "out.txt"), "a note");
  EXPECT_FALSE(extractAttachment(log(), "other", folder_ / "out.txt", false));
  EXPECT_FALSE(extractAttachment(log(), "none", folder_ / "none.txt", false));
  EXPECT_EQ(folder_.contents(), "a.mcap note.txt out.txt");
}

TEST_F(LogAttachmentsTest, nothingIsAddedTwiceOrToALogThatWasNotClosed) {
  ASSERT_TRUE(attach(log(), folder_ / "note.txt", {}));
  const auto twice = attach(log(), folder_ / "note.txt", {});
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().text, HasSubstr("there is an attachment note.txt in it already"));
  SampleLog{.frames = 20, .close = false}.write(folder_ / "open.mcap");
  const auto open = attach(folder_ / "open.mcap", folder_ / "note.txt", {});
  ASSERT_FALSE(open);
  EXPECT_THAT(open.error().text, HasSubstr("robotctl log repair"));
}

}  // namespace logplayer
