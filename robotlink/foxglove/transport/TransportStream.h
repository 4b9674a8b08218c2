// SPDX-License-Identifier: GPL-3.0-or-later
// For sources that include Asio anyway.
#pragma once

#include <openssl/types.h>

#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream_base.hpp>
#include <boost/beast/core/role.hpp>
#include <memory>
#include <span>
#include <utility>

namespace robotlink::websocket {

namespace asio = boost::asio;
using boost::system::error_code;
// With the executor's own type calls are direct.
using TransportExecutor = asio::io_context::executor_type;
using TransportSocket = asio::basic_stream_socket<asio::ip::tcp, TransportExecutor>;

/// A handler of such values, whatever its type is. It is called once at most.
template <typename... Values>
class AnyHandler {
 public:
  AnyHandler() = default;
  template <typename Handler>
  explicit AnyHandler(Handler handler) : call_(std::make_unique<Call<Handler>>(std::move(handler))) {}

  explicit operator bool() const { return call_ != nullptr; }
  void operator()(Values... values) { std::exchange(call_, nullptr)->run(values...); }

 private:
  struct AnyCall {
    AnyCall() = default;
    virtual ~AnyCall() = default;
    AnyCall(const AnyCall&) = delete;
    AnyCall& operator=(const AnyCall&) = delete;
    virtual void run(Values... values) = 0;
  };
  template <typename Handler>
  struct Call final : AnyCall {
    explicit Call(Handler wrapped) : handler(std::move(wrapped)) {}
    void run(Values... values) override { std::move(handler)(values...); }
    Handler handler;
  };
  std::unique_ptr<AnyCall> call_;
};
using TransportEnd = AnyHandler<error_code>;
using TransportHandler = AnyHandler<error_code, std::size_t>;

/// The bytes below a WebSocket: a TCP socket, encrypted or not. For Beast and Asio it is an asynchronous
/// stream (AsyncReadStream, AsyncWriteStream). It is one type for both, so that the templates of a WebSocket
/// are compiled once; and it reads ahead and can gather small writes, because a call of the system costs more
/// than a small message. All calls come from the thread of its io_context. The destructor closes the socket.
class TransportStream {
 public:
  using executor_type = TransportExecutor;
  /// The most bytes that are gathered. No more than this, because urgent messages wait behind them.
  static constexpr std::size_t kGatheredBytes = 8U << 10U;

  explicit TransportStream(TransportSocket socket) : TransportStream(std::move(socket), nullptr) {}
  /// Encrypted if there is a context, once secure() has succeeded.
  TransportStream(TransportSocket socket, asio::ssl::context* tls);
  ~TransportStream();
  TransportStream(const TransportStream&) = delete;
  TransportStream& operator=(const TransportStream&) = delete;

  executor_type get_executor() { return socket().get_executor(); }
  TransportSocket& socket();
  const TransportSocket& socket() const;
  bool isEncrypted() const;
  /// The TLS handshake, which comes first; `handler` takes its error.
  template <typename Handler>
  void secure(asio::ssl::stream_base::handshake_type side, Handler handler) {
    startHandshake(side, TransportEnd(std::move(handler)));
  }
  /// The TLS connection; null if it is not encrypted.
  SSL* tls() const;

  /// While this is on, small writes count as done at once. They go to the system with the first write that is
  /// large, finds kGatheredBytes gathered, or comes after this was switched off; or by flush(). If that
  /// fails, the next write has the error.
  void gather(bool isOn);
  void flush();
  /// Whether it is on, and there is room for more.
  bool isGathering() const;

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    asio::mutable_buffer buffer;
    for (auto at = asio::buffer_sequence_begin(buffers); at != asio::buffer_sequence_end(buffers); ++at)
      if (buffer.size() == 0) buffer = *at;
    return asio::async_initiate<Token, void(error_code, std::size_t)>(
        [this, buffer](auto handler) { startRead(buffer, TransportHandler(std::move(handler))); }, token);
  }
  /// May write a part only, as Asio's streams do.
  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    // Small buffers are copied. A large one is written from where it is, together with those before it.
    asio::const_buffer large;
    std::size_t copied = 0;
    for (auto at = asio::buffer_sequence_begin(buffers); at != asio::buffer_sequence_end(buffers); ++at) {
      const asio::const_buffer part(*at);
      if (part.size() >= kGatheredBytes) large = part;
      if (copied + part.size() > kGatheredBytes || large.size() > 0) break;
      append(part);
      copied += part.size();
    }
    return asio::async_initiate<Token, void(error_code, std::size_t)>(
        [this, large, copied](auto handler) {
          if (large.size() == 0 && isGathering()) return std::move(handler)(error_code(), copied);
          startWrite(large, copied + large.size(), TransportHandler(std::move(handler)));
        },
        token);
  }
  /// Writes so few bytes that the system takes them at once, if it takes any, and nothing waits before them.
  void tryWrite(std::span<const std::uint8_t> bytes);

  /// How Beast ends a connection after the last frame.
  template <typename Handler>
  friend void async_teardown(boost::beast::role_type role, TransportStream& stream, Handler&& handler) {
    stream.startTeardown(role, TransportEnd(std::forward<Handler>(handler)));
  }

  /// How Beast closes it at once.
  friend void beast_close_socket(TransportStream& stream) { stream.close(); }
  void close();

 private:
  class State;
  void append(asio::const_buffer bytes);
  void startHandshake(asio::ssl::stream_base::handshake_type side, TransportEnd handler);
  void startRead(asio::mutable_buffer buffer, TransportHandler handler);
  /// Writes what was appended, then `large`; the handler gets `bytes`.
  void startWrite(asio::const_buffer large, std::size_t bytes, TransportHandler handler);
  void startTeardown(boost::beast::role_type role, TransportEnd handler);

  /// Operations in progress share ownership.
  const std::shared_ptr<State> state_;
};

}  // namespace robotlink::websocket
