// SPDX-License-Identifier: GPL-3.0-or-later
// The HTTP upgrade of both ends, over sockets without a network: what a client asks a server that listens,
// and what a server answers to a client. The first byte says which, whether the server wants a token, and
// after how many bytes the rest comes later. In answers, "{accept}" becomes what belongs to the client's key.
#include <openssl/sha.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>

#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/client/Upgrade.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/server/ListenerPort.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/Demand.h"

namespace foxglove_handshake_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using namespace robotlink::websocket::test;

namespace {

/// In the first byte; the other bits are 64ths of the length.
constexpr unsigned kIsAnswer = 1, kWantsToken = 2;
constexpr char kToken[] = "secret";
/// The system's buffers hold as much.
constexpr std::size_t kMaxBytes = 8192;

/// The other end of a socket.
class FarEnd {
 public:
  explicit FarEnd(TransportSocket& near) {
    std::array<int, 2> ends{};
    demand(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0, "there are sockets");
    near.assign(asio::ip::tcp::v4(), ends[0]);
    end_ = ends[1];
  }
  ~FarEnd() { ::close(end_); }
  FarEnd(const FarEnd&) = delete;
  FarEnd& operator=(const FarEnd&) = delete;

  void write(std::string_view bytes) const {
    static_cast<void>(::send(end_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
  }
  void finish() const { ::shutdown(end_, SHUT_WR); }
  /// All that has come.
  std::string read() const {
    std::string all;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::recv(end_, part.data(), part.size(), MSG_DONTWAIT)) > 0;)
      all.append(part.data(), static_cast<std::size_t>(got));
    return all;
  }

