// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Connector.h"

#include <linux/sockios.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <thread>

#include "robotlink/base/Utf8.h"
#include "robotlink/base/bytes/LittleEndian.h"
#include "robotlink/foxglove/client/Distrust.h"
#include "robotlink/foxglove/client/Refusals.h"
#include "robotlink/foxglove/client/Upgrade.h"
#include "robotlink/foxglove/security/Tls.h"
#include "robotlink/foxglove/transport/TransportStream.h"

namespace robotlink::websocket {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using Failure = LinkWatch::Failure;

constexpr std::chrono::milliseconds kClientTick{10};
constexpr std::size_t kClientReadBytes = 256U << 10U;

}  // namespace

class ServerConnection;

/// The thread, and the one connection that there is at a time. All but constructor and destructor runs in the
/// thread.
class ConnectorThread {
 public:
  ConnectorThread(std::shared_ptr<Client> connectedClient, Connector::Options chosen);
  ~ConnectorThread();
  ConnectorThread(const ConnectorThread&) = delete;
  ConnectorThread& operator=(const ConnectorThread&) = delete;

  Instant now() const { return options.clock->now(); }
  /// The connection's reports.
  void failed(Failure failure, const std::string& reason, ServerObjection objection = {});
  void report();

  const std::shared_ptr<Client> client;
  const Connector::Options options;
  /// Null: not encrypted. An error: encryption is not possible.
  const Result<std::shared_ptr<asio::ssl::context>> tls;
  asio::io_context context{1};
  LinkWatch watch;

 private:
  static Connector::Options withClock(Connector::Options options) {
    if (!options.clock) options.clock = std::make_shared<const SteadyClock>();
    return options;
  }
  static Result<std::shared_ptr<asio::ssl::context>> tlsFor(const ServerUrl& url) {
    if (!url.isEncrypted) return nullptr;
    return makeClientTls();
  }
  void run();
  void tickLater();
  void tick();
  void connect();
  /// Connects once an address of the robot is known.
  void connectIfFound();
  void drop();

  asio::steady_timer timer_{context};
  /// The connection in progress, over all its attempts.
  std::shared_ptr<HostLookup> lookup_;
  /// The addresses from the newest successful lookup; later lookups may fail while the link is down.
  std::vector<std::string> addresses_;
  /// The objection of the newest failure.
  ServerObjection objection_;
  /// The index of the address that is tried next.
  std::size_t nextAddress_ = 0;
  /// Whether an address is waited for.
  bool isConnecting_ = false;
  std::shared_ptr<ServerConnection> connection_;
  /// No PacedThread: Asio's context waits for sockets and timers, and is what stops the thread.
  std::thread thread_;
};

/// A connection. With TLS its handshake comes first. In the thread, except leave().
class ServerConnection : public std::enable_shared_from_this<ServerConnection> {
 public:
  ServerConnection(ConnectorThread& thread, asio::ssl::context* tls)
      : thread_(thread),
        request_{thread.options.url, thread.options.token, thread.options.name, thread.options.messageBytes},
        socket_(TransportSocket(thread.context), tls) {}

  void start(const tcp::endpoint& to);
  void send();
  void ping();
  void pong();
  /// Closes the socket; nothing is called after this.
  void end();
  /// Says goodbye without waiting for anything, when the thread has ended.
  void leave();

 private:
  TransportStream& transport() { return socket_.next_layer(); }
  template <typename Function>
  auto handler(Function function) {
    return beast::bind_front_handler(function, shared_from_this());
  }
  void onConnected(error_code error);
  void onSecured(error_code error);
  void upgrade();
  void onUpgraded(error_code error);
  void read() { socket_.async_read_some(buffer_, kClientReadBytes, handler(&ServerConnection::onRead)); }
  void onRead(error_code error, std::size_t bytes);
  /// Whether the system holds as much unsent data as it may. It accepts more than
  /// TCP_NOTSENT_LOWAT if that can be added to a waiting segment, until writability is waited for.
  bool isFull();
  void onRoom(error_code error);
  void onSent(error_code error, std::size_t);
  void onPinged(error_code) { isPinging_ = false; }
  void onControl(websocket::frame_type kind, beast::string_view payload);
  void fail(Failure failure, const std::string& reason, const ServerObjection& objection = {}) {
    if (!hasEnded_) thread_.failed(failure, reason, objection);
  }

  ConnectorThread& thread_;
  const UpgradeRequest request_;
  ClientSocket socket_;
  websocket::response_type response_;
  beast::flat_buffer buffer_;
  std::optional<Frame> sending_;
  bool isOpen_ = false, isPinging_ = false, waitsForRoom_ = false, hasEnded_ = false;
};

void ServerConnection::start(const tcp::endpoint& to) {
  transport().socket().async_connect(to, handler(&ServerConnection::onConnected));
}

