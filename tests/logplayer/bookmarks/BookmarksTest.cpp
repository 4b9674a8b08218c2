// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bookmarks/Bookmarks.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "logplayer/bookmarks/BookmarkStorage.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;

class BookmarksTest : public testing::Test {
 protected:
  void SetUp() override { SampleLog{}.write(log()); }
  std::filesystem::path log() const { return folder_ / "a.mcap"; }
  Bookmarks opened() const {
    auto bookmarks = Bookmarks::open(log());
    EXPECT_TRUE(bookmarks) << bookmarks.error().describe();
    return std::move(*bookmarks);
  }
  std::string texts(const Bookmarks& bookmarks) const {
    std::string all;
    for (const auto& bookmark : bookmarks.all()) all += (all.empty() ? "" : " ") + bookmark.text;
    return all;
  }
  std::string savedTexts() const { return texts(opened()); }
  void expectLogIsWhole() const {
    auto reader = mcap::Reader::open(log(), {});
    ASSERT_TRUE(reader);
    EXPECT_TRUE((*reader)->complete());
    EXPECT_TRUE((*reader)->verify());
    EXPECT_TRUE((*reader)->damage().empty());
  }

  /// Whether `work` said yes there. For what a process cannot take back.
  static bool inAnotherProcess(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work() ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  TestFolder folder_;
};

TEST_F(BookmarksTest, aLogWithoutAnyHasNone) {
  const Bookmarks bookmarks = opened();
  EXPECT_TRUE(bookmarks.all().empty());
  EXPECT_FALSE(bookmarks.changed());
  EXPECT_FALSE(bookmarks.canUndo());
  EXPECT_FALSE(bookmarks.canRedo());
  EXPECT_EQ(bookmarks.savedIn(), log());
}

TEST_F(BookmarksTest, theyAreKeptByTimeAndFoundByTheirIds) {
  Bookmarks bookmarks = opened();
  const auto late = bookmarks.add(Instant(3s), Instant(2s), "late");
  const auto early = bookmarks.add(Instant(1s), Instant(1s), "early");
  EXPECT_EQ(texts(bookmarks), "early late");
  ASSERT_TRUE(bookmarks.find(late));
  EXPECT_EQ(*bookmarks.find(late), (Bookmark{late, Instant(2s), Instant(3s), "late"}))
      << "its ends are in order";
  EXPECT_NE(early, late);
  EXPECT_EQ(bookmarks.find(12345), nullptr);
  bookmarks.change({late, Instant(500ms), Instant(0s), "first"});
  EXPECT_EQ(texts(bookmarks), "first early");
  bookmarks.change({12345, Instant(0s), Instant(0s), "nobody's"});
  bookmarks.remove(early);
  EXPECT_EQ(texts(bookmarks), "first");
}

TEST_F(BookmarksTest, everythingCanBeUndoneAndRedone) {
  Bookmarks bookmarks = opened();
  std::vector<std::string> states{texts(bookmarks)};
  std::vector<std::uint64_t> ids;
  for (int i = 0; i < 200; ++i) {
    ids.push_back(bookmarks.add(Instant(i * 1ms), Instant(i * 1ms), std::to_string(i)));
    states.push_back(texts(bookmarks));
  }
  for (int i = 0; i < 200; i += 3) {
    bookmarks.remove(ids[static_cast<std::size_t>(i)]);
    states.push_back(texts(bookmarks));
  }
  const std::size_t steps = states.size() - 1;
  for (std::size_t i = steps; i-- > 0;) {
    ASSERT_TRUE(bookmarks.canUndo());
    bookmarks.undo();
    ASSERT_EQ(texts(bookmarks), states[i]);
  }
  EXPECT_FALSE(bookmarks.canUndo());
  bookmarks.undo();
  EXPECT_EQ(texts(bookmarks), states.front());
  for (std::size_t i = 1; i <= steps; ++i) {
    bookmarks.redo();
    ASSERT_EQ(texts(bookmarks), states[i]);
  }
  EXPECT_FALSE(bookmarks.canRedo());
  bookmarks.undo();
  bookmarks.add(Instant(1s), Instant(1s), "new");
  EXPECT_FALSE(bookmarks.canRedo()) << "another change takes the place of what was undone";
}

TEST_F(BookmarksTest, aChangeThatChangesNothingIsNoStep) {
  Bookmarks bookmarks = opened();
  const auto id = bookmarks.add(Instant(1s), Instant(1s), "a");
  bookmarks.change(*bookmarks.find(id));
  bookmarks.remove(id + 1);
  bookmarks.undo();
  EXPECT_FALSE(bookmarks.canUndo());
}

TEST_F(BookmarksTest, savingAppendsToTheLogWithoutRewritingIt) {
  const auto before = robotlink::readFile(log());
  const auto chunksEnd = [&] {
    const auto reader = mcap::Reader::open(log(), {});
    std::uint64_t end = 0;
    for (const auto& chunk : (*reader)->chunks()) end = std::max(end, chunk.offset + chunk.length);
    return end;
  }();
  Bookmarks bookmarks = opened();
  bookmarks.add(Instant(1s), Instant(1500ms), "here, \"quoted\"");
  EXPECT_TRUE(bookmarks.changed());
  ASSERT_TRUE(bookmarks.save());
  EXPECT_FALSE(bookmarks.changed());
  const auto after = robotlink::readFile(log());
  EXPECT_EQ(before->substr(0, chunksEnd), after->substr(0, chunksEnd));
  EXPECT_EQ(opened().all(), bookmarks.all());
  EXPECT_EQ(folder_.contents(), "a.mcap");
  expectLogIsWhole();
}

TEST_F(BookmarksTest, theLastWithAnIdCountsAndRemovedOnesStayRemoved) {
  Bookmarks bookmarks = opened();
  const auto kept = bookmarks.add(Instant(3s), Instant(3s), "kept");
  const auto removed = bookmarks.add(Instant(2s), Instant(2s), "removed");
  ASSERT_TRUE(bookmarks.save());
  bookmarks.change({kept, Instant(1s), Instant(1s), "moved to an earlier time"});
  bookmarks.remove(removed);
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(savedTexts(), "moved to an earlier time");
  bookmarks.undo();
  EXPECT_TRUE(bookmarks.changed());
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(savedTexts(), "moved to an earlier time removed") << "undone after saving, and saved";
  expectLogIsWhole();
}

TEST_F(BookmarksTest, savingWithoutChangesTouchesNothing) {
  const auto before = robotlink::readFile(log());
  Bookmarks bookmarks = opened();
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(robotlink::readFile(log()), before);
  EXPECT_EQ(folder_.contents(), "a.mcap");
}

TEST_F(BookmarksTest, aReadOnlyLogGetsAFileBesideIt) {
  using std::filesystem::perms;
  std::filesystem::permissions(log(), perms::owner_read | perms::group_read | perms::others_read);
  std::filesystem::permissions(folder_.path(), perms::all);
  const auto before = robotlink::readFile(log());
  EXPECT_TRUE(inAnotherProcess([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) return false;  // root may write everywhere
    Bookmarks bookmarks = opened();
    const bool beside = bookmarks.savedIn() == fileBeside(log());
    bookmarks.add(Instant(1s), Instant(1s), "a");
    return beside && bookmarks.save();
  }));
  EXPECT_EQ(folder_.contents(), "a.mcap a.mcap.bookmarks.json");
  EXPECT_EQ(robotlink::readFile(log()), before);
  EXPECT_EQ(savedTexts(), "a");
}

