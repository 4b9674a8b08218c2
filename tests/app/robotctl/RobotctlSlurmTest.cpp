// SPDX-License-Identifier: GPL-3.0-or-later
// Games by the batch system Slurm, with a controller, a node and munge of the test's own on this machine.
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using testing::HasSubstr;

/// A port of this machine that nobody uses now.
int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size), 0);
  ::close(socket);
  return ntohs(address.sin_port);
}

/// A cluster of one machine, which ends with it.
class RobotctlSlurm : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch"}) {
      if (shell(std::string("PATH=$PATH:/usr/sbin command -v ") + program).status != 0)
        GTEST_SKIP() << program << " is not installed (packages slurmctld, slurmd, slurm-client, munge)";
    }
    for (const char* folder : {"state", "spool", "munge"})
      std::filesystem::create_directory(folder_ / folder);
    std::filesystem::permissions(folder_ / "munge", std::filesystem::perms::owner_all);
    writeConfiguration();
    start(
        "head -c 1024 /dev/urandom > munge/key && chmod 600 munge/key && munged --force "
        "--socket=$PWD/munge/socket "
        "--key-file=$PWD/munge/key --pid-file=$PWD/munge/pid --log-file=$PWD/munge/log "
        "--seed-file=$PWD/munge/seed");
    start("slurmctld -f slurm.conf");
    start("slurmd -f slurm.conf");
    ASSERT_TRUE(eventually([this] { return slurm("sinfo --noheader --format=%T").out == "idle\n"; }))
        << slurm("sinfo").errors << textOf(folder_ / "slurmctld.log") << textOf(folder_ / "slurmd.log");
  }
  void TearDown() override {
    for (const char* file : {"slurmd.pid", "slurmctld.pid", "munge/pid"}) {
      const std::string number = textOf(folder_ / file);
      const pid_t pid = number.empty() ? 0 : std::stoi(number);
      if (pid <= 0) continue;
      ::kill(pid, SIGTERM);
      EXPECT_TRUE(eventually([pid] { return ::kill(pid, 0) != 0; })) << file;
    }
  }
  /// Runs a line with the programs and the configuration of the cluster.
  RobotctlOutcome slurm(const std::string& line) const {
    return shell("export PATH=$PATH:/usr/sbin SLURM_CONF=$PWD/slurm.conf; " + line);
  }
  RobotctlOutcome shell(const std::string& line) const { return runShell(folder_.path(), line); }
  void start(const std::string& line) const {
    const RobotctlOutcome outcome = slurm("{ " + line + "\n}");
    ASSERT_EQ(outcome.status, 0) << line << ": " << outcome.errors;
  }
  void writeConfiguration() const {
    const int controller = freePort(), node = freePort();
    start(
        "h=$(hostname -s); u=$(id -un); cat > slurm.conf <<C\n"
        "ClusterName=test\nSlurmctldHost=$h(127.0.0.1)\nSlurmUser=$u\nSlurmdUser=$u\n"
        "AuthType=auth/munge\nAuthInfo=socket=$PWD/munge/socket\nCredType=cred/munge\n"
        "SlurmctldPort=" +
        std::to_string(controller) + "\nSlurmdPort=" + std::to_string(node) +
        "\nStateSaveLocation=$PWD/state\nSlurmdSpoolDir=$PWD/spool\n"
        "SlurmctldPidFile=$PWD/slurmctld.pid\nSlurmdPidFile=$PWD/slurmd.pid\n"
        "SlurmctldLogFile=$PWD/slurmctld.log\nSlurmdLogFile=$PWD/slurmd.log\n"
        "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nJobAcctGatherType=jobacct_gather/none\n"
        "AccountingStorageType=accounting_storage/none\nSelectType=select/cons_tres\n"
        "SelectTypeParameters=CR_CPU\nReturnToService=2\n"
        "NodeName=$h NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN\n"
        "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\nC\n");
  }
  std::string tournament(const std::string& options) const {
    return std::string(ROBOTCTL) +
           " tournament players:soccer reactive:soccer,behavior=potential-field --scene game2002-1 --games 4 "
           "--seconds 4 --out " +
           options;
  }
  TestFolder folder_;
};

}  // namespace

TEST_F(RobotctlSlurm, aTournamentHasTheFiguresOfTheSameGamesHere) {
  const RobotctlOutcome here = slurm(tournament("here"));
  ASSERT_EQ(here.status, 0) << here.errors;
  const RobotctlOutcome there = slurm(tournament("there --batch slurm"));
  ASSERT_EQ(there.status, 0) << there.errors;
  const std::string games = textOf(folder_ / "here/games.csv");
  EXPECT_THAT(games, HasSubstr("players"));
  EXPECT_EQ(textOf(folder_ / "there/games.csv"), games) << "with the digests of all games";
  EXPECT_EQ(textOf(folder_ / "there/results.csv"), textOf(folder_ / "here/results.csv"));
  EXPECT_EQ(slurm("squeue --noheader").out, "");
}

TEST_F(RobotctlSlurm, whatFailsIsTriedAgainAndThenNamed) {
  const std::string compare = std::string(ROBOTCTL) +
                              " compare --task ball-model --solutions filtered,kalman --scene mine.sdf "
                              "--seeds 1 --seconds 1 --out there "
                              "--batch slurm";
  // Its controller fails in the first step, which is not tried before jobs are submitted.
  std::string broken = textOf(kScene);
  broken.replace(broken.rfind("</world>"), 0,
                 "<robotcontrol:controller name=\"ball_replacer\" as=\"lift\">"
                 "<robotcontrol:parameter name=\"model\">ball</robotcontrol:parameter>"
                 "<robotcontrol:parameter name=\"area\">2 2 -2 -2</robotcontrol:parameter>"
                 "</robotcontrol:controller>");
  ASSERT_TRUE(std::ofstream(folder_ / "mine.sdf") << broken);
  const RobotctlOutcome outcome = slurm(compare);
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.errors, HasSubstr("no result: kalman, seed 1"));
  std::filesystem::copy_file(kScene, folder_ / "mine.sdf", std::filesystem::copy_options::overwrite_existing);
  const RobotctlOutcome again = slurm(compare);
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_THAT(textOf(folder_ / "there/results.csv"), HasSubstr("kalman,seed 1"));
}