void ServerConnection::onConnected(error_code error) {
  if (hasEnded_) return;
  if (error)
    return fail(error == asio::error::timed_out ? Failure::kSilence : Failure::kEnded, whyNotReached(error));
  thread_.watch.stepDone(thread_.now());
  auto& socket = transport().socket();
  socket.set_option(tcp::no_delay(true), error);
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &thread_.options.unsentBytes,
               sizeof thread_.options.unsentBytes);
  if (!transport().isEncrypted()) return upgrade();
  transport().secure(asio::ssl::stream_base::client, handler(&ServerConnection::onSecured));
}

void ServerConnection::onSecured(error_code error) {
  if (hasEnded_) return;
  if (error) return fail(Failure::kEnded, whyNotSecured(error));
  const Connector::Options& options = thread_.options;
  const std::string fingerprint = peerFingerprint(transport().tls());
  const Distrust distrust =
      whyNotTrusted(hostOf(options.url), fingerprint, options.knownServers, options.isTrusted);
  if (!distrust.why.empty()) return fail(Failure::kRefused, distrust.why, distrust.objection);
  thread_.watch.stepDone(thread_.now());
  upgrade();
}

void ServerConnection::upgrade() {
  prepareUpgrade(socket_, request_);
  // Valid as long as the socket, which is this object's.
  socket_.control_callback(
      [this](websocket::frame_type kind, beast::string_view payload) { onControl(kind, payload); });
  socket_.async_handshake(response_, hostOf(request_.url), request_.url.target,
                          handler(&ServerConnection::onUpgraded));
}

void ServerConnection::onUpgraded(error_code error) {
  if (hasEnded_) return;
  if (const auto problem = problemWith(response_, error, request_))
    return fail(problem->failure, problem->reason, problem->objection);
  thread_.watch.stepDone(thread_.now());
  isOpen_ = true;
  thread_.client->opened();
  read();
}

void ServerConnection::onRead(error_code error, std::size_t bytes) {
  if (hasEnded_) return;
  const Connector::Options& options = thread_.options;
  // Another attempt would fail in the same way.
  if (error == websocket::error::message_too_big)
    return fail(Failure::kRefused, whyTooLong(options.messageBytes));
  // The error does not matter if the server has said why it ends the connection.
  if (const auto why = socket_.reason(); error && why.code != websocket::close_code::none)
    return fail(Failure::kEnded, why.code == websocket::close_code::too_big ? whyTooLongForThem()
                                                                            : whyClosed(why.reason.c_str()));
  if (error) return fail(Failure::kEnded, whyBroken(error));
  thread_.watch.heard(thread_.now());
  thread_.client->countBytes(bytes);
  if (socket_.got_text() && buffer_.size() > options.textBytes)
    return fail(Failure::kRefused,
                "the robot sends texts of more than " + std::to_string(options.textBytes >> 20U) + " MiB");
  if (!socket_.is_message_done()) return read();
  const auto data = buffer_.data();
  const FrameKind kind = socket_.got_text() ? FrameKind::kText : FrameKind::kBinary;
  const auto result = thread_.client->received(kind, {static_cast<const char*>(data.data()), data.size()});
  buffer_.consume(buffer_.size());
  if (buffer_.capacity() > 4 * kClientReadBytes) buffer_.shrink_to_fit();
  if (!result) return fail(Failure::kRefused, result.error().text);
  if (!thread_.watch.isGreeted() && thread_.client->isGreeted()) thread_.watch.greeted(thread_.now());
  read();
}

/// A ping carries the time at which it was sent, which the pong returns.
void ServerConnection::onControl(websocket::frame_type kind, beast::string_view payload) {
  const Instant now = thread_.now();
  thread_.watch.heard(now);
  if (kind != websocket::frame_type::pong || payload.size() != sizeof(std::int64_t)) return;
  const Duration sent(loadNumber<std::int64_t>(reinterpret_cast<const std::uint8_t*>(payload.data())));
  const Duration roundTrip = now.time_since_epoch() - sent;
  if (roundTrip >= Duration::zero() && roundTrip < std::chrono::minutes(1))
    thread_.client->setRoundTrip(roundTrip);
}

