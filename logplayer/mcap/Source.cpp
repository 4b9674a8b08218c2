// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace logplayer::mcap {

using robotlink::failure;
using robotlink::Result;

Result<Source> Source::open(const std::filesystem::path& file) {
  // Without O_NONBLOCK, opening a named pipe would block until another program writes to it.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    const std::string reason = std::strerror(errno);
    if (descriptor >= 0) ::close(descriptor);
    return failure("mcap.open", "cannot open the log file: " + reason, {file.string(), 0, 0}, {reason});
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return failure("mcap.open", "this file does not support random access; copy it to disk first",
                   {file.string(), 0, 0});
  }
  const auto changed = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
  return Source(file, descriptor,
                {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), changed});
}

Source::Source(std::filesystem::path file, int descriptor, const Identity& identity)
    : file_(std::move(file)), descriptor_(descriptor), identity_(identity) {}

Source::Source(Source&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      identity_(other.identity_) {}

Source::~Source() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint64_t Source::cutOff() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return 0;
  const auto now = static_cast<std::uint64_t>(status.st_size);
  return now < bytes() ? bytes() - now : 0;
}

bool Source::read(std::uint64_t offset, std::span<std::uint8_t> to) const {
  while (!to.empty()) {
    const ssize_t count = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    to = to.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  return true;
}

Buffer Source::read(std::uint64_t offset, std::uint64_t count) const {
  Buffer buffer(offset >= bytes() ? 0 : static_cast<std::size_t>(std::min(count, bytes() - offset)));
  if (!read(offset, buffer)) buffer.clear();
  return buffer;
}

Bytes SourceWindow::look(std::uint64_t offset, std::size_t count) {
  if (offset < start_ || offset + count > start_ + buffer_.size()) {
    const std::uint64_t left = offset >= source_.bytes() ? 0 : source_.bytes() - offset;
    start_ = offset;
    buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(std::max(size_, count), left)));
    if (!source_.read(offset, buffer_)) buffer_.clear();
  }
  const Bytes all = Bytes(buffer_).subspan(std::min<std::size_t>(buffer_.size(), offset - start_));
  return all.first(std::min(all.size(), count));
}

}  // namespace logplayer::mcap