TEST_F(BookmarksTest, ifTheDiskIsFullTheLogKeepsItsEndAndTheyAreSavedBesideIt) {
  const auto before = robotlink::readFile(log());
  EXPECT_TRUE(inAnotherProcess([&] {
    Bookmarks bookmarks = opened();
    for (int i = 0; i < 100; ++i) bookmarks.add(Instant(1s), Instant(1s), std::to_string(i));
    // Files can become hardly larger than the log is.
    const rlimit limit{before->size() + 100, before->size() + 100};
    std::signal(SIGXFSZ, SIG_IGN);
    return ::setrlimit(RLIMIT_FSIZE, &limit) == 0 && bookmarks.save() &&
           bookmarks.savedIn() == fileBeside(log());
  }));
  EXPECT_EQ(robotlink::readFile(log()), before);
  EXPECT_EQ(opened().all().size(), 100U);
  expectLogIsWhole();
}

TEST_F(BookmarksTest, aLogWithoutItsSummaryGetsAFileBesideItUntilItIsWhole) {
  std::filesystem::remove(log());
  SampleLog{.close = false}.write(log());
  Bookmarks bookmarks = opened();
  EXPECT_EQ(bookmarks.savedIn(), fileBeside(log()));
  const auto a = bookmarks.add(Instant(1s), Instant(1s), "a");
  bookmarks.add(Instant(2s), Instant(2s), "b");
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(savedTexts(), "a b");
  bookmarks.remove(a);
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(savedTexts(), "b");
  std::filesystem::remove(log());
  SampleLog{}.write(log());
  Bookmarks later = opened();
  EXPECT_EQ(texts(later), "b");
  EXPECT_EQ(later.savedIn(), log());
  later.add(Instant(3s), Instant(3s), "c");
  ASSERT_TRUE(later.save());
  EXPECT_EQ(folder_.contents(), "a.mcap") << "what was beside it is in it now";
  EXPECT_EQ(savedTexts(), "b c");
}

