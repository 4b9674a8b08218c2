// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket::test {

/// A WebSocket client as Beast makes it, for one thread. What it waits for it waits half a minute for.
class RawClient {
 public:
  struct Options {
    std::string protocols = kSdkProtocol;
    std::string target = "/";
    /// Further fields of the HTTP request, also of names that it has already.
    std::vector<std::pair<std::string, std::string>> fields = {};
    /// The system's buffer in bytes; 0: the system's choice.
    int receiveBuffer = 0;
    bool isWebSocket = true;
  };

  explicit RawClient(std::uint16_t port) : RawClient(port, Options()) {}
  RawClient(std::uint16_t port, Options options);
  ~RawClient();

  /// The status of the answer to the handshake, 101 if it is connected, 0 if there was none; the answer's
  /// text; and the sub-protocol that was chosen.
  unsigned status() const;
  const std::string& text() const;
  const std::string& protocol() const;

  void send(const ClientMessage& message) { send(encode(message)); }
  void send(const Frame& frame);
  /// Bytes on the TCP connection.
  void sendRaw(const std::string& bytes);
  /// The next message; nothing if the connection was closed. It is valid until the next call.
  const Frame* receive();
  /// The next message of a kind, or a default one if the connection was closed before.
  template <typename Message>
  Message expect() {
    while (const Frame* frame = receive()) {
      const auto message = decodeServerMessage(frame->kind, frame->bytes);
      if (message && std::holds_alternative<Message>(*message)) return std::get<Message>(*message);
    }
    return {};
  }
  /// Waits until the server has closed the connection, and returns what its close frame says.
  std::string closeReason();
  /// How many pings of the server came; any thread.
  int pings() const;
  /// The connection is cut, without a word.
  void cut();

 private:
  struct Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

/// A TCP connection on which nothing but `bytes` is sent. Returns all that is answered until it is closed.
std::string talkTcp(std::uint16_t port, const std::string& bytes);

}  // namespace robotlink::websocket::test
