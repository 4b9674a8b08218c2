// SPDX-License-Identifier: GPL-3.0-or-later
// Waits for the first byte of a connection, which distinguishes TLS from plain HTTP.
#include <sys/socket.h>

#include <cerrno>

#include "robotlink/foxglove/server/ListenerPort.h"

namespace robotlink::websocket {
namespace {

/// A connection from which no byte has been received yet.
class FirstByte final : public Connection, public std::enable_shared_from_this<FirstByte> {
 public:
  FirstByte(ListenerPort& port, TransportSocket socket)
      : port_(port), machine_(farMachine(socket)), socket_(std::move(socket)), beganAt_(port.now()) {}

  void start() override { await(); }
  void tick(Instant now) override {
    if (now - beganAt_ > port_.options.handshakeTime) end();
  }
  void leave() override {}
  bool isHandshake() const override { return true; }
  const std::string& machine() const override { return machine_; }
  void end() override {
    error_code ignored;
    socket_.close(ignored);
    port_.remove(shared_from_this());
  }

 private:
  void await() {
    socket_.async_wait(TransportSocket::wait_read,
                       [self = shared_from_this()](error_code error) { error ? self->end() : self->look(); });
  }
  void look() {
    constexpr std::uint8_t kTlsHandshake = 0x16;
    std::uint8_t first = 0;
    const ssize_t received = ::recv(socket_.native_handle(), &first, 1, MSG_PEEK | MSG_DONTWAIT);
    // The system may wake this without a byte, for instance for an earlier connection with the same number.
    if (received < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return await();
    if (received != 1) return end();
    const auto self = shared_from_this();
    port_.remove(self);
    const bool isTls = first == kTlsHandshake;
    port_.add(makeConnection(port_, std::move(socket_), isTls ? port_.tls.get() : nullptr, !isTls));
  }

  ListenerPort& port_;
  const std::string machine_;
  TransportSocket socket_;
  const Instant beganAt_;
};

}  // namespace

ConnectionPtr makeFirstByte(ListenerPort& port, TransportSocket socket) {
  return std::make_shared<FirstByte>(port, std::move(socket));
}

}  // namespace robotlink::websocket
