// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingFolder.h"

#include <gmock/gmock.h>

#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

class RecordingFolderTest : public testing::Test {
 protected:
  TestFolder files_;
  RecordingFolder folder_{files_ / "recordings"};
};

TEST_F(RecordingFolderTest, aFolderThatDoesNotExistIsEmpty) {
  EXPECT_TRUE(folder_.list().value().empty());
}

TEST_F(RecordingFolderTest, onlyRecordingsAreListed) {
  files_.write("recordings/a.mcap", "12345");
  files_.write("recordings/notes.txt", "secret");
  files_.write("recordings/.hidden.mcap", "unfinished");
  files_.write("recordings/deeper.mcap/b.mcap", "in a folder");
  std::filesystem::create_symlink(files_.write("outside.mcap", "secret"), files_ / "recordings/link.mcap");
  const auto entries = folder_.list().value();
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].name, "a.mcap");
  EXPECT_EQ(entries[0].bytes, 5U);
  EXPECT_GT(entries[0].modified, 1.7e9);
}

TEST_F(RecordingFolderTest, theNewestIsListedFirst) {
  const auto old = files_.write("recordings/b.mcap", "1");
  files_.write("recordings/a.mcap", "2");
  std::filesystem::last_write_time(old, std::filesystem::last_write_time(old) - std::chrono::hours(1));
  const auto entries = folder_.list().value();
  EXPECT_THAT(entries, ElementsAre(Field(&RecordingFolder::Entry::name, "a.mcap"),
                                   Field(&RecordingFolder::Entry::name, "b.mcap")));
}

TEST_F(RecordingFolderTest, noNameLeadsOutOfTheFolder) {
  files_.write("outside.mcap", "secret");
  files_.write("recordings/notes.txt", "secret");
  std::filesystem::create_symlink(files_ / "outside.mcap", files_ / "recordings/link.mcap");
  const std::string absolute = (files_ / "outside.mcap").string();
  for (const std::string& name :
       {std::string("../outside.mcap"), absolute, std::string("link.mcap"), std::string("notes.txt"),
        std::string(), std::string("."), std::string(".."), std::string("link.mcap\0.mcap", 15)}) {
    EXPECT_FALSE(folder_.read(name, 0, 100)) << name;
    EXPECT_FALSE(folder_.extend(name, {}, 100, 100)) << name;
    EXPECT_FALSE(folder_.remove(name)) << name;
  }
  EXPECT_TRUE(std::filesystem::exists(files_ / "outside.mcap"));
}

TEST_F(RecordingFolderTest, piecesEndWithTheFile) {
  files_.write("recordings/a.mcap", "0123456789");
  EXPECT_EQ(folder_.read("a.mcap", 0, 4).value(), "0123");
  EXPECT_EQ(folder_.read("a.mcap", 8, 4).value(), "89");
  EXPECT_EQ(folder_.read("a.mcap", 10, 4).value(), "");
  EXPECT_EQ(folder_.read("a.mcap", UINT64_MAX, UINT64_MAX).value(), "");
}

TEST_F(RecordingFolderTest, aPieceIsBoundedWhateverIsAskedFor) {
  files_.write("recordings/a.mcap", std::string(RecordingFolder::kMaxPiece + 5, 'x'));
  EXPECT_EQ(folder_.read("a.mcap", 0, UINT64_MAX).value().size(), RecordingFolder::kMaxPiece);
}

TEST_F(RecordingFolderTest, aChecksumInStepsIsThatOfTheWhole) {
  files_.write("recordings/a.mcap", "123456789");
  RecordingFolder::Checksum sum;
  for (int i = 0; i < 5; ++i) sum = folder_.extend("a.mcap", sum, UINT64_MAX, 2).value();
  EXPECT_EQ(sum.bytes, 9U);
  EXPECT_EQ(sum.crc, 0xCBF43926U);  // the check value of CRC-32
  EXPECT_EQ(folder_.extend("a.mcap", {}, 4, 100).value().bytes, 4U);
}

TEST_F(RecordingFolderTest, aRecordingIsDeleted) {
  files_.write("recordings/a.mcap", "1");
  EXPECT_TRUE(folder_.remove("a.mcap"));
  EXPECT_TRUE(folder_.list().value().empty());
  EXPECT_THAT(folder_.remove("a.mcap").error().text, HasSubstr("no recording 'a.mcap'"));
}

}  // namespace
}  // namespace app