 private:
  int end_ = -1;
};

void settle(asio::io_context& context) {
  context.restart();
  while (context.poll() > 0) context.restart();
}

/// Sends the bytes in two parts, and ends.
void say(const FarEnd& far, std::string_view bytes, std::size_t split, asio::io_context& context) {
  for (const std::string_view part : {bytes.substr(0, split), bytes.substr(split)}) {
    far.write(part);
    settle(context);
  }
  far.finish();
  settle(context);
}

void checkSentence(const std::string& sentence) {
  demand(!sentence.empty() && sentence == validUtf8(sentence) && sentence.size() < 1200, "it can be read");
  demand(sentence.find_first_of("\r\n\t") == std::string::npos, "it is one line");
}

void checkRequest(std::string_view bytes, std::size_t split, bool wantsToken) {
  ServerHandlers handlers;
  handlers.report = checkSentence;
  ServerOptions options;
  options.sessionId = "s";
  const auto server = Server::make(options, handlers);
  ListenerOptions listening;
  listening.clock = std::make_shared<ManualClock>();
  listening.messagesPerSecond = 0;  // time does not pass
  if (wantsToken) listening.admission.token = kToken;
  ListenerPort port(server, listening);
  TransportSocket near(port.context);
  const FarEnd far(near);
  port.add(makeConnection(port, std::move(near), nullptr));
  say(far, bytes, split, port.context);
  const std::string answer = far.read();
  demand(answer.empty() || answer.starts_with("HTTP/1."), "the answer is one of HTTP");
  if (answer.starts_with("HTTP/1.1 101")) {
    demand(answer.find("Sec-WebSocket-Protocol: foxglove.") != answer.npos, "a sub-protocol is chosen");
    demand(!wantsToken || bytes.find(kToken) != bytes.npos, "nobody comes in without the token");
  }
  demand(server->clients().empty(), "who has gone is no client");
}

/// What belongs to the key of a request.
std::string acceptFor(const std::string& request) {
  constexpr std::string_view kKey = "Sec-WebSocket-Key: ";
  const std::size_t begin = request.find(kKey);
  demand(begin != request.npos, "the client asks for a WebSocket");
  const std::size_t at = begin + kKey.size();
  const std::string text =
      request.substr(at, request.find('\r', at) - at) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  std::array<unsigned char, SHA_DIGEST_LENGTH> digest{};
  ::SHA1(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return toBase64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

void checkAnswer(std::string_view bytes, std::size_t split) {
  asio::io_context context{1};
  TransportSocket near(context);
  const FarEnd far(near);
  const UpgradeRequest request{{false, "red1", 8765, "/"}, kToken, "test", 1U << 20U};
  ClientSocket socket(std::move(near));
  prepareUpgrade(socket, request);
  boost::beast::websocket::response_type response;
  std::optional<error_code> end;
  socket.async_handshake(response, "red1:8765", "/", [&](error_code error) { end = error; });
  settle(context);
  const std::string asked = far.read();
  demand(asked.starts_with("GET / HTTP/1.1\r\n") && asked.ends_with("\r\n\r\n"), "the request is whole");
  std::string answer(bytes);
  constexpr std::string_view kAccept = "{accept}";
  if (const std::size_t at = answer.find(kAccept); at != answer.npos)
    answer.replace(at, kAccept.size(), acceptFor(asked));
  say(far, answer, std::min(split, answer.size()), context);
  demand(end.has_value(), "the handshake ends when the server has gone");
  if (const auto problem = problemWith(response, *end, request)) return checkSentence(problem->reason);
  demand(response.result_int() == 101, "only that status is a connection");
}

std::string input(unsigned head, const std::string& bytes) {
  return static_cast<char>(head) + bytes;
}

std::string requestWith(const std::string& fields, const std::string& target = "/") {
  return "GET " + target + " HTTP/1.1\r\nHost: red1:8765\r\n" + fields + "\r\n";
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const unsigned head = data[0];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, std::min(size - 1, kMaxBytes));
  const std::size_t split = bytes.size() * (head >> 2U) / 64;
  if ((head & kIsAnswer) != 0) {
    checkAnswer(bytes, split);
  } else {
    checkRequest(bytes, split, (head & kWantsToken) != 0);
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const std::string upgrade =
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  const std::string protocols = "Sec-WebSocket-Protocol: foxglove.websocket.v1, foxglove.sdk.v1\r\n";
  const std::string compression = "Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits\r\n";
  const std::string whole = requestWith(upgrade + protocols + compression + "User-Agent: a\xff\xc3\xbc\r\n");
  const std::string frame("\x81\x82\0\0\0\0{}", 8);
  const std::string accepted =
      "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Accept: {accept}\r\n";
  const unsigned half = 32U << 2U;
  return {
      input(0, whole),
      input(half, whole + frame),
      input(0, requestWith(upgrade + protocols + "Origin: http://evil\xff\t.example\r\n")),
      input(kWantsToken, whole),
      input(kWantsToken, requestWith(upgrade + protocols, "/?a=b&token=secret")),
      input(kWantsToken, requestWith(upgrade + protocols + "Authorization: Bearer secret\r\n")),
      input(0, requestWith(upgrade + "Sec-WebSocket-Protocol: x\r\nSec-WebSocket-Protocol: y\r\n")),
      input(0, requestWith(protocols)),
      input(0, "POST / HTTP/1.0\r\nContent-Length: 99999999999\r\n\r\nabc"),
      input(kIsAnswer, accepted + "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n" + frame),
      input(kIsAnswer | half, accepted + "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n" +
                                  "Sec-WebSocket-Extensions: permessage-deflate\r\n\r\n"),
      input(kIsAnswer, accepted + "Sec-WebSocket-Protocol: other\xff\r\n\r\n"),
      input(kIsAnswer, "HTTP/1.1 401 Unauthorized\r\nContent-Length: 6\r\n\r\ntoken\n"),
      input(kIsAnswer, "HTTP/1.1 503 Full\r\nTransfer-Encoding: chunked\r\n\r\n3\r\na\xff\n\r\n0\r\n\r\n"),
      input(kIsAnswer, "HTTP/1.1 200 OK\r\n\r\n<html>")};
}

const FuzzRegistration kTarget({"foxglove_handshake", &fuzzSeeds, &runInput});

}  // namespace foxglove_handshake_fuzz
