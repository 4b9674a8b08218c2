// SPDX-License-Identifier: GPL-3.0-or-later
// Bookmarks that stand in a file beside their log.
#include <fstream>

#include "logplayer/bookmarks/BookmarkStorage.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace bookmark_file_fuzz {

using namespace logplayer;

int runInput(const std::uint8_t* data, std::size_t size) {
  static const TestFolder folder;
  const auto log = folder / "game.mcap";
  {
    std::filesystem::remove(fileBeside(log));  // disks take their time with files that are written over
    std::ofstream file(fileBeside(log), std::ios::binary);
    file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  const auto read = readBookmarksBeside(log);
  if (!read) {
    require(!read.error().text.empty(), "a refusal says why");
    return 0;
  }
  const auto all = changed({}, *read);
  for (const Bookmark& bookmark : all)
    require(bookmark.to - bookmark.from >= robotlink::Duration(0), "it ends after its begin");
  require(changed({}, difference({}, all)) == all, "a difference leads there");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {R"({"format": "robotcontrol-bookmarks", "version": 1, "bookmarks": {"entries": [
             {"id": 17, "from_ns": 1500000000, "to_ns": 2500000000, "text": "the goal"},
             {"id": 9007199254740991, "from_ns": -5, "to_ns": 0, "text": ""}, {"id": 3, "removed": true}]}})"};
}

const FuzzRegistration kTarget({"bookmark_file", &fuzzSeeds, &runInput});

}  // namespace bookmark_file_fuzz
