// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/foxglove/TlsClient.h"

#include <openssl/ssl.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "robotlink/foxglove/security/Tls.h"

namespace robotlink::websocket::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using boost::system::error_code;

}  // namespace

struct TlsClient::Implementation {
  asio::io_context context;
  std::shared_ptr<asio::ssl::context> tls = makeClientTls().value();
  beast::websocket::stream<beast::ssl_stream<tcp::socket>> socket{context, *tls};
  beast::flat_buffer buffer;
  bool isSecured = false;
  unsigned status = 0;
  std::string text;
  Frame frame;

  void finish() {
    context.restart();
    context.run_for(std::chrono::seconds(30));
  }
  void connect(std::uint16_t port, const Options& options) {
    SSL* handle = socket.next_layer().native_handle();
    if (options.maxVersion != 0) {
      SSL_set_min_proto_version(handle, 0);
      SSL_set_max_proto_version(handle, options.maxVersion);
      SSL_set_security_level(handle, 0);
    }
    error_code error;
    beast::get_lowest_layer(socket).connect({asio::ip::address_v4::loopback(), port}, error);
    if (error) return;
    socket.next_layer().async_handshake(asio::ssl::stream_base::client,
                                        [this](error_code failed) { isSecured = !failed; });
    finish();
    if (isSecured) upgrade(options);
  }
  void upgrade(const Options& options) {
    socket.set_option(beast::websocket::stream_base::decorator([&](beast::websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol, kSdkProtocol);
      for (const auto& [name, value] : options.fields) request.set(name, value);
    }));
    beast::websocket::response_type response;
    socket.async_handshake(response, "localhost", options.target, [](error_code) {});
    finish();
    status = response.result_int();
    text = response.body();
  }
};

TlsClient::TlsClient(std::uint16_t port, Options options)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->connect(port, options);
}

TlsClient::~TlsClient() = default;

bool TlsClient::isSecured() const {
  return implementation_->isSecured;
}

std::string TlsClient::version() const {
  return SSL_get_version(implementation_->socket.next_layer().native_handle());
}

std::string TlsClient::fingerprint() const {
  return peerFingerprint(implementation_->socket.next_layer().native_handle());
}

unsigned TlsClient::status() const {
  return implementation_->status;
}

const std::string& TlsClient::text() const {
  return implementation_->text;
}

void TlsClient::send(const ClientMessage& message) {
  const Frame frame = encode(message);
  implementation_->socket.binary(frame.kind == FrameKind::kBinary);
  implementation_->socket.async_write(asio::buffer(frame.bytes), [](error_code, std::size_t) {});
  implementation_->finish();
}

const Frame* TlsClient::receive() {
  Implementation& it = *implementation_;
  it.buffer.clear();
  bool isDone = false;
  it.socket.async_read(it.buffer, [&](error_code error, std::size_t) { isDone = !error; });
  it.finish();
  if (!isDone) return nullptr;
  it.frame = {it.socket.got_text() ? FrameKind::kText : FrameKind::kBinary,
              beast::buffers_to_string(it.buffer.data())};
  return &it.frame;
}

bool TlsClient::renegotiates() {
  SSL* handle = implementation_->socket.next_layer().native_handle();
  if (SSL_renegotiate(handle) != 1) return false;
  bool agreed = false;
  implementation_->socket.next_layer().async_handshake(asio::ssl::stream_base::client,
                                                       [&](error_code failed) { agreed = !failed; });
  implementation_->finish();
  return agreed;
}

}  // namespace robotlink::websocket::test
