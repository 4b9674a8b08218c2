// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/write/Sink.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace logplayer::mcap {

using robotlink::failure;
using robotlink::Result;

namespace {

/// Returns 0 or an errno.
int writeAll(int descriptor, std::vector<iovec> parts) {
  std::size_t first = 0;
  while (first < parts.size()) {
    const ssize_t written =
        ::writev(descriptor, parts.data() + first, static_cast<int>(parts.size() - first));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    auto left = static_cast<std::size_t>(written);
    while (first < parts.size() && left >= parts[first].iov_len) left -= parts[first++].iov_len;
    if (first < parts.size()) {
      if (written == 0) return EIO;
      parts[first].iov_base = static_cast<char*>(parts[first].iov_base) + left;
      parts[first].iov_len -= left;
    }
  }
  return 0;
}

}  // namespace

Result<Sink> Sink::create(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor >= 0) return Sink(file, descriptor, 0);
  if (errno == EEXIST) {
    return failure("mcap.exists", "the file exists; choose another name or remove it first",
                   {file.string(), 0, 0});
  }
  const std::string reason = std::strerror(errno);
  return failure("mcap.create", "cannot create the log file: " + reason, {file.string(), 0, 0}, {reason});
}

Result<Sink> Sink::reopen(const std::filesystem::path& file, std::uint64_t bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor >= 0 && ::lseek(descriptor, static_cast<off_t>(bytes), SEEK_SET) >= 0) {
    Sink sink(file, descriptor, bytes);
    sink.cut_ = false;
    return sink;
  }
  const std::string reason = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  return failure("mcap.append", "cannot append to the log file: " + reason, {file.string(), 0, 0}, {reason});
}

Sink::Sink(std::filesystem::path file, int descriptor, std::uint64_t position)
    : file_(std::move(file)), descriptor_(descriptor), position_(position) {}

Sink::Sink(Sink&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      position_(other.position_),
      cut_(other.cut_),
      failed_(other.failed_),
      error_(std::move(other.error_)) {}

Sink::~Sink() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> Sink::write(std::initializer_list<Bytes> parts) {
  if (failed_) return tl::unexpected(*error_);
  if (!cut_) {
    if (::ftruncate(descriptor_, static_cast<off_t>(position_)) != 0) return fail("cut", errno);
    cut_ = true;
  }
  std::vector<iovec> vector;
  std::uint64_t bytes = 0;
  for (const Bytes part : parts) {
    vector.push_back({const_cast<std::uint8_t*>(part.data()), part.size()});
    bytes += part.size();
  }
  if (const int code = writeAll(descriptor_, std::move(vector)); code != 0) return fail("write", code);
  position_ += bytes;
  return {};
}

Result<void> Sink::sync() {
  // EINVAL: devices and pipes cannot be synchronized.
  if (::fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS) return {};
  return fail("flush", errno);
}

Result<void> Sink::fail(const char* action, int code) {
  failed_ = true;
  // Removes the incomplete record, so that readers need not search for the end of the last complete one.
  if (::ftruncate(descriptor_, static_cast<off_t>(position_)) == 0) {
    ::lseek(descriptor_, static_cast<off_t>(position_), SEEK_SET);
  }
  if (!error_) {
    const std::string reason = std::strerror(code);
    error_ = robotlink::Error{"mcap.write",
                              std::string("cannot ") + action + " the log file at byte " +
                                  std::to_string(position_) + ": " + reason + kWhatIsKept,
                              {reason},
                              {file_.string(), 0, 0}};
  }
  return tl::unexpected(*error_);
}

}  // namespace logplayer::mcap