TEST_F(BookmarksTest, whatSomebodyElseSavedMeanwhileIsKept) {
  Bookmarks mine = opened();
  const auto both = mine.add(Instant(5s), Instant(5s), "both");
  ASSERT_TRUE(mine.save());
  Bookmarks theirs = opened();
  theirs.add(Instant(1s), Instant(1s), "theirs");
  theirs.change({both, Instant(5s), Instant(5s), "changed-by-them"});
  ASSERT_TRUE(theirs.save());
  mine.add(Instant(2s), Instant(2s), "mine");
  ASSERT_TRUE(mine.save());
  EXPECT_EQ(texts(mine), "theirs mine changed-by-them");
  EXPECT_EQ(savedTexts(), "theirs mine changed-by-them");
  mine.undo();
  ASSERT_TRUE(mine.save());
  EXPECT_EQ(savedTexts(), "theirs changed-by-them") << "undoing takes back what was done here alone";
  expectLogIsWhole();
}

TEST_F(BookmarksTest, ofABookmarkThatBothChangedTheOneSavedLastCounts) {
  Bookmarks mine = opened();
  const auto id = mine.add(Instant(5s), Instant(5s), "both");
  ASSERT_TRUE(mine.save());
  Bookmarks theirs = opened();
  theirs.remove(id);
  ASSERT_TRUE(theirs.save());
  mine.change({id, Instant(5s), Instant(5s), "mine"});
  ASSERT_TRUE(mine.save());
  EXPECT_EQ(savedTexts(), "mine");
}

TEST_F(BookmarksTest, aLogThatSomebodyIsWritingToIsLeftAlone) {
  Bookmarks bookmarks = opened();
  bookmarks.add(Instant(1s), Instant(1s), "a");
  const int other = ::open(log().c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  const auto refused = bookmarks.save();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "bookmarks.locked");
  EXPECT_TRUE(bookmarks.changed());
  ::close(other);
  EXPECT_TRUE(bookmarks.save());
  EXPECT_EQ(savedTexts(), "a");
}

TEST_F(BookmarksTest, aLogThatIsGoneIsAnError) {
  Bookmarks bookmarks = opened();
  bookmarks.add(Instant(1s), Instant(1s), "a");
  std::filesystem::remove(log());
  EXPECT_FALSE(bookmarks.save());
  EXPECT_TRUE(bookmarks.changed());
  EXPECT_FALSE(Bookmarks::open(log()));
}

TEST_F(BookmarksTest, aBrokenFileBesideTheLogIsReportedAndKeptAside) {
  std::ofstream(fileBeside(log()))
      << "{\"format\": \"robotcontrol-bookmarks\", \"version\": 1, \"bookmarks\": ";
  Bookmarks bookmarks = opened();
  ASSERT_TRUE(bookmarks.problem());
  bookmarks.add(Instant(1s), Instant(1s), "a");
  ASSERT_TRUE(bookmarks.save());
  EXPECT_EQ(folder_.contents(), "a.mcap a.mcap.bookmarks.json.broken");
  EXPECT_EQ(savedTexts(), "a");
}

