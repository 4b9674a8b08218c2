// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/sick/SickSession.h"

#include <algorithm>
#include <array>

namespace robotlink::arcos {
namespace {

struct Speed {
  int baud;
  std::uint8_t mode;
};
// A laser that was switched on talks at the first one.
constexpr std::array kSpeeds{Speed{9600, 0x42}, Speed{19200, 0x41}, Speed{38400, 0x40}};
constexpr std::uint8_t kMode = 0x20, kVariantCommand = 0x3B, kGetSetup = 0x74, kSetSetup = 0x77;
constexpr std::uint8_t kAnswer = 0x80;
constexpr std::uint8_t kLogInMode = 0x00, kContinuous = 0x24, kOnRequest = 0x25;
constexpr char kPassword[] = "SICK_LMS";
// Within the set-up, the bytes of the measuring mode and of the unit, and how long a set-up is at least.
constexpr std::size_t kModeByte = 5, kUnitByte = 6, kSetupBytes = 32;
constexpr std::uint8_t kUpTo80m = 0x00, kUpTo32m = 0x06;

constexpr Duration kAnswerTime = std::chrono::milliseconds(600);
// The variant and the set-up are written to the laser's memory.
constexpr Duration kSlowAnswerTime = std::chrono::seconds(8);
constexpr Duration kPause = std::chrono::seconds(1), kScanTime = std::chrono::seconds(2);
constexpr int kMaxTries = 2;

int knownBaud(int baud) {
  const bool known = std::ranges::find(kSpeeds, baud, &Speed::baud) != kSpeeds.end();
  return known ? baud : kSpeeds.back().baud;
}

}  // namespace

SickSession::SickSession(Options options) : options_(options) {
  options_.baud = knownBaud(options.baud);
  // The laser may still use the rate that an earlier session set.
  baud_ = options_.baud;
}

std::optional<SickSession::Line> SickSession::wantedLine() const {
  if (state_ == State::kPausing) return std::nullopt;
  return Line{baud_, number_};
}

void SickSession::reopen(int baud) {
  baud_ = baud;
  ++number_;
  open_ = false;
}

void SickSession::lineOpened(Instant now) {
  open_ = true;
  parser_.clear();
  outgoing_.clear();
  tries_ = 0;
  if (state_ == State::kSettingUp && step_ == Step::kStart) return ask(Step::kStart, now);
  state_ = State::kProbing;
  ask(Step::kStop, now);
}

void SickSession::lineLost(const Error& why, Instant now) {
  restart(why.text);
  state_ = State::kPausing;
  pausedUntil_ = now + kPause;
}

void SickSession::restart(const std::string& why) {
  problem_ = why;
  state_ = State::kProbing;
  probed_ = 0;
  tries_ = 0;
  reopen(options_.baud);
  parser_.clear();
  outgoing_.clear();
}

void SickSession::probe() {
  // The speed that is wanted has been tried first: the laser has it if a program ended here before.
  if (probed_ == kSpeeds.size()) {
    problem_ = options_.fixedSpeed
                   ? "the laser does not answer: is it switched on, and is this its line?"
                   : "the laser does not answer at 9600, 19200 or 38400 baud: is it switched on, and is this "
                     "its line?";
    probed_ = 0;
  }
  reopen(options_.fixedSpeed ? options_.baud : kSpeeds[probed_].baud);
  ++probed_;
}

void SickSession::ask(Step step, Instant now) {
  step_ = step;
  tries_ = 0;
  if (step != Step::kStop) state_ = State::kSettingUp;
  send(now);
}

void SickSession::send(Instant now) {
  ++tries_;
  asked_ = now;
  const std::vector<std::uint8_t> bytes = sickRequest(requestOf(step_));
  outgoing_.insert(outgoing_.end(), bytes.begin(), bytes.end());
}

SickTelegram SickSession::requestOf(Step step) const {
  switch (step) {
    case Step::kStop:
      return {.command = kMode, .data = {kOnRequest}};
    case Step::kVariant:  // 180 degrees, and the step in hundredths of a degree
      return {.command = kVariantCommand,
              .data = {0xB4, 0x00, static_cast<std::uint8_t>(options_.halfDegrees ? 0x32 : 0x64), 0x00}};
    case Step::kReadSetup:
      return {.command = kGetSetup, .data = {}};
    case Step::kLogIn: {
      SickTelegram request{.command = kMode, .data = {kLogInMode}};
      request.data.insert(request.data.end(), kPassword, kPassword + sizeof kPassword - 1);
      return request;
    }
    case Step::kWriteSetup:
      return {.command = kSetSetup, .data = setup_};
    case Step::kBaud:
      return {.command = kMode, .data = {std::ranges::find(kSpeeds, options_.baud, &Speed::baud)->mode}};
    case Step::kStart:
      break;
  }
  return {.command = kMode, .data = {kContinuous}};
}

Duration SickSession::patience() const {
  const bool isSlow = step_ == Step::kVariant || step_ == Step::kWriteSetup;
  return isSlow ? kSlowAnswerTime : kAnswerTime;
}

void SickSession::tick(Instant now) {
  if (state_ == State::kPausing && now >= pausedUntil_) state_ = State::kProbing;
  if (!open_) return;
  if (state_ == State::kRunning) {
    if (now - lastScan_ > kScanTime)
      restart("the laser has sent no scan for two seconds: is it switched on?");
    return;
  }
  if (now - asked_ < patience()) return;
  if (tries_ < kMaxTries) return send(now);
  if (state_ == State::kProbing) return probe();
  restart("the laser does not answer while it is set up");
}

void SickSession::take(std::span<const std::uint8_t> bytes, Instant now) {
  if (!open_) return;
  parser_.push(bytes);
  // A telegram may make it want another speed; the rest is not read at this one.
  while (open_) {
    const auto found = parser_.next();
    if (!found) break;
    if (const auto* telegram = std::get_if<SickTelegram>(&*found)) takeTelegram(*telegram, now);
  }
}

void SickSession::takeTelegram(const SickTelegram& telegram, Instant now) {
  if (auto readings = sickReadings(telegram, bits())) {
    if (state_ != State::kRunning) return;  // a scan from before the setup
    lastScan_ = now;
    ++scans_;
    // Ten bits a byte, and eight bytes around the data.
    const double bits = 10.0 * static_cast<double>(telegram.data.size() + 8);
    scan_ = Scan{now - fromSeconds(bits / baud_), std::move(*readings)};
    return;
  }
  const bool isAnswer = state_ == State::kProbing || state_ == State::kSettingUp;
  if (isAnswer && telegram.command == (requestOf(step_).command | kAnswer)) answered(telegram, now);
}

void SickSession::answered(const SickTelegram& telegram, Instant now) {
  const int result = telegram.data.empty() ? -1 : telegram.data.front();
  // Modes are confirmed by 0, the variant and the set-up by 1.
  const bool isMode = requestOf(step_).command == kMode;
  if (step_ != Step::kReadSetup && result != (isMode ? 0 : 1))
    return restart("the laser refuses to be set up");
  switch (step_) {
    case Step::kStop:
      return ask(Step::kVariant, now);
    case Step::kVariant:
      return ask(Step::kReadSetup, now);
    case Step::kReadSetup:
      return compareSetup(telegram, now);
    case Step::kLogIn:
      return ask(Step::kWriteSetup, now);
    case Step::kWriteSetup:
      return ask(baud_ == options_.baud ? Step::kStart : Step::kBaud, now);
    case Step::kBaud:
      step_ = Step::kStart;
      return reopen(options_.baud);
    case Step::kStart:
      break;
  }
  state_ = State::kRunning;
  problem_.clear();
  probed_ = 0;
  lastScan_ = now;
  ++starts_;
}

void SickSession::compareSetup(const SickTelegram& telegram, Instant now) {
  if (telegram.data.size() < kSetupBytes) return restart("the laser is of an unknown type");
  setup_ = telegram.data;
  const bool fine = options_.unit == Unit::kMillimeters;
  setup_[kModeByte] = fine ? kUpTo32m : kUpTo80m;
  setup_[kUnitByte] = fine ? 1 : 0;
  // The memory of the laser wears out, so it is only written to if something changes.
  if (setup_ != telegram.data) return ask(Step::kLogIn, now);
  ask(baud_ == options_.baud ? Step::kStart : Step::kBaud, now);
}

void SickSession::end() {
  if (!open_) return;
  outgoing_ = sickRequest(requestOf(Step::kStop));
}

SickSession::Counters SickSession::counters() const {
  return {scans_, starts_, parser_.counters()};
}

std::string SickSession::describe() const {
  if (state_ == State::kRunning) return "the laser sends scans";
  if (!problem_.empty()) return problem_;
  return state_ == State::kSettingUp ? "the laser is set up" : "the laser is looked for";
}

}  // namespace robotlink::arcos
