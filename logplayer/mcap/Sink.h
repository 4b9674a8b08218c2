// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// The end of the sentence that says why a file cannot be written further.
inline constexpr char kWhatIsKept[] = "; what was written before can be read";

/// A file that is written from front to back, checked: the first error of the operating system is kept, and
/// every later write returns it. A write that fails leaves nothing of itself in the file, if the system lets
/// it.
class Sink {
 public:
  /// The file must not exist.
  static robotlink::Result<Sink> create(const std::filesystem::path& file);
  /// Goes on behind the first `bytes` of a file; what follows them is cut off by the first write.
  static robotlink::Result<Sink> reopen(const std::filesystem::path& file, std::uint64_t bytes);
  Sink(Sink&& other) noexcept;
  Sink& operator=(Sink&&) = delete;
  ~Sink();

  /// One part behind the other, with one call of the system where it does it.
  robotlink::Result<void> write(std::initializer_list<Bytes> parts);
  /// Returns when the file is on the disk.
  robotlink::Result<void> sync();
  /// Lets write() try again after an error.
  void forgive() { failed_ = false; }

  std::uint64_t position() const { return position_; }
  /// The first error.
  const std::optional<robotlink::Error>& error() const { return error_; }

 private:
  Sink(std::filesystem::path file, int descriptor, std::uint64_t position);
  robotlink::Result<void> fail(const char* action, int code);

  std::filesystem::path file_;
  int descriptor_;
  std::uint64_t position_;
  bool cut_ = true;  // nothing lies behind position_
  bool failed_ = false;
  std::optional<robotlink::Error> error_;
};

}  // namespace logplayer::mcap
