// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Listener.h"

#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <set>
#include <thread>

#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/server/ServedClient.h"

namespace robotlink::websocket {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
// With the executor's own type calls are direct.
using Executor = asio::io_context::executor_type;
using Socket = asio::basic_stream_socket<tcp, Executor>;
using Acceptor = asio::basic_socket_acceptor<tcp, Executor>;

/// How often times and budgets are looked at while there are connections.
constexpr std::chrono::milliseconds kTick{20};
constexpr std::size_t kMaxHeader = 8192;
constexpr std::size_t kReadBytes = 64U << 10U;
constexpr std::size_t kMaxClientName = 100;

std::string describe(const tcp::endpoint& endpoint) {
  return toString(ListenAddress{endpoint.address().to_string(), endpoint.port()});
}

tl::unexpected<Error> cannotListen(const ListenAddress& address, const error_code& error) {
  const std::string where = toString(address);
  std::string advice = error.message() + "; choose another address or port";
  if (error == asio::error::address_in_use)
    advice = "another program listens there: end it, or choose another port (0 takes any that is free)";
  if (error == boost::system::errc::address_not_available)
    advice =
        "this machine does not have that address: 127.0.0.1 is for programs on this machine, 0.0.0.0 for all "
        "networks";
  if (error == asio::error::access_denied)
    advice = "ports below 1024 need special rights: choose a higher one";
  return failure("foxglove.listen", "clients cannot connect at " + where + ": " + advice, {}, {where});
}

/// A connection as the port sees it, whatever stream is below it. In the port's thread, but for leave().
class Connection {
 public:
  Connection() = default;
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  virtual void start() = 0;
  /// Looks at the times.
  virtual void tick(Instant now) = 0;
  /// Says goodbye without waiting for anything, when the port's thread has ended.
  virtual void leave() = 0;
  virtual bool isHandshake() const = 0;
};

}  // namespace

/// The listening socket, its thread, and the connections. All but the constructor, open() and the destructor
/// runs in the thread.
class ListenerPort {
 public:
  ListenerPort(std::shared_ptr<Server> servedServer, Listener::Options chosen)
      : server(std::move(servedServer)),
        options(withClock(std::move(chosen))),
        admission(options.admission) {}
  ~ListenerPort() {
    context.stop();
    if (thread_.joinable()) thread_.join();
    for (const auto& connection : std::exchange(connections_, {})) connection->leave();
  }
  ListenerPort(const ListenerPort&) = delete;
  ListenerPort& operator=(const ListenerPort&) = delete;

  Result<void> open();
  ListenAddress address() const {
    error_code ignored;
    return {options.address.address, acceptor_.local_endpoint(ignored).port()};
  }
  Instant now() const { return options.clock->now(); }
  void remove(const std::shared_ptr<Connection>& connection) { connections_.erase(connection); }

  const std::shared_ptr<Server> server;
  const Listener::Options options;
  Admission admission;
  asio::io_context context{1};

 private:
  static Listener::Options withClock(Listener::Options options) {
    if (!options.clock) options.clock = std::make_shared<const SteadyClock>();
    return options;
  }
  void accept();
  void welcome(Socket socket);
  void tickLater();

  Acceptor acceptor_{context};
  asio::steady_timer timer_{context};
  bool isTicking_ = false, isAccepting_ = false;
  std::set<std::shared_ptr<Connection>> connections_;
  std::thread thread_;
};

