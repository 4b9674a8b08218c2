// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "tests/robotlink/foxglove/RawClient.h"

namespace robotlink::websocket::test {

/// A WebSocket client with TLS as Beast and OpenSSL make it. What it waits for it waits half a minute for.
class TlsClient {
 public:
  struct Options {
    std::string target = "/";
    std::vector<std::pair<std::string, std::string>> fields = {};
    /// Nothing newer is spoken: TLS1_1_VERSION and the like; 0: the newest.
    int maxVersion = 0;
  };

  explicit TlsClient(std::uint16_t port) : TlsClient(port, Options()) {}
  TlsClient(std::uint16_t port, Options options);
  ~TlsClient();

  /// Whether the handshake of TLS succeeded; what it agreed on; the certificate that was shown.
  bool isSecured() const;
  std::string version() const;
  std::string fingerprint() const;
  /// As a RawClient's.
  unsigned status() const;
  const std::string& text() const;
  void send(const ClientMessage& message);
  const Frame* receive();
  /// Whether the server agrees to negotiate keys and versions again.
  bool renegotiates();

 private:
  struct Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::websocket::test
