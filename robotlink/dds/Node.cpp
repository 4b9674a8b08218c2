// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/Node.h"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <iostream>

#include "robotlink/base/Printable.h"
#include "robotlink/dds/LocalAddresses.h"

namespace robotlink::dds {
namespace {

/// Local numbers of domains that are tried; a program has one for each of its nodes.
constexpr dds_domainid_t kMaxLocalDomains = 200;
constexpr std::uint32_t kMaxDomain = 230;  // with higher ones the ports would exceed 65535

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '<' || c == '>' || c == '&') continue;  // in no address or name of a machine
    result += c;
  }
  return result;
}

/// The settings of Cyclone DDS. Each node has a domain of its own in the program, all with the same number
/// outside. On the loopback interface datagrams are as long as possible.
std::string settingsOf(const NodeOptions& options) {
  const bool isLoopback = options.address.empty();
  const std::string interface =
      isLoopback ? "address=\"127.0.0.1\"" : "address=\"" + escaped(options.address) + "\"";
  std::string peers = "<Peer address=\"" + (isLoopback ? "127.0.0.1" : escaped(options.address)) + "\"/>";
  for (const std::string& peer : options.peers) {
    if (peer != options.address) peers += "<Peer address=\"" + escaped(peer) + "\"/>";
  }
  return "<CycloneDDS><Domain id=\"any\"><General><Interfaces><NetworkInterface " + interface +
         "/></Interfaces><AllowMulticast>" + (options.multicast && !isLoopback ? "spdp" : "false") +
         "</AllowMulticast>" +
         (isLoopback ? "<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>65000B</FragmentSize>" : "") +
         "</General><Discovery><ExternalDomainId>" + std::to_string(options.domain) +
         "</ExternalDomainId><ParticipantIndex>auto</ParticipantIndex>"
         "<MaxAutoParticipantIndex>31</MaxAutoParticipantIndex><Peers>" +
         peers +
         "</Peers><SPDPInterval>300ms</SPDPInterval><LeaseDuration>1s</LeaseDuration></Discovery>"
         "<Internal><Watermarks><WhcHigh>64MB</WhcHigh></Watermarks></Internal>"
         "<Tracing><Verbosity>none</Verbosity></Tracing></Domain></CycloneDDS>";
}

/// Collects the messages of Cyclone DDS while it lives in this thread. Otherwise they would go to stderr.
class DdsTexts {
 public:
  DdsTexts() { current_ = this; }
  ~DdsTexts() { current_ = nullptr; }
  DdsTexts(const DdsTexts&) = delete;
  DdsTexts& operator=(const DdsTexts&) = delete;

  /// The last one, without its line's end; empty: there was none.
  const std::string& last() const { return last_; }

  /// From now on only messages about aborting the program go to stderr. The meaning of a lost connection
  /// for users is reported by those who miss others. Any thread.
  static void takeAll() {
    [[maybe_unused]] static const bool isTaken = [] {
      dds_set_log_sink(take, nullptr);
      dds_set_trace_sink([](void*, const dds_log_data_t*) {}, nullptr);
      return true;
    }();
  }

 private:
  static void take(void*, const dds_log_data_t* data) {
    const std::string text(data->message, data->size);
    if (data->priority == DDS_LC_FATAL) std::cerr << text << std::flush;  // DDS aborts the program
    if (current_ != nullptr) current_->last_ = printable(text.substr(0, text.find('\n')));
  }

  static inline thread_local DdsTexts* current_ = nullptr;
  std::string last_;
};

Error refusal(const NodeOptions& options, const std::string& text) {
  const std::string address = options.address.empty() ? "127.0.0.1" : options.address;
  std::string why = whyNotUsable(address, localInterfaces());
  if (why.empty())
    why = text + "; check how many programs use domain " + std::to_string(options.domain) + " here";
  return {"dds.open", "DDS cannot be used on the address " + address + ": " + why, {address}, {}};
}

}  // namespace

Result<std::shared_ptr<Node>> Node::open(const NodeOptions& options) {
  if (options.domain > kMaxDomain) {
    return failure("dds.domain", "a DDS domain is a number from 0 to " + std::to_string(kMaxDomain) +
                                     ", not " + std::to_string(options.domain));
  }
  DdsTexts::takeAll();
  const DdsTexts texts;
  const std::string settings = settingsOf(options);
  dds_domainid_t local = 0;
  dds_entity_t domain = DDS_RETCODE_PRECONDITION_NOT_MET;
  while (domain == DDS_RETCODE_PRECONDITION_NOT_MET && local < kMaxLocalDomains)
    domain = dds_create_domain(local++, settings.c_str());
  const dds_entity_t participant = domain < 0 ? domain : dds_create_participant(local - 1, nullptr, nullptr);
  if (participant < 0) {
    if (domain >= 0) dds_delete(domain);
    return tl::unexpected(
        refusal(options, texts.last().empty() ? dds_strretcode(participant) : texts.last()));
  }
  return std::shared_ptr<Node>(new Node(domain, participant, options.address));
}

Node::~Node() {
  dds_delete(participant_);
  dds_delete(domain_);
}

}  // namespace robotlink::dds
