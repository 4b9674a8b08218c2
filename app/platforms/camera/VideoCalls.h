// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace app {

/// The calls of the operating system that a camera needs, with their meaning and their errno; tests have a
/// camera of their own behind them. Any thread.
class VideoCalls {
 public:
  virtual ~VideoCalls() = default;
  virtual int open(const char* device) = 0;
  virtual void close(int file) = 0;
  /// Repeats calls that a signal interrupts.
  virtual int ioctl(int file, unsigned long request, void* argument) = 0;
  /// Maps a buffer of the device for reading; null if that fails.
  virtual void* map(int file, std::size_t length, std::int64_t offset) = 0;
  virtual void unmap(void* memory, std::size_t length) = 0;
  /// Waits until an image is there: 1; the time is over: 0; the device is disconnected: -1.
  virtual int wait(int file, int milliseconds) = 0;
};

/// The real ones. They live as long as the program.
VideoCalls& systemVideoCalls();

}  // namespace app
