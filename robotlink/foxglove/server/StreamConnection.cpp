// SPDX-License-Identifier: GPL-3.0-or-later
// A WebSocket connection of a server, over TCP or TLS.
#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <chrono>

#include "robotlink/base/Printable.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/server/ListenerPort.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/transport/TransportStream.h"

namespace robotlink::websocket {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

/// A list, which may be spread over several fields of its name (RFC 6455, 11.3.4).
std::string listIn(const http::fields& fields, http::field name) {
  std::string all;
  const auto [begin, end] = fields.equal_range(name);
  for (auto at = begin; at != end; ++at) all += (all.empty() ? "" : ", ") + std::string(at->value());
  return all;
}

/// The connection of a client. With TLS its handshake comes first.
class StreamConnection final : public Connection, public std::enable_shared_from_this<StreamConnection> {
 public:
  /// Long messages are sent in frames that the line takes in kFrameTime, so that pongs can go between
  /// them.
  static constexpr std::size_t kMinFrameBytes = 16U << 10U, kMaxFrameBytes = 256U << 10U;
  static constexpr double kFrameTime = 0.005;  // s
  /// Messages of these sizes are compressed, where messages are. While a longer one is packed, other clients
  /// would wait.
  static constexpr std::size_t kCompressedBytes = 128, kMaxCompressedBytes = 8U << 20U;

  StreamConnection(ListenerPort& port, TransportSocket socket, asio::ssl::context* tls, bool isRefused)
      : port_(port),
        isRefused_(isRefused),
        from_(farEnd(socket)),
        machine_(farMachine(socket)),
        socket_(std::move(socket), tls),
        beganAt_(port.now()) {
    knock_.address = machine_;
    parser_.header_limit(kMaxHeader);
  }

  void start() override;
  bool isHandshake() const override { return state_ < State::kOpen; }
  const std::string& machine() const override { return machine_; }
  void tick(Instant now) override;
  void leave() override;
  void end() override;

 private:
  /// The clock for the line, which runs in real time, whatever the clock of the robot.
  using SystemTime = std::chrono::steady_clock;
  enum class State { kRequest, kDecision, kRefusal, kUpgrade, kOpen, kClosing, kEnded };
  static constexpr std::size_t kMaxHeader = 8192;
  static constexpr std::size_t kReadBytes = 256U << 10U;
  static constexpr std::size_t kMaxClientName = 100;

  TransportStream& transport() { return socket_.next_layer(); }
  template <typename Function>
  auto handler(Function function) {
    return beast::bind_front_handler(function, shared_from_this());
  }
  void onSecured(error_code error) { error || state_ == State::kEnded ? end() : readRequest(); }
  void readRequest() {
    http::async_read_header(transport(), buffer_, parser_, handler(&StreamConnection::onRequest));
  }
  void onRequest(error_code error, std::size_t bytes);
  void decide(Instant now);
  void refuse(const Refusal& refusal);
  void onRefused(error_code, std::size_t) { end(); }
  void upgrade(const std::string& protocol);
  void onOpen(error_code error);

  void read();
  void onRead(error_code error, std::size_t bytes);
  void send();
  void sendNext();
  void offerCompression();
  void onSent(error_code error, std::size_t bytes);
  /// Follows how fast the line takes messages.
  void fitFrames(std::size_t bytes);
  void noteHeard() {
    heardAt_ = port_.now();
    client_->heardAt = heardAt_.time_since_epoch().count();
  }
  Duration pingInterval() const {
    const Duration wanted(client_->pingEvery);
    const Duration usual = port_.options.pingInterval;
    return wanted > Duration::zero() ? std::min(wanted, usual) : usual;
  }
  void lookAtSilence(Instant now);
  void close(const std::string& reason);
  void onClosed(error_code) { end(); }
  void onPinged(error_code) { isPinging_ = false; }
  void reportEnd(const std::string& reason) {
    port_.report("The client at " + from_ + " was disconnected: " + reason);
  }

