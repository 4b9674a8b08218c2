// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// The end of the error message when a file cannot be written any further.
inline constexpr char kWhatIsKept[] = "; what was written before can be read";

/// A file that is written sequentially with error checks: the first error of the operating system is stored,
/// and every later write returns it. A failed write is removed from the file, if the system permits. One
/// thread; movable.
class Sink {
 public:
  /// The file must not exist.
  static robotlink::Result<Sink> create(const std::filesystem::path& file);
  /// Continues a file behind its first `bytes`; the first write truncates the rest.
  static robotlink::Result<Sink> reopen(const std::filesystem::path& file, std::uint64_t bytes);
  Sink(Sink&& other) noexcept;
  Sink& operator=(Sink&&) = delete;
  ~Sink();

  /// Writes the parts one after the other, with a single system call where possible.
  robotlink::Result<void> write(std::initializer_list<Bytes> parts);
  /// Blocks until the file is on the disk (fsync).
  robotlink::Result<void> sync();
  /// Allows another write after an error, to restore the end of a file.
  void forgive() { failed_ = false; }

  /// Offset at which the next write begins.
  std::uint64_t position() const { return position_; }
  /// The first error, if there was one.
  const std::optional<robotlink::Error>& error() const { return error_; }

 private:
  Sink(std::filesystem::path file, int descriptor, std::uint64_t position);
  /// Stores and returns an error; `code` is an errno.
  robotlink::Result<void> fail(const char* action, int code);

  std::filesystem::path file_;
  int descriptor_;
  std::uint64_t position_;
  /// Whether nothing lies behind position_ in the file.
  bool cut_ = true;
  /// Whether the last write failed.
  bool failed_ = false;
  std::optional<robotlink::Error> error_;
};

}  // namespace logplayer::mcap