TEST_F(BookmarksTest, aValueOfAnotherTypeBesideTheLogIsReportedInWords) {
  const auto problemWith = [this](const std::string& entry) {
    std::ofstream(fileBeside(log()), std::ios::trunc)
        << R"({"format": "robotcontrol-bookmarks", "version": 1, "bookmarks": {"entries": )" << entry << "}}";
    const auto read = readBookmarksBeside(log());
    return read ? std::string() : read.error().text;
  };
  EXPECT_EQ(problemWith(R"([{"id": 1, "from_ns": 5, "to_ns": 9, "text": "a"}])"), "");
  for (const char* wrong : {"7", "[7]", R"([{"id": -1, "from_ns": 5, "to_ns": 9, "text": "a"}])",
                            R"([{"id": 1.5, "from_ns": 5, "to_ns": 9, "text": "a"}])",
                            R"([{"id": 1, "from_ns": 1e300, "to_ns": 9, "text": "a"}])",
                            R"([{"id": 1, "from_ns": 5, "to_ns": 9223372036854775807, "text": "a"}])",
                            R"([{"id": 1, "from_ns": 5, "to_ns": 9, "text": 7}])",
                            R"([{"id": 1, "removed": "yes"}])", R"([{"id": 1, "from_ns": 1e999}])"}) {
    const std::string problem = problemWith(wrong);
    EXPECT_NE(problem, "") << wrong;
    EXPECT_EQ(problem.find("exception"), std::string::npos) << problem;
  }
}

TEST_F(BookmarksTest, aFileBesideTheLogOfANewerProgramIsNotOverwritten) {
  const std::string newer = "{\"format\": \"robotcontrol-bookmarks\", \"version\": 99, \"bookmarks\": {}}";
  std::ofstream(fileBeside(log())) << newer;
  Bookmarks bookmarks = opened();
  ASSERT_TRUE(bookmarks.problem());
  bookmarks.add(Instant(1s), Instant(1s), "a");
  EXPECT_FALSE(bookmarks.save());
  EXPECT_EQ(robotlink::readFile(fileBeside(log())), newer);
}

TEST_F(BookmarksTest, whoeverIsKilledWhileSavingLeavesALogThatCanBeRead) {
  for (int round = 0; round < 12; ++round) {
    std::filesystem::remove(log());
    std::filesystem::remove(fileBeside(log()));
    SampleLog{.frames = 30}.write(log());
    int saved[2] = {};
    ASSERT_EQ(::pipe(saved), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Bookmarks bookmarks = opened();
      for (int i = 0;; ++i) {
        bookmarks.add(Instant(i * 1ms), Instant(i * 1ms), std::to_string(i));
        if (!bookmarks.save() || ::write(saved[1], "s", 1) != 1) ::_exit(1);
      }
    }
    ::close(saved[1]);
    char byte = 0;
    for (int i = 0; i < round; ++i) EXPECT_EQ(::read(saved[0], &byte, 1), 1);
    ::kill(child, SIGKILL);  // somewhere in the next one
    ::close(saved[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "saving failed";
    const auto reader = mcap::Reader::open(log(), {});
    ASSERT_TRUE(reader) << reader.error().describe();
    std::uint64_t balls = 0;
    for (const auto& [id, channel] : (*reader)->channels()) {
      if (channel.topic == "red1/models/ball") balls = (*reader)->times(id).size();
    }
    EXPECT_EQ(balls, 30U);
    Bookmarks bookmarks = opened();
    // All up to one of them: what was saved stays saved.
    for (std::size_t i = 0; i < bookmarks.all().size(); ++i)
      EXPECT_EQ(bookmarks.all()[i].text, std::to_string(i));
    bookmarks.add(Instant(0s), Instant(0s), "afterwards");
    EXPECT_TRUE(bookmarks.save());
    EXPECT_EQ(opened().all(), bookmarks.all());
  }
}

}  // namespace
}  // namespace logplayer
