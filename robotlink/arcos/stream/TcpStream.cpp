// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/TcpStream.h"

#include <sys/socket.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <optional>
#include <system_error>
#include <vector>

#include "robotlink/arcos/stream/DescriptorStream.h"
#include "robotlink/base/network/HostLookup.h"

namespace robotlink::arcos {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

std::string endpointOf(const TcpAddress& address) {
  return address.host + ":" + std::to_string(address.port);
}

class TcpStream final : public DescriptorStream {
 public:
  TcpStream(int descriptor, const TcpAddress& address)
      : DescriptorStream(descriptor, toString(address)), endpoint_(endpointOf(address)) {}

  /// Shuts the connection down so that the far end notices at once, even while a thread of this program still
  /// reads.
  void close() override {
    DescriptorStream::close();
    ::shutdown(descriptor(), SHUT_RDWR);
  }

 private:
  std::string describeLoss(int error) const override {
    if (error == 0) return endpoint_ + " closed the connection; connect again when it is ready";
    return "the connection to " + endpoint_ + " was lost (" + std::generic_category().message(error) +
           "); connect again";
  }
  ssize_t writeSome(std::span<const std::uint8_t> bytes) override {
    return ::send(descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  const std::string endpoint_;
};

tl::unexpected<Error> notFound(const TcpAddress& address, const std::string& reason) {
  return failure("stream.no-host", reason, {}, {address.host});
}

tl::unexpected<Error> notConnected(const TcpAddress& address, const error_code& error) {
  const std::string endpoint = endpointOf(address);
  if (error == asio::error::connection_refused) {
    return failure("stream.refused",
                   "nothing listens at " + endpoint +
                       ": start the simulator or the robot's server there, or check the port",
                   {}, {endpoint});
  }
  return failure("stream.unreachable",
                 endpoint + " cannot be reached (" + error.message() + "): check the network and the address",
                 {}, {endpoint});
}

}  // namespace

Result<std::unique_ptr<ByteStream>> openTcp(const TcpAddress& address, Duration timeLimit) {
  const auto end = std::chrono::steady_clock::now() + timeLimit;
  const auto found = HostLookup::start(address.host)->wait(timeLimit);
  if (!found)
    return notFound(address, "the network has not yet resolved the name '" + address.host +
                                 "': try again, or give its IP address");
  if (!*found) return notFound(address, found->error().text);
  std::vector<tcp::endpoint> endpoints;
  for (const std::string& one : **found) {
    error_code ignored;
    endpoints.emplace_back(asio::ip::make_address(one, ignored), address.port);
  }
  if (address.host == "localhost") endpoints.emplace_back(asio::ip::address_v6::loopback(), address.port);

  asio::io_context context;
  error_code error;
  tcp::socket socket(context);
  std::optional<error_code> outcome;
  asio::async_connect(socket, endpoints, [&](const error_code& e, const tcp::endpoint&) { outcome = e; });
  context.run_until(end);
  if (!outcome) {
    return failure("stream.no-answer",
                   endpointOf(address) + " does not answer: is it switched on, and on this network?", {},
                   {endpointOf(address)});
  }
  if (*outcome) return notConnected(address, *outcome);
  socket.set_option(tcp::no_delay(true), error);
  const int descriptor = socket.release(error);
  if (error) return notConnected(address, error);
  return std::make_unique<TcpStream>(descriptor, address);
}

}  // namespace robotlink::arcos
