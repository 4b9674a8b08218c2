// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/VideoCalls.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

namespace app {
namespace {

class SystemVideoCalls final : public VideoCalls {
 public:
  int open(const char* device) override { return ::open(device, O_RDWR | O_NONBLOCK | O_CLOEXEC); }
  void close(int file) override { ::close(file); }
  int ioctl(int file, unsigned long request, void* argument) override {
    int result = 0;
    do {
      result = ::ioctl(file, request, argument);
    } while (result < 0 && errno == EINTR);
    return result;
  }
  void* map(int file, std::size_t length, std::int64_t offset) override {
    void* memory = ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, file, offset);
    return memory == MAP_FAILED ? nullptr : memory;
  }
  void unmap(void* memory, std::size_t length) override { ::munmap(memory, length); }
  int wait(int file, int milliseconds) override {
    pollfd waiting{file, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, milliseconds);
    if (ready < 0) return errno == EINTR ? 0 : -1;
    if (ready > 0 && (waiting.revents & POLLIN) == 0) return -1;
    return ready;
  }
};

}  // namespace

VideoCalls& systemVideoCalls() {
  static SystemVideoCalls calls;
  return calls;
}

}  // namespace app
