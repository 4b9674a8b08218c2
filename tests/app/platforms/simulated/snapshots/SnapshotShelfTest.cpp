// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/snapshots/SnapshotShelf.h"

#include <gmock/gmock.h>

namespace app {
namespace {

using testing::HasSubstr;

TEST(SnapshotShelf, whatWasKeptIsFoundByItsName) {
  SnapshotShelf shelf;
  EXPECT_THAT(shelf.find("a").error().text, HasSubstr("none was taken"));
  ASSERT_TRUE(shelf.keep("a", {}));
  ASSERT_TRUE(shelf.keep("b", {}));
  EXPECT_TRUE(shelf.find("a"));
  const auto unknown = shelf.find("c");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().id, "snapshot.unknown");
  EXPECT_THAT(unknown.error().text, HasSubstr("there are a, b"));
}

TEST(SnapshotShelf, oneOrAllAreForgotten) {
  SnapshotShelf shelf;
  for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(shelf.keep(name, {}));
  ASSERT_TRUE(shelf.forget("b"));
  EXPECT_FALSE(shelf.find("b"));
  EXPECT_EQ(shelf.forget("b").error().id, "snapshot.unknown");
  EXPECT_EQ(shelf.all().size(), 2U);
  ASSERT_TRUE(shelf.forget(""));
  EXPECT_TRUE(shelf.all().empty());
  EXPECT_TRUE(shelf.forget("")) << "nothing is left to be forgotten";
}

TEST(SnapshotShelf, aFurtherOneIsRefusedAndNoneIsLost) {
  SnapshotShelf shelf;
  for (std::size_t i = 0; i < SnapshotShelf::kMaxSnapshots; ++i)
    ASSERT_TRUE(shelf.keep("number " + std::to_string(i), {}));
  const auto refused = shelf.keep("further", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "snapshot.room");
  EXPECT_EQ(shelf.all().size(), SnapshotShelf::kMaxSnapshots);
  // One of the same name takes the place of the former one.
  EXPECT_TRUE(shelf.keep("number 7", {}));
  ASSERT_TRUE(shelf.forget("number 7"));
  EXPECT_TRUE(shelf.keep("further", {}));
}

}  // namespace
}  // namespace app
