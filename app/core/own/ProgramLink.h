// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace google::protobuf {
class Message;
}

namespace app {

/// An end of the connection between a robot's program in a process of its own and its host: messages, each
/// behind its length in four bytes (little-endian), over a stream socket. Both ends are the same build, so a
/// message that cannot be read is as bad as an end of the connection. One thread at a time.
class ProgramLink {
 public:
  enum class Outcome { kDone, kTimeout, kEnded };

  /// Takes ownership of the socket; -1: there is none.
  explicit ProgramLink(int socket = -1);
  ~ProgramLink();
  ProgramLink(ProgramLink&& other) noexcept;
  ProgramLink& operator=(ProgramLink&& other) noexcept;

  /// Sends a message; waits for the other end to read as long as `limit` permits. What is left after a
  /// timeout is sent by the next call, of receive(), too.
  Outcome send(const google::protobuf::Message& message, std::chrono::milliseconds limit);
  /// Receives a message. After a timeout, what has arrived of it is kept for the next call.
  Outcome receive(google::protobuf::Message& message, std::chrono::milliseconds limit);
  /// Says that nothing more is sent, which ends the other end in an orderly way.
  void finish();

 private:
  using Time = std::chrono::steady_clock::time_point;
  /// Sends what is left; receives what is there.
  Outcome flush(Time end);
  Outcome fill(std::size_t size, Time end);
  /// Waits for the socket to be readable or writable.
  Outcome wait(short events, Time end) const;

  int socket_;
  std::string out_;
  std::size_t sent_ = 0;
  std::string in_;
};

}  // namespace app
