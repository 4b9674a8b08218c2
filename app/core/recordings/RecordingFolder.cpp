// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingFolder.h"

#include <algorithm>
#include <chrono>

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/FileRecords.h"
#include "logplayer/mcap/Source.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Result;

constexpr char kSuffix[] = ".mcap";

double secondsSince1970(fs::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration<double>(system.time_since_epoch()).count();
}

/// Whether the last bytes of a file are those of a recording that was ended.
bool endsWell(const fs::path& file) {
  const auto source = logplayer::mcap::Source::open(file);
  constexpr std::size_t kBytes = sizeof logplayer::mcap::kMagic;
  if (!source || source->bytes() < 2 * kBytes) return false;
  const auto end = source->read(source->bytes() - kBytes, kBytes);
  return std::ranges::equal(end, logplayer::mcap::kMagic);
}

}  // namespace

bool RecordingFolder::isName(const std::string& name) {
  constexpr std::size_t kMaxName = 255;
  const auto isPlain = [](unsigned char c) { return c >= ' ' && c != 127 && c != '/'; };
  return name.ends_with(kSuffix) && !name.starts_with('.') && name.size() <= kMaxName &&
         std::ranges::all_of(name, isPlain);
}

Result<std::vector<RecordingFolder::Entry>> RecordingFolder::list() const {
  std::vector<Entry> entries;
  std::error_code error;
  fs::directory_iterator file(folder_, error);
  if (error == std::errc::no_such_file_or_directory) return entries;
  for (; !error && file != fs::directory_iterator(); file.increment(error)) {
    const std::string name = file->path().filename().string();
    // Files without a status, since they were just deleted, are left out.
    std::error_code gone;
    if (!isName(name) || file->is_symlink(gone) || !file->is_regular_file(gone)) continue;
    const std::uint64_t bytes = file->file_size(gone);
    const auto modified = file->last_write_time(gone);
    if (!gone) entries.push_back({name, bytes, secondsSince1970(modified), endsWell(file->path())});
  }
  if (error) {
    return failure("recordings.folder", "the folder of recordings cannot be read: " + error.message(),
                   {folder_.string(), 0, 0});
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::pair(b.modified, b.name) < std::pair(a.modified, a.name);
  });
  return entries;
}

Result<fs::path> RecordingFolder::find(const std::string& name) const {
  const fs::path file = folder_ / name;
  std::error_code error;
  if (!isName(name) || fs::is_symlink(file, error) || !fs::is_regular_file(file, error))
    return failure("recordings.name", "there is no recording '" + name + "'", {}, {name});
  return file;
}

Result<std::string> RecordingFolder::read(const std::string& name, std::uint64_t offset,
                                          std::uint64_t bytes) const {
  const auto file = find(name);
  if (!file) return tl::unexpected(file.error());
  const auto source = logplayer::mcap::Source::open(*file);
  if (!source) return tl::unexpected(source.error());
  if (offset >= source->bytes()) return std::string();
  std::string piece(std::min({bytes, source->bytes() - offset, kMaxPiece}), '\0');
  if (!source->read(offset, {reinterpret_cast<std::uint8_t*>(piece.data()), piece.size()}))
    return failure("recordings.read", "the recording '" + name + "' cannot be read", {}, {name});
  return piece;
}

Result<RecordingFolder::Checksum> RecordingFolder::extend(const std::string& name, Checksum before,
                                                          std::uint64_t bytes, std::uint64_t atMost) const {
  const auto file = find(name);
  if (!file) return tl::unexpected(file.error());
  const auto source = logplayer::mcap::Source::open(*file);
  if (!source) return tl::unexpected(source.error());
  const std::uint64_t last = std::min({bytes, source->bytes(), before.bytes + atMost});
  while (before.bytes < last) {
    const auto piece = source->read(before.bytes, std::min(last - before.bytes, kMaxPiece));
    if (piece.empty())
      return failure("recordings.read", "the recording '" + name + "' cannot be read", {}, {name});
    before.crc = logplayer::mcap::crc32(piece, before.crc);
    before.bytes += piece.size();
  }
  return before;
}

Result<void> RecordingFolder::remove(const std::string& name) const {
  const auto file = find(name);
  if (!file) return tl::unexpected(file.error());
  std::error_code error;
  if (!fs::remove(*file, error) || error) {
    return failure("recordings.delete", "the recording '" + name + "' cannot be deleted: " + error.message(),
                   {}, {name});
  }
  return {};
}

}  // namespace app
