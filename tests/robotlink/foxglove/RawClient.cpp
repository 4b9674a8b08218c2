// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/foxglove/RawClient.h"

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace robotlink::websocket::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

tcp::endpoint endpointOf(std::uint16_t port) {
  return {asio::ip::address_v4::loopback(), port};
}

}  // namespace

struct RawClient::Implementation {
  asio::io_context context;
  websocket::stream<tcp::socket> socket{context};
  beast::flat_buffer buffer;
  unsigned status = 0;
  std::string text, protocol;
  Frame frame;
  std::atomic<int> pings{0};

  /// Runs what was begun, for half a minute at most.
  void finish() {
    context.restart();
    context.run_for(std::chrono::seconds(30));
  }
  void upgrade(const Options& options) {
    socket.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      if (!options.protocols.empty()) request.set(http::field::sec_websocket_protocol, options.protocols);
      for (const auto& [name, value] : options.fields) request.insert(name, value);
    }));
    socket.read_message_max(64U << 20U);
    socket.auto_fragment(false);
    socket.control_callback([this](websocket::frame_type type, beast::string_view) {
      if (type == websocket::frame_type::ping) ++pings;
    });
    websocket::response_type response;
    socket.async_handshake(response, "localhost", options.target, [](error_code) {});
    finish();
    status = response.result_int();
    protocol = std::string(response[http::field::sec_websocket_protocol]);
    text = response.body();
  }
  void get(const Options& options) {
    http::request<http::empty_body> request(http::verb::get, options.target, 11);
    http::response<http::string_body> response;
    error_code ignored;
    http::write(socket.next_layer(), request, ignored);
    http::async_read(socket.next_layer(), buffer, response, [](error_code, std::size_t) {});
    finish();
    status = response.result_int();
    text = response.body();
  }
};

RawClient::RawClient(std::uint16_t port, Options options)
    : implementation_(std::make_unique<Implementation>()) {
  tcp::socket& socket = implementation_->socket.next_layer();
  error_code error;
  socket.open(tcp::v4(), error);
  if (options.receiveBuffer > 0)
    socket.set_option(asio::socket_base::receive_buffer_size(options.receiveBuffer), error);
  socket.connect(endpointOf(port), error);
  if (error) return;
  socket.set_option(tcp::no_delay(true), error);
  options.isWebSocket ? implementation_->upgrade(options) : implementation_->get(options);
}

RawClient::~RawClient() = default;

unsigned RawClient::status() const {
  return implementation_->status;
}

const std::string& RawClient::text() const {
  return implementation_->text;
}

const std::string& RawClient::protocol() const {
  return implementation_->protocol;
}

void RawClient::send(const Frame& frame) {
  implementation_->socket.binary(frame.kind == FrameKind::kBinary);
  implementation_->socket.async_write(asio::buffer(frame.bytes), [](error_code, std::size_t) {});
  implementation_->finish();
}

void RawClient::sendRaw(const std::string& bytes) {
  error_code ignored;
  asio::write(implementation_->socket.next_layer(), asio::buffer(bytes), ignored);
}

const Frame* RawClient::receive() {
  Implementation& it = *implementation_;
  it.buffer.clear();
  bool isDone = false;
  it.socket.async_read(it.buffer, [&](error_code error, std::size_t) { isDone = !error; });
  it.finish();
  if (!isDone) return nullptr;
  it.frame.kind = it.socket.got_text() ? FrameKind::kText : FrameKind::kBinary;
  it.frame.bytes = beast::buffers_to_string(it.buffer.data());
  return &it.frame;
}

std::string RawClient::closeReason() {
  while (receive() != nullptr) {
  }
  const auto& reason = implementation_->socket.reason().reason;
  return {reason.data(), reason.size()};
}

int RawClient::pings() const {
  return implementation_->pings;
}

void RawClient::cut() {
  error_code ignored;
  implementation_->socket.next_layer().close(ignored);
}

std::string talkTcp(std::uint16_t port, const std::string& bytes) {
  asio::io_context context;
  tcp::socket socket(context);
  error_code error;
  std::string answer;
  socket.connect(endpointOf(port), error);
  asio::write(socket, asio::buffer(bytes), error);
  asio::async_read(socket, asio::dynamic_buffer(answer), [](error_code, std::size_t) {});
  context.run_for(std::chrono::seconds(30));
  return answer;
}

}  // namespace robotlink::websocket::test
