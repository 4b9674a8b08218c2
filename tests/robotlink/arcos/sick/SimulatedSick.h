// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "robotlink/arcos/sick/SickTelegram.h"

/// A laser of the kind LMS 200 at the far end of a line: it answers as its description says, at the speed
/// that it has; bytes of another speed do not reach it, and what it sends then is noise. It sees something at
/// 1 + i / 100 m in reading i.
class SimulatedSick {
 public:
  using Bytes = std::vector<std::uint8_t>;

  int baud() const { return baud_; }
  bool isContinuous() const { return continuous_; }
  int readings() const { return halfDegrees_ ? 361 : 181; }
  /// How often its set-up was written to its memory.
  int written() const { return written_; }
  const Bytes& setup() const { return setup_; }
  void setSetup(std::size_t at, std::uint8_t value) { setup_[at] = value; }
  void setBaud(int baud) { baud_ = baud; }
  /// It says no to everything that changes it.
  void setRefusing(bool refusing) { refusing_ = refusing; }
  /// Switches it off and on again: it forgets its speed and its mode.
  void restart() {
    baud_ = 9600;
    continuous_ = loggedIn_ = false;
  }

  /// Bytes from the host, whose line has a speed; returns what it answers.
  Bytes take(std::span<const std::uint8_t> bytes, int lineBaud) {
    Bytes answers;
    if (lineBaud != baud_) return answers;
    parser_.push(bytes);
    while (const auto found = parser_.next()) {
      const auto* request = std::get_if<robotlink::arcos::SickTelegram>(&*found);
      if (request == nullptr) continue;
      answers.push_back(0x06);
      const Bytes reply = robotlink::arcos::sickReply(answerTo(*request));
      answers.insert(answers.end(), reply.begin(), reply.end());
    }
    return answers;
  }
  /// The bytes of a scan, if it sends any; noise if the line has another speed.
  Bytes scan(int lineBaud) const {
    if (!continuous_) return {};
    Bytes bytes = robotlink::arcos::sickReply(scanTelegram());
    if (lineBaud != baud_) {
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(bytes[i] * 7 + i);
    }
    return bytes;
  }
  double rangeOf(int reading) const {
    const double unit = setup_[6] == 1 ? 0.001 : 0.01;
    return unit * std::round((1 + reading / 100.0) / unit);
  }

 private:
  robotlink::arcos::SickTelegram scanTelegram() const {
    const int count = readings();
    const unsigned head = static_cast<unsigned>(count) | (setup_[6] == 1 ? 0x4000U : 0U);
    robotlink::arcos::SickTelegram telegram{.command = 0xB0, .data = {}};
    const auto add = [&](unsigned value) {
      telegram.data.push_back(static_cast<std::uint8_t>(value & 0xFFU));
      telegram.data.push_back(static_cast<std::uint8_t>(value >> 8U));
    };
    add(head);
    for (int i = 0; i < count; ++i)
      add(static_cast<unsigned>(std::lround(rangeOf(i) / (setup_[6] == 1 ? 0.001 : 0.01))));
    telegram.status = 0x10;
    return telegram;
  }

  robotlink::arcos::SickTelegram answerTo(const robotlink::arcos::SickTelegram& request) {
    robotlink::arcos::SickTelegram answer;
    answer.command = static_cast<std::uint8_t>(request.command | 0x80U);
    answer.status = 0x10;
    if (request.command == 0x20 && !request.data.empty()) {
      answer.data = {changeMode(request)};
    } else if (request.command == 0x3B && request.data.size() == 4) {
      if (!refusing_) halfDegrees_ = request.data[2] == 0x32;
      answer.data = {static_cast<std::uint8_t>(refusing_ ? 0 : 1)};
      answer.data.insert(answer.data.end(), request.data.begin(), request.data.end());
    } else if (request.command == 0x74) {
      answer.data = setup_;
    } else if (request.command == 0x77) {
      const bool allowed = loggedIn_ && !refusing_ && request.data.size() == setup_.size();
      if (allowed) setup_ = request.data;
      written_ += allowed ? 1 : 0;
      answer.data = {static_cast<std::uint8_t>(allowed ? 1 : 0)};
    }
    return answer;
  }

  std::uint8_t changeMode(const robotlink::arcos::SickTelegram& request) {
    constexpr std::uint8_t kDone = 0, kNotDone = 1;
    const std::string rest(request.data.begin() + 1, request.data.end());
    if (refusing_) return kNotDone;
    switch (request.data[0]) {
      case 0x00:
        loggedIn_ = rest == "SICK_LMS";
        return loggedIn_ ? kDone : kNotDone;
      case 0x24:
      case 0x25:
        continuous_ = request.data[0] == 0x24;
        loggedIn_ = false;
        return kDone;
      case 0x40:
        baud_ = 38400;
        return kDone;
      case 0x41:
        baud_ = 19200;
        return kDone;
      case 0x42:
        baud_ = 9600;
        return kDone;
      default:
        return kNotDone;
    }
  }

  robotlink::arcos::SickParser parser_{robotlink::arcos::SickParser::From::kHost};
  int baud_ = 9600;
  bool continuous_ = false, loggedIn_ = false, halfDegrees_ = false, refusing_ = false;
  int written_ = 0;
  Bytes setup_ = Bytes(34, 0);
};
