// SPDX-License-Identifier: GPL-3.0-or-later
// How many Pioneers a machine simulates in real time: runs robotctl sim --arcos as a process of its own, with
// a client for each robot that reads every packet and wanders about, and tells how regularly information
// packets came and what the simulation cost. A program to look at, not a test.
//
//   arcos_scale_benchmark MAP [--seconds S] [--robots N,N,...] [--only sonar|laser] [--drive
//   kinematic|dynamic]
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace {

using namespace robotlink::arcos;
using Clock = std::chrono::steady_clock;

constexpr int kFirstPort = 18101;
constexpr double kWarmUp = 3;  // s; connecting and the first packets are not counted

struct Setting {
  int robots = 1;
  bool laser = false;
  bool kinematic = false;
};

/// The simulation, a process of its own.
class Server {
 public:
  Server(const std::string& map, const Setting& setting) {
    std::vector<std::string> words{ROBOTCTL,
                                   "sim",
                                   map,
                                   "--robots",
                                   std::to_string(setting.robots),
                                   "--arcos",
                                   std::to_string(kFirstPort),
                                   "--json"};
    if (setting.kinematic) words.emplace_back("--kinematic");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = ::fork();
    if (process_ != 0) return;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 1);
    ::dup2(nowhere, 2);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  ~Server() {
    if (ended()) return;
    ::kill(process_, SIGINT);
    ::waitpid(process_, nullptr, 0);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// It ended by itself: there is no room for so many robots, or a port is taken.
  bool ended() {
    ended_ = ended_ || ::waitpid(process_, nullptr, WNOHANG) != 0;
    return ended_;
  }
  /// Processor time it used so far, s.
  double used() const {
    std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
    std::string field;
    double ticks = 0;
    for (int i = 3; i <= 15 && fields >> field; ++i) {
      if (i >= 14) ticks += std::stod(field);
    }
    return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }
  double megabytes() const {
    std::ifstream file("/proc/" + std::to_string(process_) + "/statm");
    double total = 0, resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
  }

 private:
  pid_t process_ = 0;
  bool ended_ = false;
};

/// A program that drives one robot.
class Client {
 public:
  ~Client() {
    if (socket_ >= 0) ::close(socket_);
  }
  int descriptor() const { return socket_; }

  bool connect(int port, bool laser) {
    if (socket_ >= 0) ::close(socket_);
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return false;
    const int one = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    ::fcntl(socket_, F_SETFL, O_NONBLOCK);
    for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2, CommandId::kOpen})
      say(command(id));
    say(command(CommandId::kEnable, 1));
    if (laser) say(command(CommandId::kSimLaserEnable, 2));
    flush();
    return true;
  }

  void read(Clock::time_point now, bool counted) {
    std::uint8_t bytes[16384];
    for (;;) {
      const auto count = ::recv(socket_, bytes, sizeof bytes, 0);
      if (count <= 0) return;
      parser_.push({bytes, static_cast<std::size_t>(count)});
      while (const auto found = parser_.next()) {
        const auto* packet = std::get_if<Packet>(&*found);
        if (packet == nullptr) continue;
        laserPackets += counted && packet->id == LaserPacket::kExtendedId;
        if ((packet->id & 0xF0) == 0x30) takeInformation(*packet, now, counted);
      }
    }
  }

  std::vector<double> gaps;  // s
  std::uint64_t laserPackets = 0;

 private:
  void say(const Command& command) { append(toPacket(command), outgoing_); }
  void flush() {
    if (::send(socket_, outgoing_.data(), outgoing_.size(), MSG_NOSIGNAL) < 0) std::perror("send");
    outgoing_.clear();
  }
  void takeInformation(const Packet& packet, Clock::time_point now, bool counted) {
    if (counted && last_ != Clock::time_point{})
      gaps.push_back(std::chrono::duration<double>(now - last_).count());
    last_ = now;
    const auto sip = decode<StandardInformation>(packet);
    if (sip) wander(*sip);
  }
  /// Away from what is near in front, every half second; else a pulse is enough.
  void wander(const StandardInformation& sip) {
    for (const auto& sonar : sip.sonars) ranges_[sonar.number % 16] = sonar.rangeMm;
    if (++cycle_ % 5 != 0) return;
    const int front = *std::min_element(ranges_ + 2, ranges_ + 6);
    say(command(CommandId::kVel, sip.leftStalled() || sip.rightStalled() ? -150
                                 : front < 600                           ? 0
                                                                         : std::min(300, front / 3)));
    say(command(CommandId::kRvel, front > 900 ? 0 : ranges_[1] > ranges_[6] ? 40 : -40));
    flush();
  }

  int socket_ = -1;
  PacketParser parser_;
  Bytes outgoing_;
  Clock::time_point last_;
  int ranges_[16] = {};
  int cycle_ = 0;
};

