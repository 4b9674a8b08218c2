// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/foxglove/PlainServer.h"

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <list>
#include <thread>

namespace robotlink::websocket::test {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

struct PlainServer::Implementation {
  struct Guest {
    explicit Guest(tcp::socket accepted) : socket(std::move(accepted)) {}
    tcp::socket socket;
    std::array<char, 4096> heard{};
  };

  explicit Implementation(std::string bytes) : answer(std::move(bytes)) {
    accept();
    thread = std::thread([this] { context.run(); });
  }
  ~Implementation() {
    context.stop();
    thread.join();
  }
  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (error) return;
      Guest& guest = guests.emplace_back(std::move(socket));
      guest.socket.async_read_some(asio::buffer(guest.heard), [this, &guest](error_code, std::size_t) {
        error_code ignored;
        if (answer.empty()) return;
        asio::write(guest.socket, asio::buffer(answer), ignored);
        guest.socket.shutdown(tcp::socket::shutdown_both, ignored);
      });
      accept();
    });
  }

  const std::string answer;
  asio::io_context context{1};
  tcp::acceptor acceptor{context, {asio::ip::address_v4::loopback(), 0}};
  std::list<Guest> guests;
  std::thread thread;
};

PlainServer::PlainServer(std::string answer)
    : implementation_(std::make_unique<Implementation>(std::move(answer))) {}

PlainServer::~PlainServer() = default;

std::uint16_t PlainServer::port() const {
  return implementation_->acceptor.local_endpoint().port();
}

}  // namespace robotlink::websocket::test
