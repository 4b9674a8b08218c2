// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to hand a package from one program to another and back over DDS, beside the same bytes by
// bare writing and taking with Cyclone DDS, and through a Unix-domain socket. All three are measured in turn,
// in one run, so that what else the machine does hits them alike; "to_cyclone" and "to_socket" are medians of
// quotients. The two programs are two participants in one, which meet through the network stack only.
#include <benchmark/benchmark.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "foxglove/Image.pb.h"
#include "robotlink/dds/ProgramNet.h"
#include "robotlink/dds/Wire.h"
#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

using BenchClock = std::chrono::steady_clock;
using Image = foxglove::RawImage;

/// Two participants that have found each other long ago.
struct DdsPair {
  std::shared_ptr<dds::Node> here = openTestNode();
  std::shared_ptr<dds::Node> there = openTestNode();
};
const DdsPair& ddsPair() {
  static const DdsPair kPair;
  return kPair;
}

double secondsSince(BenchClock::time_point start) {
  return std::chrono::duration<double>(BenchClock::now() - start).count();
}

/// One end of the bare comparison: a writer, a reader, and what waits for its samples.
class BareEnd {
 public:
  BareEnd(const dds::Node& node, const std::string& out, const std::string& in)
      : writer_(*dds::openWriter(node.participant(), out, dds::History::kNewest)),
        reader_(*dds::openReader(node.participant(), in, dds::History::kNewest)),
        condition_(dds_create_readcondition(reader_.get(), DDS_ANY_STATE)),
        set_(dds_create_waitset(node.participant())) {
    dds_waitset_attach(set_.get(), condition_, 0);
  }
  bool matched() const {
    dds_publication_matched_status_t written{};
    dds_subscription_matched_status_t read{};
    dds_get_publication_matched_status(writer_.get(), &written);
    dds_get_subscription_matched_status(reader_.get(), &read);
    return written.current_count > 0 && read.current_count > 0;
  }
  void write(const std::string& bytes) {
    dds::write(writer_.get(),
               {.name = none_, .type = none_, .sender = none_, .data = bytes.data(), .size = bytes.size()});
  }
  bool take() {
    dds_attach_t triggered = 0;
    if (dds_waitset_wait(set_.get(), &triggered, 1, DDS_SECS(5)) <= 0) return false;
    return dds::take(reader_.get(), sample_).has_value();
  }

 private:
  const std::string none_;
  dds::Entity writer_, reader_;
  dds_entity_t condition_;  // is deleted with the reader
  dds::Entity set_;
  dds::Sample sample_;
};

double bareCyclone(std::size_t size, int rounds) {
  BareEnd from(*ddsPair().here, "bare/there", "bare/back");
  BareEnd to(*ddsPair().there, "bare/back", "bare/there");
  eventually([&] { return from.matched() && to.matched(); });
  const std::string bytes(size, 'x');
  std::atomic<bool> end{false};
  std::thread answering([&] {
    while (!end) {
      if (to.take()) to.write(bytes);
    }
  });
  // The first samples may be lost while the ends get to know each other.
  for (int i = 0; i < 10; ++i) {
    from.write(bytes);
    from.take();
  }
  const auto start = BenchClock::now();
  for (int i = 0; i < rounds; ++i) {
    from.write(bytes);
    from.take();
  }
  const double seconds = secondsSince(start);
  end = true;
  from.write(bytes);
  answering.join();
  return seconds;
}

bool transfer(int socket, std::string& bytes, bool isSending) {
  for (std::size_t done = 0; done < bytes.size();) {
    const auto count = isSending ? ::send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL)
                                 : ::recv(socket, bytes.data() + done, bytes.size() - done, 0);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

double unixSocket(std::size_t size, int rounds) {
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, sockets) != 0) return 0;
  std::thread answering([&] {
    std::string bytes(size, 'x');
    while (transfer(sockets[1], bytes, false) && transfer(sockets[1], bytes, true)) {
    }
  });
  std::string bytes(size, 'x');
  const auto start = BenchClock::now();
  for (int i = 0; i < rounds; ++i) {
    transfer(sockets[0], bytes, true);
    transfer(sockets[0], bytes, false);
  }
  const double seconds = secondsSince(start);
  ::shutdown(sockets[0], SHUT_RDWR);
  answering.join();
  ::close(sockets[0]);
  ::close(sockets[1]);
  return seconds;
}

/// Transferred between two processes with blocking receivers, each frame a package, as between programs.
double linkedPrograms(std::size_t size, int rounds) {
  SteadyClock clock;
  dds::ProgramNet here(ddsPair().here, {"bench", "here"}, clock, {});
  dds::ProgramNet other(ddsPair().there, {"bench", "there"}, clock, {});
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Image> there(from, "there", Blocking::kNo);
  Receiver<Image> thereReceiver(to, "there", Blocking::kYes);
  Sender<Image> back(to, "back", Blocking::kNo);
  Receiver<Image> backReceiver(from, "back", Blocking::kYes);
  if (!here.link(there, "from") || !other.link(thereReceiver, "from") || !other.link(back, "to") ||
      !here.link(backReceiver, "to"))
    return 0;
  eventually([&] {
    return there.connected() && thereReceiver.connected() && back.connected() && backReceiver.connected();
  });
  auto image = std::make_shared<Image>();
  image->set_data(std::string(size, 'x'));
  from.body = [&] { there.send(image); };
  to.body = [&] { back.send(image); };
  std::thread answering([&] {
    while (to.waitForFrame(std::chrono::seconds(1))) to.runFrame();
  });
  there.send(image);
  for (int i = 0; i < 10 && from.waitForFrame(std::chrono::seconds(5)); ++i) from.runFrame();
  const auto start = BenchClock::now();
  for (int i = 0; i < rounds && from.waitForFrame(std::chrono::seconds(5)); ++i) from.runFrame();
  const double seconds = secondsSince(start);
  to.stop();
  answering.join();
  return seconds;
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void packageBetweenPrograms(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  const int rounds = size > 10'000 ? 500 : 2000;
  std::vector<double> links, toCyclone, toSocket, cyclone, sockets;
  for (auto unused : state) {
    static_cast<void>(unused);
    const double bare = bareCyclone(size, rounds);
    const double link = linkedPrograms(size, rounds);
    const double socket = unixSocket(size, rounds);
    state.SetIterationTime(link);
    links.push_back(1e6 * link / rounds);
    cyclone.push_back(1e6 * bare / rounds);
    sockets.push_back(1e6 * socket / rounds);
    toCyclone.push_back(link / bare);
    toSocket.push_back(link / socket);
  }
  state.counters["round_trip_us"] = medianOf(links);
  state.counters["cyclone_us"] = medianOf(cyclone);
  state.counters["socket_us"] = medianOf(sockets);
  state.counters["to_cyclone"] = medianOf(toCyclone);
  state.counters["to_socket"] = medianOf(toSocket);
}
BENCHMARK(packageBetweenPrograms)
    ->Arg(100)
    ->Arg(100'000)
    ->Iterations(9)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robotlink::test
