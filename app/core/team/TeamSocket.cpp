// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/team/TeamSocket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/core/team/TeamDatagram.h"

namespace app {

struct TeamSocket::Peer {
  sockaddr_in address{};
};

namespace {

auto cannotOpen(const std::string& what) {
  return robotlink::failure("team.socket", "the link of the team cannot be opened: " + what);
}

robotlink::Result<sockaddr_in> addressOf(const std::string& peer) {
  const auto colon = peer.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == peer.size())
    return cannotOpen("a robot of the team is HOST:PORT, not '" + peer + "'");
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int status =
      ::getaddrinfo(peer.substr(0, colon).c_str(), peer.substr(colon + 1).c_str(), &hints, &found);
  if (status != 0) return cannotOpen("'" + peer + "' is not found: " + ::gai_strerror(status));
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, sizeof(address));
  ::freeaddrinfo(found);
  return address;
}

}  // namespace

TeamSocket::TeamSocket() = default;

TeamSocket::~TeamSocket() {
  if (socket_ >= 0) ::close(socket_);
}

robotlink::Result<std::unique_ptr<TeamSocket>> TeamSocket::open(std::uint16_t port,
                                                                const std::vector<std::string>& peers) {
  auto link = std::unique_ptr<TeamSocket>(new TeamSocket);
  for (const std::string& peer : peers) {
    const auto address = addressOf(peer);
    if (!address) return tl::unexpected(address.error());
    link->peers_.push_back({*address});
  }
  link->socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (link->socket_ < 0) return cannotOpen(std::strerror(errno));
  const int on = 1;
  ::setsockopt(link->socket_, SOL_SOCKET, SO_BROADCAST, &on, sizeof(on));
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(INADDR_ANY);
  own.sin_port = htons(port);
  if (::bind(link->socket_, reinterpret_cast<const sockaddr*>(&own), sizeof(own)) != 0)
    return cannotOpen("port " + std::to_string(port) + ": " + std::strerror(errno));
  socklen_t length = sizeof(own);
  if (::getsockname(link->socket_, reinterpret_cast<sockaddr*>(&own), &length) != 0)
    return cannotOpen(std::strerror(errno));
  link->port_ = ntohs(own.sin_port);
  return link;
}

void TeamSocket::send(std::span<const std::uint8_t> datagram) {
  for (const Peer& peer : peers_)
    (void)::sendto(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                   reinterpret_cast<const sockaddr*>(&peer.address), sizeof(peer.address));
}

std::optional<std::vector<std::uint8_t>> TeamSocket::receive() {
  // Longer ones are cut, which is noticed by their length.
  std::vector<std::uint8_t> datagram(kMaxTeamBytes + 64);
  const auto count = ::recv(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT);
  if (count < 0) return std::nullopt;
  datagram.resize(static_cast<std::size_t>(count));
  return datagram;
}

}  // namespace app
