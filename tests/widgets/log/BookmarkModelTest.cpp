// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/BookmarkModel.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using robotlink::fromSeconds;
using robotlink::Instant;

BookmarkRow bookmarkRow(std::uint64_t id, double from, double to, const char* text) {
  BookmarkRow row;
  row.log = "/logs/game.mcap";
  row.offset = fromSeconds(100);
  row.bookmark.id = id;
  row.bookmark.from = Instant(fromSeconds(from));
  row.bookmark.to = Instant(fromSeconds(to));
  row.bookmark.text = text;
  return row;
}

class BookmarkModelTest : public testing::Test {
 protected:
  BookmarkModelTest() {
    QObject::connect(&model, &QAbstractItemModel::modelReset, &model, [this] { ++resets; });
    QObject::connect(&model, &QAbstractItemModel::dataChanged, &model, [this] { ++changes; });
    model.setRows({bookmarkRow(1, 2, 2, "kick"), bookmarkRow(2, 5, 7.5, "goal")}, origin);
  }
  std::string text(int row, BookmarkModel::Column column) const {
    return model.data(model.index(row, column), Qt::DisplayRole).toString().toStdString();
  }

  const Instant origin{fromSeconds(101)};
  BookmarkModel model;
  int resets = 0, changes = 0;
};

TEST_F(BookmarkModelTest, showsTimesOfTheTimelineFromItsOrigin) {
  EXPECT_EQ(text(0, BookmarkModel::kTime), "1.000");
  EXPECT_EQ(text(0, BookmarkModel::kLength), "–") << "an instant has no length";
  EXPECT_EQ(text(1, BookmarkModel::kLength), "2.500");
  EXPECT_EQ(text(1, BookmarkModel::kLog), "game.mcap");
  EXPECT_EQ(model.data(model.index(1, BookmarkModel::kTime), BookmarkModel::kSortRole).toLongLong(),
            105'000'000'000);
  EXPECT_EQ(model.headerData(BookmarkModel::kText, Qt::Horizontal, Qt::DisplayRole).toString().toStdString(),
            "Bookmark");
  EXPECT_FALSE(model.headerData(BookmarkModel::kColumns, Qt::Horizontal, Qt::DisplayRole).isValid());
}

TEST_F(BookmarkModelTest, rowsStayUnlessBookmarksCameOrWent) {
  model.setRows({bookmarkRow(1, 2, 2, "kick"), bookmarkRow(2, 5, 7.5, "goal")}, origin);
  EXPECT_EQ(changes, 0);
  model.setRows({bookmarkRow(1, 3, 3, "a kick"), bookmarkRow(2, 5, 7.5, "goal")}, origin);
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(resets, 1);
  EXPECT_EQ(text(0, BookmarkModel::kText), "a kick");
  model.setRows({bookmarkRow(2, 5, 7.5, "goal")}, origin);
  EXPECT_EQ(resets, 2);
  EXPECT_EQ(model.rowCount(), 1);
}

TEST_F(BookmarkModelTest, anEditIsASignalWithTheWholeBookmark) {
  std::vector<logplayer::Bookmark> wanted;
  QObject::connect(
      &model, &BookmarkModel::changeWanted, &model,
      [&wanted](const std::string&, const logplayer::Bookmark& bookmark) { wanted.push_back(bookmark); });
  EXPECT_TRUE(model.flags(model.index(1, BookmarkModel::kText)).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(model.flags(model.index(1, BookmarkModel::kTime)).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(model.setData(model.index(1, BookmarkModel::kText), QStringLiteral("goal"), Qt::EditRole));
  EXPECT_TRUE(model.setData(model.index(1, BookmarkModel::kText), QStringLiteral("own goal"), Qt::EditRole));
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted[0].id, 2U);
  EXPECT_EQ(wanted[0].text, "own goal");
  EXPECT_EQ(text(1, BookmarkModel::kText), "goal") << "its owner changes it";
}

}  // namespace
}  // namespace widgets
