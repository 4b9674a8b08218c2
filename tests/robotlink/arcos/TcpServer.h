// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

/// The server end of a TCP connection, on a free port of the loopback interface; accepts one client at a
/// time.
class TcpServer {
 public:
  TcpServer() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* any = reinterpret_cast<sockaddr*>(&address);
    listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::bind(listener_, any, size) != 0 || ::listen(listener_, 0) != 0 ||
        ::getsockname(listener_, any, &size) != 0) {
      throw std::runtime_error("there is no port for the test's server");
    }
    address_ = address;
  }
  ~TcpServer() {
    stop();
    hangUp();
    for (const int socket : waiting_) ::close(socket);
  }
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  std::uint16_t port() const { return ntohs(address_.sin_port); }

  void accept() { client_ = ::accept(listener_, nullptr, nullptr); }
  void stop() { closeDescriptor(listener_); }
  void hangUp() { closeDescriptor(client_); }

  void send(const std::vector<std::uint8_t>& bytes) const {
    if (::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) {
      throw std::runtime_error("the client takes no bytes");
    }
  }

  /// Waits for at least `count` bytes, or until the client closes; throws after 2 s without data.
  std::vector<std::uint8_t> receive(std::size_t count) const {
    std::vector<std::uint8_t> bytes;
    std::array<std::uint8_t, 1024> piece{};
    while (bytes.size() < count) {
      pollfd polled{client_, POLLIN, 0};
      if (::poll(&polled, 1, 2000) <= 0) throw std::runtime_error("the client sent nothing for two seconds");
      const ssize_t got = ::recv(client_, piece.data(), piece.size(), 0);
      if (got <= 0) break;
      bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
    }
    return bytes;
  }

  /// Adds clients that are never accepted, until the system does not answer further ones.
  void fillBacklog() {
    for (int i = 0; i < 3; ++i) {
      const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
      ::connect(socket, reinterpret_cast<const sockaddr*>(&address_), sizeof address_);
      waiting_.push_back(socket);
    }
  }

 private:
  static void closeDescriptor(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
  }

  sockaddr_in address_{};
  int listener_ = -1;
  int client_ = -1;
  std::vector<int> waiting_;
};
