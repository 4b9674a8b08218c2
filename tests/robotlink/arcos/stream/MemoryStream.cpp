// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/arcos/stream/MemoryStream.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>

namespace robotlink::arcos {
namespace {

/// One direction.
struct Pipe {
  std::mutex mutex;  // protects everything here
  std::condition_variable changed;
  std::deque<std::uint8_t> bytes;
  bool writerGone = false;
  bool readerGone = false;
};

class MemoryStream final : public ByteStream {
 public:
  MemoryStream(std::shared_ptr<Pipe> in, std::shared_ptr<Pipe> out, std::string name)
      : in_(std::move(in)), out_(std::move(out)), name_(std::move(name)) {}
  ~MemoryStream() override { MemoryStream::close(); }
  MemoryStream(const MemoryStream&) = delete;
  MemoryStream& operator=(const MemoryStream&) = delete;

  Result<std::size_t> read(std::span<std::uint8_t> bytes, Duration timeout) override {
    std::unique_lock lock(in_->mutex);
    in_->changed.wait_for(lock, timeout,
                          [&] { return !in_->bytes.empty() || in_->writerGone || in_->readerGone; });
    if (in_->readerGone) return closedHere();
    const std::size_t count = std::min(bytes.size(), in_->bytes.size());
    const auto end = in_->bytes.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(in_->bytes.begin(), end, bytes.begin());
    in_->bytes.erase(in_->bytes.begin(), end);
    if (count == 0 && !bytes.empty() && in_->writerGone) return lost();
    return count;
  }

  Result<void> write(std::span<const std::uint8_t> bytes) override {
    const std::lock_guard lock(out_->mutex);
    if (out_->writerGone) return closedHere();
    if (out_->readerGone) return lost();
    if (out_->bytes.size() + bytes.size() > kMemoryStreamBytes) {
      return failure("stream.busy", name_ + " takes no more bytes: nobody reads them at the other end", {},
                     {name_});
    }
    out_->bytes.insert(out_->bytes.end(), bytes.begin(), bytes.end());
    out_->changed.notify_all();
    return {};
  }

  void close() override {
    hangUp(*in_, &Pipe::readerGone);
    hangUp(*out_, &Pipe::writerGone);
  }

  std::string address() const override { return name_; }

 private:
  static void hangUp(Pipe& pipe, bool Pipe::*gone) {
    const std::lock_guard lock(pipe.mutex);
    pipe.*gone = true;
    pipe.changed.notify_all();
  }
  tl::unexpected<Error> closedHere() const {
    return failure("stream.closed", "the line to " + name_ + " was closed by this program", {}, {name_});
  }
  tl::unexpected<Error> lost() const {
    return failure("stream.lost", name_ + " was closed at the other end", {}, {name_});
  }

  const std::shared_ptr<Pipe> in_, out_;
  const std::string name_;
};

}  // namespace

std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> memoryStreams(const std::string& name) {
  const auto there = std::make_shared<Pipe>(), back = std::make_shared<Pipe>();
  return {std::make_unique<MemoryStream>(there, back, name),
          std::make_unique<MemoryStream>(back, there, name)};
}

}  // namespace robotlink::arcos
