// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace robotlink::websocket::test {

/// A TCP server that answers whatever it hears with the same bytes and closes; with none, it stays silent.
class PlainServer {
 public:
  explicit PlainServer(std::string answer);
  ~PlainServer();
  PlainServer(const PlainServer&) = delete;
  PlainServer& operator=(const PlainServer&) = delete;

  std::uint16_t port() const;

 private:
  struct Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::websocket::test