void ServerConnection::ping() {
  if (!isOpen_ || isPinging_ || hasEnded_) return;
  isPinging_ = true;
  std::array<std::uint8_t, sizeof(std::int64_t)> bytes{};
  storeNumber(bytes.data(), static_cast<std::int64_t>(thread_.now().time_since_epoch().count()));
  socket_.async_ping({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                     handler(&ServerConnection::onPinged));
}

void ServerConnection::pong() {
  if (!isOpen_ || isPinging_ || hasEnded_) return;
  isPinging_ = true;
  socket_.async_pong({}, handler(&ServerConnection::onPinged));
}

bool ServerConnection::isFull() {
  int bytes = 0;
  return ::ioctl(transport().socket().native_handle(), SIOCOUTQNSD, &bytes) == 0 &&
         bytes >= thread_.options.unsentBytes;
}

void ServerConnection::onRoom(error_code error) {
  waitsForRoom_ = false;
  if (hasEnded_) return;
  if (error) return fail(Failure::kEnded, whyBroken(error));
  send();
}

void ServerConnection::send() {
  if (!isOpen_ || sending_ || waitsForRoom_ || hasEnded_) return;
  if (isFull()) {
    waitsForRoom_ = true;
    transport().socket().async_wait(tcp::socket::wait_write, handler(&ServerConnection::onRoom));
    return;
  }
  sending_ = thread_.client->next();
  if (!sending_) return;
  socket_.binary(sending_->kind == FrameKind::kBinary);
  socket_.async_write(asio::buffer(sending_->bytes), handler(&ServerConnection::onSent));
}

void ServerConnection::onSent(error_code error, std::size_t) {
  if (hasEnded_) return;
  sending_.reset();
  if (error) return fail(Failure::kEnded, whyBroken(error));
  send();
}

void ServerConnection::end() {
  hasEnded_ = true;
  transport().close();
}

void ServerConnection::leave() {
  // "Going away" as a whole frame, masked with zeros, if none is half sent and the system takes it at once.
  constexpr std::uint8_t kGoingAway[] = {0x88, 0x82, 0, 0, 0, 0, 1001 >> 8, 1001 & 255};
  if (isOpen_ && !hasEnded_ && !sending_ && !isPinging_) transport().tryWrite(kGoingAway);
  end();
}

ConnectorThread::ConnectorThread(std::shared_ptr<Client> connectedClient, Connector::Options chosen)
    : client(std::move(connectedClient)),
      options(withClock(std::move(chosen))),
      tls(tlsFor(options.url)),
      watch(options.times, options.clock->now()) {
  client->setWake([this] {
    asio::post(context, [this] {
      if (connection_) connection_->send();
    });
  });
  asio::post(context, [this] { tick(); });
  thread_ = std::thread([this] { run(); });
}

void ConnectorThread::run() {
  while (!context.stopped()) {
    try {
      context.run();
    } catch (const std::exception& problem) {
      // For example, out of memory. The connection's state is unknown, so it is replaced by a new one.
      asio::post(context, [this, what = std::string(problem.what())] {
        failed(Failure::kEnded, "a message of the robot could not be handled: " + what);
      });
    }
  }
}

ConnectorThread::~ConnectorThread() {
  client->setWake({});
  context.stop();
  thread_.join();
  if (connection_) connection_->leave();
  client->lost();
}

void ConnectorThread::tickLater() {
  timer_.expires_after(kClientTick);
  timer_.async_wait([this](error_code) { tick(); });
}

void ConnectorThread::tick() {
  tickLater();  // first, so that ticking continues even if something below throws
  if (isConnecting_) connectIfFound();
  switch (watch.next(now())) {
    case LinkWatch::Action::kConnect:
      connect();
      break;
    case LinkWatch::Action::kPing:
      if (connection_) connection_->ping();
      break;
    case LinkWatch::Action::kPong:
      if (connection_) connection_->pong();
      break;
    case LinkWatch::Action::kGiveUp:
      drop();
      break;
    default:
      break;
  }
  report();
  client->tick();
  if (connection_) connection_->send();
}

void ConnectorThread::report() {
  // Another attempt does not change the server's objection until it succeeds or fails.
  const bool isConnected = watch.phase() == ConnectionState::Phase::kConnected;
  client->setLink(watch.phase(), watch.since(), watch.reason(), isConnected ? ServerObjection() : objection_);
}

void ConnectorThread::connect() {
  if (!tls) return failed(Failure::kRefused, tls.error().text);
  if (const std::string why = whyNoToken(options.token); !why.empty())
    return failed(Failure::kRefused, why, {ServerObjection::Kind::kToken});
  isConnecting_ = true;
  if (!lookup_) lookup_ = HostLookup::start(options.url.host, options.resolver);
  connectIfFound();
}

void ConnectorThread::connectIfFound() {
  if (const auto outcome = lookup_ ? lookup_->outcome() : std::nullopt) {
    lookup_.reset();
    if (*outcome)
      addresses_ = **outcome;
    else if (addresses_.empty())
      return failed(Failure::kEnded, outcome->error().text);
  }
  if (addresses_.empty()) return;
  isConnecting_ = false;
  error_code error;
  const auto address = asio::ip::make_address(addresses_[nextAddress_++ % addresses_.size()], error);
  watch.addressFound(now());
  connection_ = std::make_shared<ServerConnection>(*this, tls->get());
  connection_->start({address, options.url.port});
}

void ConnectorThread::failed(Failure failure, const std::string& reason, ServerObjection objection) {
  objection_ = std::move(objection);
  watch.failed(failure, reason, now());
  drop();
  report();
}

void ConnectorThread::drop() {
  isConnecting_ = false;
  // The connection that is being ended may be the caller.
  if (const auto connection = std::exchange(connection_, nullptr)) connection->end();
  client->lost();
}

Connector::Connector(std::shared_ptr<Client> client, Options options)
    : thread_(std::make_unique<ConnectorThread>(std::move(client), std::move(options))) {}

Connector::~Connector() = default;

}  // namespace robotlink::websocket
