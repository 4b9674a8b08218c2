// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/Tls.h"

#include <openssl/ssl.h>

#include <boost/asio/buffer.hpp>

namespace robotlink::websocket {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using boost::system::error_code;

tl::unexpected<Error> tlsFailure(const error_code& error) {
  return failure("tls.setup", "connections cannot be encrypted: " + error.message(), {}, {error.message()});
}

error_code restrict(ssl::context& context) {
  SSL_CTX* handle = context.native_handle();
  error_code error;
  context.set_options(ssl::context::no_compression | ssl::context::default_workarounds, error);
  SSL_CTX_set_options(handle, SSL_OP_NO_RENEGOTIATION);
  // No session tickets: sessions are never resumed.
  SSL_CTX_set_options(handle, SSL_OP_NO_TICKET);
  SSL_CTX_set_session_cache_mode(handle, SSL_SESS_CACHE_OFF);
  SSL_CTX_set_num_tickets(handle, 0);
  if (!error && SSL_CTX_set_min_proto_version(handle, TLS1_2_VERSION) != 1)
    error = asio::error::make_error_code(asio::error::operation_not_supported);
  return error;
}

}  // namespace

Result<std::shared_ptr<ssl::context>> makeServerTls(const Certificate& certificate) {
  const auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  error_code error = restrict(*context);
  if (!error) context->use_certificate(asio::buffer(certificate.pem), ssl::context::pem, error);
  if (!error) context->use_private_key(asio::buffer(certificate.pem), ssl::context::pem, error);
  if (error) return tlsFailure(error);
  return context;
}

Result<std::shared_ptr<ssl::context>> makeClientTls() {
  const auto context = std::make_shared<ssl::context>(ssl::context::tls_client);
  error_code error = restrict(*context);
  if (!error) context->set_verify_mode(ssl::verify_none, error);
  if (error) return tlsFailure(error);
  return context;
}

std::string peerFingerprint(SSL* connection) {
  X509* const shown = SSL_get1_peer_certificate(connection);
  std::string fingerprint = fingerprintOf(shown);
  X509_free(shown);
  return fingerprint;
}

}  // namespace robotlink::websocket
