// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bookmarks/BookmarkStorage.h"

#include <gmock/gmock.h>

#include "foxglove/Event.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Schema.h"
#include "tests/TestFolder.h"

namespace logplayer {
namespace {

using robotlink::Duration;
using robotlink::Instant;
using testing::ElementsAre;
using testing::IsEmpty;

Bookmark bookmark(std::uint64_t id, std::int64_t at, const std::string& text = "") {
  return {id, Instant(Duration(at)), Instant(Duration(at)), text};
}

TEST(BookmarkStorage, theDifferenceTurnsOneListIntoTheOther) {
  const std::vector<Bookmark> from{bookmark(1, 10, "stays"), bookmark(2, 20, "moves"),
                                   bookmark(3, 30, "goes")};
  const std::vector<Bookmark> to{bookmark(2, 5, "moves"), bookmark(1, 10, "stays"), bookmark(4, 40, "comes")};
  const BookmarkChanges changes = difference(from, to);
  EXPECT_EQ(changes.size(), 3U) << "what stays is no change";
  EXPECT_EQ(changed(from, changes), to) << "sorted by time";
  EXPECT_THAT(changed(to, difference(to, {})), IsEmpty());
  EXPECT_THAT(difference(to, to), IsEmpty());
}

TEST(BookmarkStorage, theFileBesideTheLogTakesPrecedence) {
  StoredBookmarks stored;
  stored.inLog = {{1, bookmark(1, 10, "in the log")}, {2, bookmark(2, 20)}, {3, std::nullopt}};
  stored.beside = {{1, bookmark(1, 30, "beside it")}, {2, std::nullopt}};
  EXPECT_THAT(stored.bookmarks(), ElementsAre(bookmark(1, 30, "beside it")));
}

TEST(BookmarkStorage, whatIsWrittenBesideALogIsReadAgain) {
  const TestFolder folder;
  const auto log = folder / "a.mcap";
  const BookmarkChanges changes{{7, bookmark(7, -5, "before 1970, \"quoted\"")}, {8, std::nullopt}};
  ASSERT_TRUE(writeBookmarksBeside(log, changes));
  EXPECT_EQ(readBookmarksBeside(log), changes);
  ASSERT_TRUE(writeBookmarksBeside(log, {}));
  EXPECT_THAT(folder.contents(), IsEmpty()) << "no file for nothing";
}

/// Writes events as another program does: without ids.
void writeForeignEvents(mcap::Writer& log, const std::vector<foxglove::Event>& events) {
  const auto* type = foxglove::Event::descriptor();
  const auto schema = log.addSchema(type->full_name(), "protobuf", robotlink::schemaOf(*type)).value();
  const auto channel = log.addChannel("bookmarks", schema, "protobuf", {}).value();
  for (const foxglove::Event& event : events) {
    const std::string data = event.SerializeAsString();
    const mcap::Bytes bytes(reinterpret_cast<const std::uint8_t*>(data.data()), data.size());
    const Instant time = robotlink::instant(event.start_time());
    ASSERT_TRUE(log.write({channel, 0, time, time, bytes}));
  }
}

TEST(BookmarkStorage, eventsOfOtherProgramsHaveIdsAndTexts) {
  const TestFolder folder;
  const auto file = folder / "foreign.mcap";
  foxglove::Event first, second;
  robotlink::assign(*first.mutable_start_time(), Instant(Duration(50)));
  robotlink::assign(*first.mutable_end_time(), Instant(Duration(40)));
  for (const char* key : {"what", "where"}) {
    auto& pair = *first.add_metadata();
    pair.set_key(key);
    pair.set_value("goal");
  }
  robotlink::assign(*second.mutable_start_time(), Instant(Duration(60)));
  {
    auto log = mcap::Writer::create(file, {}).value();
    writeForeignEvents(*log, {first, second});
    ASSERT_TRUE(log->close());
  }
  const auto stored = readStoredBookmarks(file, {});
  ASSERT_TRUE(stored) << stored.error().describe();
  const auto bookmarks = stored->bookmarks();
  ASSERT_EQ(bookmarks.size(), 2U);
  EXPECT_EQ(bookmarks[0].text, "what: goal, where: goal");
  EXPECT_EQ(bookmarks[0].to, bookmarks[0].from) << "an end before the begin is none";
  EXPECT_NE(bookmarks[0].id, bookmarks[1].id);
  EXPECT_EQ(readStoredBookmarks(file, {})->bookmarks(), bookmarks) << "the ids are the same each time";
}

}  // namespace
}  // namespace logplayer
