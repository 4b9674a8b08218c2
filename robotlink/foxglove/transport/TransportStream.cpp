// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/transport/TransportStream.h"

#include <array>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <optional>
#include <string>

namespace robotlink::websocket {

/// The socket, what was read ahead, and what is gathered and being written. Handlers of the system hold it,
/// so that it outlives the stream until they were called.
class TransportStream::State : public std::enable_shared_from_this<State> {
 public:
  State(TransportSocket connected, asio::ssl::context* tls) : socket(std::move(connected)) {
    if (tls) secured.emplace(socket, *tls);
  }

  void append(asio::const_buffer bytes) {
    gathered_.append(static_cast<const char*>(bytes.data()), bytes.size());
  }
  bool isGathering() const { return isGathering_ && !error_ && gathered_.size() < kGatheredBytes; }
  bool isIdle() const { return !isWriting_ && gathered_.empty(); }
  void gather(bool isOn) { isGathering_ = isOn; }
  void flush() {
    if (!gathered_.empty()) writeAll();
  }
  void close() {
    error_code ignored;
    socket.close(ignored);
    if (!next_.handler) return;
    asio::post(socket.get_executor(), [write = std::exchange(next_, {})]() mutable {
      write.handler(asio::error::operation_aborted, 0);
    });
  }
  void write(asio::const_buffer large, std::size_t bytes, TransportHandler handler) {
    next_ = {large, bytes, std::move(handler)};
    writeAll();
  }

  void read(asio::mutable_buffer buffer, TransportHandler handler) {
    if (aheadBegin_ < aheadEnd_) return passOn(buffer, std::move(handler));
    // Large reads need no copy.
    const bool isDirect = buffer.size() >= ahead_.size();
    auto onRead = [self = shared_from_this(), buffer, isDirect, handler = std::move(handler)](
                      error_code error, std::size_t bytes) mutable {
      if (error || isDirect) return handler(error, bytes);
      self->aheadBegin_ = 0;
      self->aheadEnd_ = bytes;
      handler(error, self->takeAhead(buffer));
    };
    const asio::mutable_buffer target = isDirect ? buffer : asio::buffer(ahead_);
    if (secured) {
      secured->async_read_some(target, std::move(onRead));
    } else {
      socket.async_read_some(target, std::move(onRead));
    }
  }

  TransportSocket socket;
  std::optional<asio::ssl::stream<TransportSocket&>> secured;

 private:
  struct Write {
    asio::const_buffer large;
    std::size_t bytes = 0;
    TransportHandler handler;
  };

  std::size_t takeAhead(asio::mutable_buffer buffer) {
    const std::size_t bytes =
        asio::buffer_copy(buffer, asio::buffer(ahead_) + aheadBegin_, aheadEnd_ - aheadBegin_);
    aheadBegin_ += bytes;
    return bytes;
  }
  /// Answers from what was read ahead: at once, but not in endless recursion.
  void passOn(asio::mutable_buffer buffer, TransportHandler handler) {
    const std::size_t bytes = takeAhead(buffer);
    const auto self = shared_from_this();
    if (depth_ >= kMaxDepth) {
      return asio::post(socket.get_executor(),
                        [self, bytes, handler = std::move(handler)]() mutable { handler({}, bytes); });
    }
    ++depth_;
    handler({}, bytes);
    --depth_;
  }

  void writeAll() {
    if (isWriting_) return;  // onWritten() continues
    isWriting_ = true;
    writing_.swap(gathered_);
    gathered_.clear();
    const std::array<asio::const_buffer, 2> parts{asio::buffer(writing_), next_.large};
    // Only the operation in progress holds the handler, since the handler in turn holds the stream.
    auto onDone = [self = shared_from_this(), write = std::exchange(next_, {})](
                      error_code error, std::size_t) mutable { self->onWritten(error, std::move(write)); };
    if (secured) {
      asio::async_write(*secured, parts, std::move(onDone));
    } else {
      asio::async_write(socket, parts, std::move(onDone));
    }
  }

  void onWritten(error_code error, Write done) {
    isWriting_ = false;
    if (error) error_ = error;
    // The handler may begin the next write.
    if (done.handler) done.handler(error_, error_ ? 0 : done.bytes);
    if (next_.handler || (!isGathering_ && !gathered_.empty())) writeAll();
  }

  static constexpr int kMaxDepth = 8;

  std::array<char, 16U << 10U> ahead_;
  std::size_t aheadBegin_ = 0, aheadEnd_ = 0;
  int depth_ = 0;
  bool isGathering_ = false, isWriting_ = false;
  error_code error_;
  std::string gathered_, writing_;
  Write next_;
};

TransportStream::TransportStream(TransportSocket socket, asio::ssl::context* tls)
    : state_(std::make_shared<State>(std::move(socket), tls)) {}

TransportStream::~TransportStream() {
  close();
}

void TransportStream::close() {
  state_->close();
}

TransportSocket& TransportStream::socket() {
  return state_->socket;
}

const TransportSocket& TransportStream::socket() const {
  return state_->socket;
}

bool TransportStream::isEncrypted() const {
  return state_->secured.has_value();
}

SSL* TransportStream::tls() const {
  return state_->secured ? state_->secured->native_handle() : nullptr;
}

void TransportStream::gather(bool isOn) {
  state_->gather(isOn);
}

void TransportStream::flush() {
  state_->flush();
}

void TransportStream::append(asio::const_buffer bytes) {
  state_->append(bytes);
}

bool TransportStream::isGathering() const {
  return state_->isGathering();
}

void TransportStream::startHandshake(asio::ssl::stream_base::handshake_type side, TransportEnd handler) {
  state_->secured->async_handshake(
      side, [state = state_, handler = std::move(handler)](error_code error) mutable { handler(error); });
}

void TransportStream::startRead(asio::mutable_buffer buffer, TransportHandler handler) {
  state_->read(buffer, std::move(handler));
}

void TransportStream::startWrite(asio::const_buffer large, std::size_t bytes, TransportHandler handler) {
  state_->write(large, bytes, std::move(handler));
}

void TransportStream::startTeardown(boost::beast::role_type role, TransportEnd handler) {
  auto onDone = [state = state_, handler = std::move(handler)](error_code error) mutable { handler(error); };
  if (state_->secured) {
    state_->secured->async_shutdown(std::move(onDone));
  } else {
    boost::beast::websocket::async_teardown(role, state_->socket, std::move(onDone));
  }
}

void TransportStream::tryWrite(std::span<const std::uint8_t> bytes) {
  if (!state_->isIdle()) return;
  error_code ignored;
  state_->socket.non_blocking(true, ignored);
  const auto buffer = asio::buffer(bytes.data(), bytes.size());
  if (state_->secured) {
    state_->secured->write_some(buffer, ignored);
  } else {
    state_->socket.write_some(buffer, ignored);
  }
}

}  // namespace robotlink::websocket