  ListenerPort& port_;
  const bool isRefused_;
  const std::string from_, machine_;
  beast::websocket::stream<TransportStream> socket_;
  State state_ = State::kRequest;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
  Knock knock_;
  ClientPtr client_;
  Allowance messages_;
  std::optional<Outgoing> sending_;
  SystemTime::time_point sendingAt_;
  bool isGreeted_ = false, isPinging_ = false, isReading_ = false, isInSend_ = false;
  /// When the handshake or, later, the conversation began; a byte was received; the message that is being
  /// read began; the client was told to go; and was asked for a sign of life.
  Instant beganAt_, heardAt_, messageAt_, closingAt_, pingedAt_;
};

void StreamConnection::start() {
  if (!transport().isEncrypted()) return readRequest();
  transport().secure(asio::ssl::stream_base::server, handler(&StreamConnection::onSecured));
}

void StreamConnection::onRequest(error_code error, std::size_t) {
  if (error || state_ == State::kEnded) return end();
  if (isRefused_)
    return refuse({426, "This robot's connections are encrypted: connect with wss:// instead of ws://."});
  const auto& request = parser_.get();
  const auto field = [&](http::field name) { return std::string(request[name]); };
  knock_.isWebSocket = beast::websocket::is_upgrade(request);
  knock_.protocols = listIn(request, http::field::sec_websocket_protocol);
  knock_.origin = field(http::field::origin);
  knock_.authorization = field(http::field::authorization);
  knock_.target = std::string(request.target());
  state_ = State::kDecision;
  decide(port_.now());
}

void StreamConnection::decide(Instant now) {
  if (now < port_.admission.decidableAt(knock_.address)) return;  // tick() comes back
  const auto decision = port_.admission.decide(knock_, now);
  if (const auto* refusal = std::get_if<Refusal>(&decision)) {
    port_.report("A client at " + from_ + " was refused: " + refusal->sentence);
    return refuse(*refusal);
  }
  ClientInfo info{0, from_,
                  printable(std::string(parser_.get()[http::field::user_agent]).substr(0, kMaxClientName)),
                  std::get<Admitted>(decision).isReadOnly};
  const auto wake = [weak = weak_from_this(), &context = port_.context] {
    asio::post(context, [weak] {
      if (const auto self = weak.lock()) self->send();
    });
  };
  auto client = port_.server->connect(std::move(info), wake);
  if (!client) {
    port_.report("A client at " + from_ + " was refused: " + client.error().text);
    return refuse({503, client.error().text});
  }
  client_ = *std::move(client);
  upgrade(std::get<Admitted>(decision).protocol);
}

void StreamConnection::refuse(const Refusal& refusal) {
  state_ = State::kRefusal;
  response_ = {static_cast<http::status>(refusal.status), parser_.get().version()};
  response_.set(http::field::content_type, "text/plain; charset=utf-8");
  response_.set(http::field::connection, "close");
  if (refusal.status == 401) response_.set(http::field::www_authenticate, "Bearer");
  if (refusal.status == 426) response_.set(http::field::upgrade, "websocket");
  response_.body() = refusal.sentence + "\n";
  response_.prepare_payload();
  http::async_write(transport(), response_, handler(&StreamConnection::onRefused));
}

void StreamConnection::upgrade(const std::string& protocol) {
  state_ = State::kUpgrade;
  // Until a pong went, nothing more is read.
  socket_.auto_fragment(true);
  socket_.write_buffer_bytes(kMinFrameBytes);
  socket_.read_message_max(port_.options.messageBytes);
  offerCompression();
  socket_.set_option(
      beast::websocket::stream_base::decorator([protocol](beast::websocket::response_type& response) {
        response.set(http::field::sec_websocket_protocol, protocol);
        response.set(http::field::server, "RobotControl");
      }));
  // Valid as long as the socket, which is this object's.
  socket_.control_callback([this](beast::websocket::frame_type, beast::string_view) { noteHeard(); });
  socket_.async_accept(parser_.get(), handler(&StreamConnection::onOpen));
}

/// A robot's messages repeat names, and its channels repeat schemas, so that slow links carry several times
/// as much.
void StreamConnection::offerCompression() {
  error_code error;
  const auto address = asio::ip::make_address(machine_, error);
  const bool isLoopback = !error && address.is_loopback();
  if (isLoopback && !port_.options.compressesLoopback) return;
  beast::websocket::permessage_deflate compression;
  compression.server_enable = true;
  compression.compLevel = 4;
  compression.memLevel = 8;
  compression.msg_size_threshold = kCompressedBytes;
  socket_.set_option(compression);
}

void StreamConnection::onOpen(error_code error) {
  if (error || state_ == State::kEnded) return end();
  state_ = State::kOpen;
  noteHeard();
  beganAt_ = heardAt_;
  messages_.setRate(port_.options.messagesPerSecond);
  buffer_ = {};
  read();
  tick(beganAt_);
}

void StreamConnection::read() {
  isReading_ = true;
  socket_.async_read_some(buffer_, kReadBytes, handler(&StreamConnection::onRead));
}

void StreamConnection::onRead(error_code error, std::size_t bytes) {
  isReading_ = false;
  if (error == beast::websocket::error::message_too_big)
    reportEnd("it sent a message longer than " + std::to_string(port_.options.messageBytes) + " bytes");
  if (error || state_ == State::kEnded) return end();
  noteHeard();
  if (buffer_.size() == bytes) messageAt_ = heardAt_;
  if (socket_.got_text() && buffer_.size() > port_.options.textBytes) {
    port_.server->disconnect(client_->info.id, "you sent a message longer than " +
                                                   std::to_string(port_.options.textBytes) + " bytes");
    buffer_.consume(buffer_.size());
  }
  if (!socket_.is_message_done()) return read();
  const auto data = buffer_.data();
  const FrameKind kind = socket_.got_text() ? FrameKind::kText : FrameKind::kBinary;
  if (state_ == State::kOpen)
    port_.server->received(client_, kind, {static_cast<const char*>(data.data()), data.size()});
  buffer_.consume(buffer_.size());
  if (buffer_.capacity() > 4 * kReadBytes) buffer_.shrink_to_fit();
  messages_.take(1);
  if (messages_.isReady(heardAt_)) read();  // otherwise tick() reads on
}

void StreamConnection::send() {
  if (isInSend_) return;
  isInSend_ = true;
  // Bytes that are gathered count as sent before async_write() returns.
  do sendNext();
  while (state_ == State::kOpen && !sending_ && transport().isGathering());
  isInSend_ = false;
}

void StreamConnection::sendNext() {
  if (!isGreeted_ || sending_ || state_ != State::kOpen) return;
  sending_ = port_.server->next(*client_, port_.now());
  transport().gather(sending_ && sending_->hasMore);
  if (!sending_) {
    transport().flush();
    if (const std::string reason = port_.server->closingReason(*client_); !reason.empty()) close(reason);
    return;
  }
  socket_.binary(sending_->kind == FrameKind::kBinary);
  socket_.compress(sending_->isCompressible && sending_->size() <= kMaxCompressedBytes);
  const std::array<asio::const_buffer, 2> parts{asio::buffer(sending_->head.data(), sending_->headSize),
                                                asio::buffer(*sending_->payload)};
  sendingAt_ = SystemTime::now();
  socket_.async_write(parts, handler(&StreamConnection::onSent));
}

void StreamConnection::fitFrames(std::size_t bytes) {
  if (bytes < kMinFrameBytes) return;
  const double seconds = std::chrono::duration<double>(SystemTime::now() - sendingAt_).count();
  const double most = seconds > 0 ? static_cast<double>(bytes) * kFrameTime / seconds : kMaxFrameBytes;
  socket_.write_buffer_bytes(
      static_cast<std::size_t>(std::clamp<double>(most, kMinFrameBytes, kMaxFrameBytes)));
}

void StreamConnection::onSent(error_code error, std::size_t bytes) {
  sending_.reset();
  if (!error) fitFrames(bytes);
  if (error || state_ == State::kEnded) return end();
  send();
}

void StreamConnection::tick(Instant now) {
  const ListenerOptions& options = port_.options;
  if (state_ < State::kOpen && now - beganAt_ > options.handshakeTime) {
    port_.report("A connection from " + from_ + " was closed, because its handshake took too long");
    return end();
  }
  if (state_ == State::kDecision) decide(now);
  if (state_ == State::kClosing && now - closingAt_ > options.closeTime) return end();
  if (state_ != State::kOpen) return;
  isGreeted_ = isGreeted_ || now - beganAt_ >= options.greetingDelay;
  send();
  if (state_ == State::kOpen && !isReading_ && messages_.isReady(now)) read();
  lookAtSilence(now);
}

void StreamConnection::lookAtSilence(Instant now) {
  const ListenerOptions& options = port_.options;
  const bool isSilent = now - heardAt_ > options.idleTime;
  const bool isTrickling = buffer_.size() > 0 && now - messageAt_ > options.messageTime;
  std::string reason = isSilent      ? "it was silent for too long"
                       : isTrickling ? "a message from it took too long"
                                     : port_.server->closingReason(*client_);
  // A client that is told to go, but does not take what is being sent, is waited for only a little.
  if (reason.empty()) closingAt_ = now;
  if (isSilent || isTrickling || now - closingAt_ > options.closeTime) {
    reportEnd(reason);
    return end();
  }
  if (isPinging_ || now - std::max(heardAt_, pingedAt_) < pingInterval() || state_ != State::kOpen) return;
  isPinging_ = true;
  pingedAt_ = now;
  socket_.async_ping({}, handler(&StreamConnection::onPinged));
}

void StreamConnection::close(const std::string& reason) {
  state_ = State::kClosing;
  closingAt_ = port_.now();
  reportEnd(reason);
  const std::string text = reason.substr(0, 120);  // the frame has 125 bytes
  socket_.async_close({beast::websocket::close_code::policy_error, validUtf8(text)},
                      handler(&StreamConnection::onClosed));
}

void StreamConnection::end() {
  if (state_ == State::kEnded) return;
  state_ = State::kEnded;
  const auto self = shared_from_this();
  transport().close();
  port_.remove(self);
  if (client_) port_.server->disconnected(client_);
}

void StreamConnection::leave() {
  // "Going away" as a whole frame, if none is half sent, and the system takes it at once.
  constexpr std::uint8_t kGoingAway[] = {0x88, 2, 1001 >> 8, 1001 & 255};
  if (state_ == State::kOpen && !sending_ && !isPinging_) transport().tryWrite(kGoingAway);
  transport().close();
  state_ = State::kEnded;
  if (client_) port_.server->disconnected(client_);
}

}  // namespace

ConnectionPtr makeConnection(ListenerPort& port, TransportSocket socket, asio::ssl::context* tls,
                             bool isRefused) {
  return std::make_shared<StreamConnection>(port, std::move(socket), tls, isRefused);
}

}  // namespace robotlink::websocket
