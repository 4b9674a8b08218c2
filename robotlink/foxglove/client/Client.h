// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <unordered_map>

#include "robotlink/foxglove/client/ClientOptions.h"

namespace robotlink::websocket {

/// The id of errors with which a service itself answered, or of a service that does not exist. Calls that got
/// no answer have other ids, and may be repeated.
inline constexpr char kServiceFailure[] = "foxglove.service";

/// The client's end of the Foxglove WebSocket protocol, without a transport: the requests to a server, its
/// offers, and the messages waiting to be sent to it. A Connector connects it with TCP, repeatedly; what was
/// asked for is asked for again at each connection.
///
/// The functions of the user's side may be called from any thread and never wait for the server.
class Client {
 public:
  /// The answer to a call of a service.
  struct Answer {
    std::string encoding, data;
  };
  /// Called once, in the link's thread or that of call(); the error says why there is no answer.
  using AnswerHandler = std::function<void(Result<Answer>)>;
  enum class Urgency {
    kNormal,
    kUrgent,  ///< before everything else that waits; also between the parts of a long call
  };
  struct Call {
    std::string service, encoding, payload;
    Urgency urgency = Urgency::kNormal;
    /// How long it may wait for a connection, and then for the answer.
    Duration connectionTime = std::chrono::seconds(2), answerTime = std::chrono::seconds(10);
  };

  /// `clock` is for waiting times and for the state.
  explicit Client(ClientHandlers handlers, ClientLimits limits = {},
                  std::shared_ptr<const Clock> clock = std::make_shared<const SteadyClock>());
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // The user's side. Requests hold until they are taken back, whatever the connection does.

  /// Subscribes to all channels of these topics, also those that will be advertised later.
  void subscribe(const std::set<std::string>& topics);
  void unsubscribe(const std::set<std::string>& topics);
  /// Subscribes to updates of all parameters, whose values come first.
  void subscribeParameters(bool wanted);
  void subscribeGraph(bool wanted);
  /// Sets the bytes a second that the server may send; 0 without limit. For servers that know `link/budget`.
  void setBudget(double bytesPerSecond);
  /// How many messages a second the server may send of each topic, if the latest one counts; topics that are
  /// not named are sent whole. For servers that know `link/rates`.
  void setRates(std::map<std::string, double> messagesPerSecond);
  /// Advertises a channel; a topic has one at most. publish() sends nothing unless it is connected.
  void advertise(ClientChannel channel);
  void unadvertise(const std::string& topic);
  /// Publishes a message, which replaces a waiting one of its topic. Returns false if nothing was sent.
  bool publish(const std::string& topic, std::string payload);

  // Requests that are made once.

  void call(Call call, AnswerHandler handler);
  /// Sets parameters. The new values come as parameters; if the server objects, as a status.
  void setParameters(std::vector<Parameter> parameters);
  void getParameters(std::vector<std::string> names);

  ConnectionState state() const;
  /// The messages of a topic that this client missed, as the server counts: replaced by newer ones, lost.
  struct Counters {
    std::uint64_t thinned = 0, dropped = 0;
  };
  /// The key is the topic; empty if the server does not count.
  std::map<std::string, Counters> counters() const;

  /// Return the current offers of the server.
  std::vector<Channel> channels() const;
  std::vector<Service> services() const;

  // The link's side: one thread, in which handlers are called.

  /// `wake` is called from any thread when there is something to send again after next() found nothing; it
  /// must not block or call the client. Empty: the link has ended.
  void setWake(std::function<void()> wake);
  /// Call this when a connection is open; the server will say hello.
  void opened();
  /// Takes a whole message. An error is a reason to end the connection.
  Result<void> received(FrameKind kind, std::string_view bytes);
  /// Returns the frame to send next.
  std::optional<Frame> next();
  /// Ends requests that wait too long. Call it several times a second.
  void tick();
  /// Ends the connection with the next message that comes, as an error of received() would.
  void end(const std::string& reason);
  /// Call this when the connection is lost, or could not be made.
  void lost();
  /// Sets the link's part of the state; this object has the rest.
  void setLink(ConnectionState::Phase phase, Instant since, std::string reason,
               ServerObjection objection = {});
  void setRoundTrip(Duration roundTrip);
  void countBytes(std::size_t bytes);
  /// Whether the server of this connection has said hello.
  bool isGreeted() const;

