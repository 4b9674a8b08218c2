// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/ProgramPresence.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <mutex>
#include <random>
#include <set>
#include <thread>

#include "robotlink/dds/Wire.h"

namespace robotlink::dds {
namespace {

/// Programs of one network find each other in less than a third of it.
constexpr std::chrono::milliseconds kClaimTime{300};
constexpr std::chrono::milliseconds kClaimLook{10};

/// The kinds of samples: a program wants the name, or has it.
enum class Claim : std::uint8_t { kWanted = 1, kHeld = 2 };

std::string presenceTopic(const std::string& robot) {
  return "robotcontrol/" + robot + "/programs";
}

std::uint64_t randomNumber() {
  std::random_device device;
  return (std::uint64_t{device()} << 32U) | device();
}

}  // namespace

struct ProgramPresence::Implementation {
  explicit Implementation(Identity given) : identity(std::move(given)) {}

  void announce(Claim claim) const;
  /// Returns the place of a program with more right to the name; empty: none has been heard.
  std::string superior();
  /// Reports those that have the same name, each once.
  void watch();

  const Identity identity;
  const std::uint64_t number = randomNumber();
  std::function<void(const std::string& text)> report;
  std::mutex mutex;  // protects the following two
  Sample sample;
  std::set<std::string> reported;
  std::shared_ptr<Node> node;
  Entity writer;
  Entity reader;  // last, so that it is deleted first, which waits for its listener
};

void ProgramPresence::Implementation::announce(Claim claim) const {
  const std::string none;
  write(writer.get(), {.name = identity.program,
                       .type = none,
                       .sender = identity.where,
                       .number = number,
                       .kind = static_cast<std::uint8_t>(claim)});
}

std::string ProgramPresence::Implementation::superior() {
  const std::lock_guard lock(mutex);
  while (take(reader.get(), sample)) {
    const auto& other = sample.package;
    if (other.name != identity.program || other.sender == identity.where) continue;
    // One of several programs that begin at the same time has to win.
    const bool isHeld = other.kind == static_cast<std::uint8_t>(Claim::kHeld);
    if (isHeld || other.number < number) return other.sender;
  }
  return {};
}

void ProgramPresence::Implementation::watch() {
  const std::lock_guard lock(mutex);
  while (take(reader.get(), sample)) {
    const auto& other = sample.package;
    const bool isSame = other.name == identity.program && other.sender != identity.where &&
                        other.kind == static_cast<std::uint8_t>(Claim::kHeld);
    if (!isSame || !reported.insert(other.sender).second) continue;
    report("Program " + identity.program + " of " + identity.robot + " runs twice: also as " + other.sender +
           ". Only the newest one's packages are used. End one of them.");
  }
}

Result<std::unique_ptr<ProgramPresence>> ProgramPresence::claim(
    const std::shared_ptr<Node>& node, const Identity& identity,
    std::function<void(const std::string& text)> report) {
  auto made = std::make_unique<Implementation>(identity);
  auto reader = openReader(node->participant(), presenceTopic(identity.robot), History::kLatched);
  if (!reader) return tl::unexpected(reader.error());
  auto writer = openWriter(node->participant(), presenceTopic(identity.robot), History::kLatched);
  if (!writer) return tl::unexpected(writer.error());
  made->node = node;
  made->reader = std::move(*reader);
  made->writer = std::move(*writer);
  made->report = std::move(report);
  made->announce(Claim::kWanted);
  const auto end = std::chrono::steady_clock::now() + kClaimTime;
  while (std::chrono::steady_clock::now() < end) {
    if (const std::string other = made->superior(); !other.empty())
      return failure("spread.twice",
                     "program " + identity.program + " of " + identity.robot + " runs already, as " + other +
                         "; end it first, or start another program of the layout",
                     {}, {identity.program, identity.robot, other});
    std::this_thread::sleep_for(kClaimLook);
  }
  made->announce(Claim::kHeld);
  const std::unique_ptr<dds_listener_t, void (*)(dds_listener_t*)> listener(dds_create_listener(made.get()),
                                                                            &dds_delete_listener);
  dds_lset_data_available(listener.get(),
                          [](dds_entity_t, void* self) { static_cast<Implementation*>(self)->watch(); });
  dds_set_listener(made->reader.get(), listener.get());
  made->watch();
  return std::unique_ptr<ProgramPresence>(new ProgramPresence(std::move(made)));
}

ProgramPresence::ProgramPresence(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ProgramPresence::~ProgramPresence() = default;

std::string ProgramPresence::here() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(::getpid()) + " on " + host.data();
}

}  // namespace robotlink::dds
