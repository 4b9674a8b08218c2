// SPDX-License-Identifier: GPL-3.0-or-later
// How much waits in the system's buffers before what is urgent.
#include <gmock/gmock.h>
#include <sys/ioctl.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/protocol/CallPart.h"
#include "tests/Eventually.h"

namespace robotlink::websocket::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;

/// A server that offers two services, and reads only when it is asked to.
class LazyServer {
 public:
  LazyServer() {
    acceptor_.open(tcp::v4());
    acceptor_.set_option(asio::socket_base::receive_buffer_size(4096));
    acceptor_.bind({asio::ip::address_v4::loopback(), 0});
    acceptor_.listen();
  }
  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  void greet() {
    acceptor_.accept(beast::get_lowest_layer(socket_));
    socket_.set_option(
        beast::websocket::stream_base::decorator([](beast::websocket::response_type& response) {
          response.set(beast::http::field::sec_websocket_protocol, "foxglove.sdk.v1");
        }));
    socket_.accept();
    write(std::string(R"({"op":"serverInfo","name":"red1","capabilities":["services"],)") +
          R"("supportedEncodings":["json"],"metadata":{")" + kCallPartsKey + R"(":"1"}})");
    write(R"({"op":"advertiseServices","services":[)"
          R"({"id":1,"name":"table","type":"t","requestSchema":"","responseSchema":""},)"
          R"({"id":2,"name":"stop","type":"t","requestSchema":"","responseSchema":""}]})");
  }
  bool hasUnread() {
    int bytes = 0;
    return ::ioctl(beast::get_lowest_layer(socket_).native_handle(), FIONREAD, &bytes) == 0 && bytes > 1000;
  }
  /// How many bytes of the service 1 come before a call of the service 2.
  std::size_t bytesBeforeStop() {
    for (std::size_t bytes = 0;;) {
      beast::flat_buffer buffer;
      socket_.read(buffer);
      const auto* data = static_cast<const unsigned char*>(buffer.data().data());
      if (socket_.got_text() || buffer.size() < 5 || data[0] != 2) continue;
      if (data[1] == 2) return bytes;
      bytes += buffer.size();
    }
  }

 private:
  void write(const std::string& text) {
    socket_.text(true);
    socket_.write(asio::buffer(text));
  }

  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  beast::websocket::stream<tcp::socket> socket_{context_};
};

TEST(Room, littleOfALongCallIsInTheSystemsBuffersBeforeWhatIsUrgent) {
  LazyServer server;
  const auto client = std::make_shared<Client>(ClientHandlers{});
  Connector::Options options;
  options.url = {false, "127.0.0.1", server.port(), "/"};
  const Connector connector(client, options);
  server.greet();
  Client::Call table, stop;
  table.service = "table";
  table.encoding = stop.encoding = "json";
  table.payload.assign(1'000'000, ' ');
  stop.service = "stop";
  stop.urgency = Client::Urgency::kUrgent;
  client->call(table, [](const auto&) {});
  ASSERT_TRUE(eventually([&] { return server.hasUnread(); }));
  client->call(stop, [](const auto&) {});
  EXPECT_LT(server.bytesBeforeStop(), 20'000U);
}

}  // namespace
}  // namespace robotlink::websocket::test