double share(std::vector<double>& sorted, double part) {
  if (sorted.empty()) return 0;
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
}

/// Per second; counted between packets, not between the ends of what was watched.
double rateOf(const std::vector<double>& gaps) {
  const double sum = std::accumulate(gaps.begin(), gaps.end(), 0.0);
  return sum > 0 ? static_cast<double>(gaps.size()) / sum : 0;
}

/// Serves all clients until that time.
void serve(std::vector<std::unique_ptr<Client>>& clients, Clock::time_point until, bool counted) {
  std::vector<pollfd> waits;
  for (const auto& client : clients) waits.push_back({client->descriptor(), POLLIN, 0});
  for (auto now = Clock::now(); now < until; now = Clock::now()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - now).count() + 1;
    ::poll(waits.data(), waits.size(), static_cast<int>(left));
    const auto woken = Clock::now();
    for (std::size_t i = 0; i < clients.size(); ++i) {
      if (waits[i].revents != 0) clients[i]->read(woken, counted);
    }
  }
}

std::chrono::duration<double> realSeconds(double seconds) {
  return std::chrono::duration<double>(seconds);
}

bool measure(const std::string& map, const Setting& setting, double seconds) {
  Server server(map, setting);
  std::vector<std::unique_ptr<Client>> clients;
  const auto patience = Clock::now() + std::chrono::seconds(30);
  for (int robot = 0; robot < setting.robots; ++robot) {
    clients.push_back(std::make_unique<Client>());
    while (!clients.back()->connect(kFirstPort + robot, setting.laser)) {
      if (server.ended() || Clock::now() > patience) {
        std::fprintf(stderr,
                     "no robot listens at port %d; 'robotctl sim %s --robots %d --arcos %d' says why\n",
                     kFirstPort + robot, map.c_str(), setting.robots, kFirstPort);
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  const auto after = [](double time) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(realSeconds(time));
  };
  serve(clients, after(kWarmUp), false);
  const double usedBefore = server.used();
  const auto begin = Clock::now();
  serve(clients, after(seconds), true);
  const double real = std::chrono::duration<double>(Clock::now() - begin).count();
  const double cores = (server.used() - usedBefore) / real;
  std::vector<double> gaps;
  std::uint64_t scans = 0;
  for (const auto& client : clients) {
    gaps.insert(gaps.end(), client->gaps.begin(), client->gaps.end());
    scans += client->laserPackets;
  }
  std::sort(gaps.begin(), gaps.end());
  std::printf("%6d  %-5s  %-9s  %7.3f  %6.1f  %5.0f %5.0f %5.0f  %7.1f  %8.3f  %6.1f\n", setting.robots,
              setting.laser ? "laser" : "sonar", setting.kinematic ? "kinematic" : "dynamic", rateOf(gaps),
              static_cast<double>(scans) / real / setting.robots, share(gaps, 0.5) * 1000,
              share(gaps, 0.99) * 1000, share(gaps, 1) * 1000, cores * 100, cores * 100 / setting.robots,
              server.megabytes());
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::string map;
  double seconds = 10;
  std::vector<int> counts{1, 10, 50, 100};
  std::string only, drive;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], next = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--seconds") {
      seconds = std::stod(next), ++i;
    } else if (word == "--robots") {
      counts.clear();
      std::istringstream list(next);
      for (std::string count; std::getline(list, count, ',');) counts.push_back(std::stoi(count));
      ++i;
    } else if (word == "--only") {
      only = next, ++i;
    } else if (word == "--drive") {
      drive = next, ++i;
    } else {
      map = word;
    }
  }
  if (map.empty()) {
    std::fprintf(stderr,
                 "arcos_scale_benchmark MAP [--seconds S] [--robots N,N,...] [--only sonar|laser] [--drive "
                 "kinematic|dynamic]\n");
    return 2;
  }
  std::printf("robots  range  drive      SIP Hz   laser  gaps p50  p99  max ms  CPU %%  per robot  RSS MB\n");
  for (const bool laser : {false, true}) {
    for (const bool kinematic : {true, false}) {
      if ((!only.empty() && laser != (only == "laser")) ||
          (!drive.empty() && kinematic != (drive == "kinematic")))
        continue;
      for (const int robots : counts) {
        if (!measure(map, {robots, laser, kinematic}, seconds)) return 1;
      }
    }
  }
  return 0;
}
