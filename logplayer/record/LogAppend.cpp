// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/LogAppend.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <vector>

#include "robotlink/base/UnfinishedFile.h"
#include "robotlink/base/bytes/LittleEndian.h"

namespace logplayer {
namespace {

using robotlink::Result;

constexpr off_t kFooterBytes = 37;   // including the magic number behind it
constexpr off_t kDataEndBytes = 13;  // the record before the summary
constexpr off_t kMaxEnd = off_t{256} << 20;

bool readAll(int file, std::uint8_t* data, std::size_t size, off_t offset) {
  while (size > 0) {
    const ssize_t count = ::pread(file, data, size, offset);
    if (count <= 0) return false;
    data += count;
    size -= static_cast<std::size_t>(count);
    offset += count;
  }
  return true;
}

/// The end of a log behind its data, which appending overwrites and which is restored on failure.
class LogEnd {
 public:
  explicit LogEnd(const std::filesystem::path& log) : file_(::open(log.c_str(), O_RDWR | O_CLOEXEC)) {
    struct stat status {};
    if (file_ < 0 || ::fstat(file_, &status) != 0 || status.st_size < kFooterBytes + kDataEndBytes) return;
    begin_ = beginOfEnd(status.st_size);
    if (begin_ < 0 || status.st_size - begin_ > kMaxEnd) return;
    bytes_.resize(static_cast<std::size_t>(status.st_size - begin_));
    if (!readAll(file_, bytes_.data(), bytes_.size(), begin_)) bytes_.clear();
  }
  ~LogEnd() {
    if (file_ >= 0) ::close(file_);
  }
  LogEnd(const LogEnd&) = delete;
  LogEnd& operator=(const LogEnd&) = delete;

  void restore() const {
    if (bytes_.empty()) return;
    // First remove what was appended, since it occupies the space.
    static_cast<void>(::ftruncate(file_, begin_) == 0 &&
                      ::pwrite(file_, bytes_.data(), bytes_.size(), begin_) ==
                          static_cast<ssize_t>(bytes_.size()) &&
                      ::fsync(file_) == 0);
  }

 private:
  /// Offset of the DataEnd record, derived from the footer's summary_start; negative if that is invalid.
  off_t beginOfEnd(off_t size) const {
    std::array<std::uint8_t, 8> start{};
    if (!readAll(file_, start.data(), start.size(), size - kFooterBytes + 9)) return -1;
    auto summary = robotlink::loadNumber<std::uint64_t>(start.data());
    if (summary == 0) summary = static_cast<std::uint64_t>(size - kFooterBytes);  // there is no summary
    if (summary < kDataEndBytes || summary > static_cast<std::uint64_t>(size)) return -1;
    return static_cast<off_t>(summary) - kDataEndBytes;
  }

  int file_;
  off_t begin_ = -1;
  std::vector<std::uint8_t> bytes_;
};

Result<void> append(const std::filesystem::path& log,
                    const std::function<Result<void>(mcap::Writer&)>& write) {
  auto writer = mcap::Writer::append(log, {});
  if (!writer) return tl::unexpected(writer.error());
  if (auto written = write(**writer); !written) return written;
  return (*writer)->close();
}

}  // namespace

Result<void> appendToLog(const std::filesystem::path& log,
                         const std::function<Result<void>(mcap::Writer&)>& write) {
  const robotlink::ChangeInPlace change;
  const LogEnd end(log);
  auto result = append(log, write);
  if (!result) end.restore();
  return result;
}

}  // namespace logplayer