namespace {

/// One client's connection. For TLS the stream is an ssl::stream of the socket, whose handshake comes first
/// in start().
template <typename Stream>
class StreamConnection final : public Connection,
                               public std::enable_shared_from_this<StreamConnection<Stream>> {
 public:
  StreamConnection(ListenerPort& port, Stream stream, const tcp::endpoint& from)
      : port_(port), socket_(std::move(stream)), from_(describe(from)), beganAt_(port.now()) {
    knock_.address = from.address().to_string();
    parser_.header_limit(kMaxHeader);
  }

  void start() override {
    http::async_read_header(socket_.next_layer(), buffer_, parser_, handler(&StreamConnection::onRequest));
  }
  bool isHandshake() const override { return state_ < State::kOpen; }
  void tick(Instant now) override;
  void leave() override;

 private:
  enum class State { kRequest, kDecision, kRefusal, kUpgrade, kOpen, kClosing, kEnded };

  template <typename Function>
  auto handler(Function function) {
    return beast::bind_front_handler(function, this->shared_from_this());
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
  void cork(bool isOn);
  void onSent(error_code error, std::size_t bytes);
  void lookAtSilence(Instant now);
  void close(const std::string& reason);
  void onClosed(error_code) { end(); }
  void onPinged(error_code) { isPinging_ = false; }
  void reportEnd(const std::string& reason) {
    port_.server->report("The client at " + from_ + " was disconnected: " + reason);
  }
  void end();

  ListenerPort& port_;
  websocket::stream<Stream> socket_;
  const std::string from_;
  State state_ = State::kRequest;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
  Knock knock_;
  ClientPtr client_;
  Allowance messages_;
  std::optional<Outgoing> sending_;
  bool isGreeted_ = false, isPinging_ = false, isReading_ = false, isCorked_ = false;
  /// When the handshake or, later, the conversation began; something was heard; the message that is being
  /// read began; the client was told to go; and was asked for a sign of life.
  Instant beganAt_, heardAt_, messageAt_, closingAt_, pingedAt_;
};

template <typename Stream>
void StreamConnection<Stream>::onRequest(error_code error, std::size_t) {
  if (error) return end();
  const auto& request = parser_.get();
  const auto field = [&](http::field name) { return std::string(request[name]); };
  knock_.isWebSocket = websocket::is_upgrade(request);
  knock_.protocols = field(http::field::sec_websocket_protocol);
  knock_.origin = field(http::field::origin);
  knock_.authorization = field(http::field::authorization);
  knock_.target = std::string(request.target());
  state_ = State::kDecision;
  decide(port_.now());
}

template <typename Stream>
void StreamConnection<Stream>::decide(Instant now) {
  if (now < port_.admission.decidableAt(knock_.address)) return;  // tick() comes back
  const auto decision = port_.admission.decide(knock_, now);
  if (const auto* refusal = std::get_if<Refusal>(&decision)) {
    port_.server->report("A client at " + from_ + " was refused: " + refusal->sentence);
    return refuse(*refusal);
  }
  ClientInfo info{0, from_,
                  validUtf8(std::string(parser_.get()[http::field::user_agent]).substr(0, kMaxClientName))};
  const auto wake = [weak = this->weak_from_this(), &context = port_.context] {
    asio::post(context, [weak] {
      if (const auto self = weak.lock()) self->send();
    });
  };
  auto client = port_.server->connect(std::move(info), wake);
  if (!client) return refuse({503, client.error().text});
  client_ = *std::move(client);
  upgrade(std::get<std::string>(decision));
}

template <typename Stream>
void StreamConnection<Stream>::refuse(const Refusal& refusal) {
  state_ = State::kRefusal;
  response_ = {static_cast<http::status>(refusal.status), parser_.get().version()};
  response_.set(http::field::content_type, "text/plain; charset=utf-8");
  response_.set(http::field::connection, "close");
  if (refusal.status == 401) response_.set(http::field::www_authenticate, "Bearer");
  if (refusal.status == 426) response_.set(http::field::upgrade, "websocket");
  response_.body() = refusal.sentence + "\n";
  response_.prepare_payload();
  http::async_write(socket_.next_layer(), response_, handler(&StreamConnection::onRefused));
}

template <typename Stream>
void StreamConnection<Stream>::upgrade(const std::string& protocol) {
  state_ = State::kUpgrade;
  socket_.auto_fragment(false);
  socket_.read_message_max(port_.options.messageBytes);
  socket_.set_option(websocket::stream_base::decorator([protocol](websocket::response_type& response) {
    response.set(http::field::sec_websocket_protocol, protocol);
    response.set(http::field::server, "RobotControl");
  }));
  // Valid as long as the socket, which is this object's.
  socket_.control_callback([this](websocket::frame_type, beast::string_view) { heardAt_ = port_.now(); });
  socket_.async_accept(parser_.get(), handler(&StreamConnection::onOpen));
}

template <typename Stream>
void StreamConnection<Stream>::onOpen(error_code error) {
  if (error || state_ == State::kEnded) return end();
  state_ = State::kOpen;
  beganAt_ = heardAt_ = port_.now();
  messages_.setRate(port_.options.messagesPerSecond);
  buffer_ = {};
  read();
  tick(beganAt_);
}

template <typename Stream>
void StreamConnection<Stream>::read() {
  isReading_ = true;
  socket_.async_read_some(buffer_, kReadBytes, handler(&StreamConnection::onRead));
}

template <typename Stream>
void StreamConnection<Stream>::onRead(error_code error, std::size_t bytes) {
  isReading_ = false;
  if (error || state_ == State::kEnded) return end();
  heardAt_ = port_.now();
  if (buffer_.size() == bytes) messageAt_ = heardAt_;
  if (socket_.got_text() && buffer_.size() > port_.options.textBytes) {
    port_.server->disconnect(client_->info.id, "a message of yours is longer than " +
                                                   std::to_string(port_.options.textBytes) + " bytes");
    buffer_.consume(buffer_.size());
  }
  if (!socket_.is_message_done()) return read();
  const auto data = buffer_.data();
  const FrameKind kind = socket_.got_text() ? FrameKind::kText : FrameKind::kBinary;
  if (state_ == State::kOpen)
    port_.server->received(client_, kind, {static_cast<const char*>(data.data()), data.size()});
  buffer_.consume(buffer_.size());
  if (buffer_.capacity() > kReadBytes) buffer_.shrink_to_fit();
  messages_.take(1);
  if (messages_.isReady(heardAt_)) read();  // otherwise tick() reads on
}

template <typename Stream>
void StreamConnection<Stream>::send() {
  if (!isGreeted_ || sending_ || state_ != State::kOpen) return;
  sending_ = port_.server->next(*client_, port_.now());
  cork(sending_ && sending_->hasMore);
  if (!sending_) {
    if (const std::string reason = port_.server->closingReason(*client_); !reason.empty()) close(reason);
    return;
  }
  socket_.binary(sending_->kind == FrameKind::kBinary);
  const std::array<asio::const_buffer, 2> parts{asio::buffer(sending_->head.data(), sending_->headSize),
                                                asio::buffer(*sending_->payload)};
  socket_.async_write(parts, handler(&StreamConnection::onSent));
}

/// While there is more to send, the system fills its packets, which makes small messages twice as fast.
template <typename Stream>
void StreamConnection<Stream>::cork(bool isOn) {
  if (isCorked_ == isOn) return;
  isCorked_ = isOn;
  const int value = isOn ? 1 : 0;
  ::setsockopt(beast::get_lowest_layer(socket_).native_handle(), IPPROTO_TCP, TCP_CORK, &value, sizeof value);
}

template <typename Stream>
void StreamConnection<Stream>::onSent(error_code error, std::size_t) {
  sending_.reset();
  if (error || state_ == State::kEnded) return end();
  send();
}

template <typename Stream>
void StreamConnection<Stream>::tick(Instant now) {
  const Listener::Options& options = port_.options;
  if (state_ < State::kOpen && now - beganAt_ > options.handshakeTime) {
    port_.server->report("A connection from " + from_ + " was closed, because its handshake took too long");
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

template <typename Stream>
void StreamConnection<Stream>::lookAtSilence(Instant now) {
  const Listener::Options& options = port_.options;
  const bool isSilent = now - heardAt_ > options.idleTime;
  const bool isTrickling = buffer_.size() > 0 && now - messageAt_ > options.messageTime;
  std::string reason = isSilent      ? "nothing was heard of it"
                       : isTrickling ? "a message of it took too long"
                                     : port_.server->closingReason(*client_);
  // A client that is told to go, but does not take what is being sent, is waited for only a little.
  if (reason.empty()) closingAt_ = now;
  if (isSilent || isTrickling || now - closingAt_ > options.closeTime) {
    reportEnd(reason);
    return end();
  }
  if (isPinging_ || now - std::max(heardAt_, pingedAt_) < options.pingInterval || state_ != State::kOpen)
    return;
  isPinging_ = true;
  pingedAt_ = now;
  socket_.async_ping({}, handler(&StreamConnection::onPinged));
}

template <typename Stream>
void StreamConnection<Stream>::close(const std::string& reason) {
  state_ = State::kClosing;
  closingAt_ = port_.now();
  reportEnd(reason);
  const std::string text = reason.substr(0, 120);  // the frame has 125 bytes
  socket_.async_close({websocket::close_code::policy_error, validUtf8(text)},
                      handler(&StreamConnection::onClosed));
}

template <typename Stream>
void StreamConnection<Stream>::end() {
  if (state_ == State::kEnded) return;
  state_ = State::kEnded;
  const auto self = this->shared_from_this();
  error_code ignored;
  beast::get_lowest_layer(socket_).close(ignored);
  port_.remove(self);
  if (client_) port_.server->disconnected(client_);
}

template <typename Stream>
void StreamConnection<Stream>::leave() {
  // "Going away" as a whole frame, if none is half sent, and the system takes it at once.
  constexpr std::uint8_t kGoingAway[] = {0x88, 2, 1001 >> 8, 1001 & 255};
  auto& socket = beast::get_lowest_layer(socket_);
  if (state_ == State::kOpen && !sending_ && !isPinging_)
    static_cast<void>(
        ::send(socket.native_handle(), kGoingAway, sizeof kGoingAway, MSG_DONTWAIT | MSG_NOSIGNAL));
  error_code ignored;
  socket.close(ignored);
  state_ = State::kEnded;
  if (client_) port_.server->disconnected(client_);
}

}  // namespace

Result<void> ListenerPort::open() {
  error_code error;
  const auto address = asio::ip::make_address(options.address.address, error);
  if (error)
    return failure(
        "foxglove.listen",
        "'" + options.address.address + "' is no IP address: write one of this machine, such as 127.0.0.1",
        {}, {options.address.address});
  const tcp::endpoint endpoint(address, options.address.port);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return cannotListen(options.address, error);
  accept();
  thread_ = std::thread([this] { context.run(); });
  return {};
}

void ListenerPort::accept() {
  isAccepting_ = true;
  acceptor_.async_accept([this](error_code error, Socket socket) {
    isAccepting_ = false;
    if (!error) {
      welcome(std::move(socket));
      accept();
    }
    tickLater();  // which tries again: the program may have too many files open
  });
}

void ListenerPort::welcome(Socket socket) {
  error_code error;
  const tcp::endpoint from = socket.remote_endpoint(error);
  const auto handshakes = std::ranges::count_if(connections_, [](const auto& c) { return c->isHandshake(); });
  if (error || static_cast<std::size_t>(handshakes) >= options.handshakes) return;
  socket.set_option(tcp::no_delay(true), error);
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &options.unsentBytes,
               sizeof options.unsentBytes);
  const auto connection = std::make_shared<StreamConnection<Socket>>(*this, std::move(socket), from);
  connections_.insert(connection);
  connection->start();
}

void ListenerPort::tickLater() {
  if (isTicking_ || (connections_.empty() && isAccepting_)) return;
  isTicking_ = true;
  timer_.expires_after(kTick);
  timer_.async_wait([this](error_code) {
    isTicking_ = false;
    const auto connections = connections_;  // some end meanwhile
    for (const auto& connection : connections) connection->tick(now());
    if (!isAccepting_) accept();
    tickLater();
  });
}

Listener::Listener(std::unique_ptr<ListenerPort> port) : port_(std::move(port)), address_(port_->address()) {}

Listener::~Listener() = default;

Result<std::unique_ptr<Listener>> Listener::open(std::shared_ptr<Server> server, Options options) {
  auto port = std::make_unique<ListenerPort>(std::move(server), std::move(options));
  if (auto opened = port->open(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Listener>(new Listener(std::move(port)));
}

}  // namespace robotlink::websocket