 private:
  using Calls = std::vector<std::function<void()>>;
  using OfferedChannel = std::shared_ptr<const Channel>;
  /// A call without an answer yet.
  struct PendingCall {
    Call call;
    AnswerHandler handler;
    Instant deadline;
    bool isSent = false;
  };
  /// The rest of a long call that is to be sent.
  struct LongCall {
    std::uint32_t service = 0, id = 0;
    std::size_t offset = 0;
  };
  /// The requests that hold as long as the client.
  struct Wishes {
    std::set<std::string> topics;
    bool parameters = false, graph = false;
    std::optional<double> budget;
    std::map<std::string, double> rates;
    std::map<std::string, ClientChannel> channels;
    std::uint32_t nextChannel = 1;
  };
  /// The state that ends with the connection.
  struct Conversation {
    bool isOpen = false;
    /// Whether the server has said hello.
    bool isGreeted = false;
    ServerInfo server;
    std::map<std::uint64_t, OfferedChannel> channels;
    std::size_t schemaBytes = 0, serviceSchemaBytes = 0;
    std::map<std::uint64_t, std::uint32_t> subscriptionOf;
    std::unordered_map<std::uint32_t, OfferedChannel> subscriptions;
    std::uint32_t nextSubscription = 1;
    std::map<std::string, Service> services;
    std::deque<Frame> urgent, waiting;
    std::deque<LongCall> longCalls;
    /// Messages of client channels, at most one each, and their order.
    std::map<std::string, Frame> published;
    std::deque<std::string> publishedOrder;
    std::size_t waitingBytes = 0;
    bool countsForUs = true;
    Instant countersAt;
    std::map<std::string, Counters> counters;
    std::string overflow;
  };

  bool can(const char* capability) const;
  void greet();
  void send(const ClientMessage& message, Urgency urgency = Urgency::kNormal);
  void wake();
  /// Whether there is something to send.
  bool hasWork() const;
  void subscribeAdvertised(const std::vector<OfferedChannel>& channels);
  void unsubscribeIds(const std::vector<std::uint64_t>& channels);
  void sendCall(std::uint32_t id, PendingCall& pending, const Service& service);
  void sendWaitingCalls();
  Frame nextPart();
  void finish(std::uint32_t id, Result<Answer> answer, Calls& calls);
  void failAll(Calls& calls, const std::function<bool(const PendingCall&)>& which, const std::string& why);
  void noteCounters(const Value& value);
  std::string reasonFor(const PendingCall& pending) const;

  // Handle the messages of servers. An error ends the connection.
  Result<void> handle(const ServerInfo& message, Calls& calls);
  Result<void> handle(const Status& message, Calls& calls);
  Result<void> handle(const RemoveStatus& message, Calls& calls);
  Result<void> handle(const Advertise& message, Calls& calls);
  Result<void> handle(const Unadvertise& message, Calls& calls);
  Result<void> handle(const ParameterValues& message, Calls& calls);
  Result<void> handle(const AdvertiseServices& message, Calls& calls);
  Result<void> handle(const UnadvertiseServices& message, Calls& calls);
  Result<void> handle(const ServiceCallFailure& message, Calls& calls);
  Result<void> handle(const ConnectionGraphUpdate& message, Calls& calls);
  Result<void> handle(const MessageData& message, Calls& calls);
  Result<void> handle(const Time& message, Calls& calls);
  Result<void> handle(const ServiceCallResponse& message, Calls& calls);
  Result<void> handle(const FetchAssetResponse& message, Calls& calls);
  Result<void> handle(const PlaybackState& message, Calls& calls);
  void remove(std::uint64_t channel, std::vector<Channel>& removed);

  const ClientHandlers handlers_;
  const ClientLimits limits_;
  const std::shared_ptr<const Clock> clock_;

  /// Protects everything below. Handlers are called without it.
  mutable std::mutex mutex_;
  Wishes wishes_;
  Conversation conversation_;
  std::map<std::uint32_t, PendingCall> calls_;
  std::uint32_t nextCall_ = 1;
  ConnectionState state_;
  /// Bytes until the second that bytesPerSecond is measured in.
  std::uint64_t countedBytes_ = 0;
  Instant countedAt_;
  std::function<void()> wake_;
  bool isIdle_ = true;
};

}  // namespace robotlink::websocket
