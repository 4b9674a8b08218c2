// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/SlurmBatch.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kLookAtJobsEvery{100};
/// Slurm's controller is not to be asked more often.
constexpr int kLooksPerQuestion = 20;
/// After this many unanswered queries in a row, the existing results are used.
constexpr int kMaxUnanswered = 150;
/// By default, a Slurm array has at most this many jobs (MaxArraySize 1001); if there are more
/// runs, each job does several.
constexpr std::size_t kMaxJobs = 1000;
constexpr char kScript[] = "slurm.sh", kCommands[] = "slurm-commands.txt";

struct ShellOutcome {
  int status = -1;
  std::string text;
};

/// Executes a command of the shell; its output and errors together.
ShellOutcome shell(const std::string& command) {
  ShellOutcome outcome;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "re");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> bytes;
  while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe))
    outcome.text.append(bytes.data(), count);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  while (!outcome.text.empty() && outcome.text.back() == '\n') outcome.text.pop_back();
  return outcome;
}

}  // namespace

std::string SlurmBatch::script(std::size_t runs) const {
  const std::string jobs = std::to_string(std::min(runs, kMaxJobs));
  return "#!/bin/bash\n#SBATCH --job-name=robotctl\n#SBATCH --cpus-per-task=1\n#SBATCH --array=1-" + jobs +
         "\n#SBATCH --output=/dev/null\ncd " + shellLine({files_.folder().string()}) +
         "\nfor ((run = SLURM_ARRAY_TASK_ID; run <= " + std::to_string(runs) + "; run += " + jobs +
         ")); do\n  eval \"$(sed -n \"${run}p\" " + kCommands + ")\"\ndone\n";
}

std::string SlurmBatch::commands(const std::vector<PlannedRun>& runs, const std::string& program) const {
  std::string lines;
  for (const PlannedRun& run : runs) {
    std::vector<std::string> words{program};
    words.insert(words.end(), run.arguments.begin(), run.arguments.end());
    const std::string unfinished = shellLine({files_.unfinished(run).string()});
    lines += shellLine(words) + " > " + unfinished + " 2> " + shellLine({files_.texts(run).string()}) +
             " && mv " + unfinished + " " + shellLine({files_.result(run).string()}) + "\n";
  }
  return lines;
}

robotlink::Result<std::vector<PlannedRun>> SlurmBatch::execute(
    const std::vector<PlannedRun>& runs, const std::function<bool(const RunProgress&)>& look) {
  for (const PlannedRun& run : runs)
    if (auto prepared = files_.prepare(run); !prepared) return tl::unexpected(prepared.error());
  std::error_code ignored;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", ignored).string();
  const auto script = files_.folder() / kScript;
  if (auto written = robotlink::writeFileAtomically(files_.folder() / kCommands, commands(runs, program));
      !written)
    return tl::unexpected(written.error());
  if (auto written = robotlink::writeFileAtomically(script, this->script(runs.size())); !written)
    return tl::unexpected(written.error());
  const ShellOutcome submitted = shell(shellLine({"sbatch", "--parsable", script.string()}));
  if (submitted.status != 0)
    return robotlink::failure("compare.slurm", "Slurm accepts no jobs: " + submitted.text, {},
                              {submitted.text});
  const std::string job = submitted.text.substr(0, submitted.text.find(';'));

  RunProgress progress{.all = runs.size()};
  bool runsStill = true;
  int unanswered = 0;
  for (int looks = 0; runsStill; ++looks) {
    progress.done = 0;
    for (const PlannedRun& run : runs) progress.done += files_.isDone(run) ? 1 : 0;
    progress.running = runs.size() - progress.done;
    if (!look(progress)) {
      shell(shellLine({"scancel", job}));
      break;
    }
    if (looks % kLooksPerQuestion == 0) {
      const ShellOutcome queue = shell(shellLine({"squeue", "--noheader", "--jobs", job}));
      // A job that is over for some time is no longer known. A controller that is busy answers later.
      const bool isForgotten = queue.text.find("Invalid job id") != std::string::npos;
      unanswered = queue.status == 0 || isForgotten ? 0 : unanswered + 1;
      runsStill = unanswered > 0 ? unanswered < kMaxUnanswered : !isForgotten && !queue.text.empty();
    }
    if (runsStill) std::this_thread::sleep_for(kLookAtJobsEvery);
  }
  std::vector<PlannedRun> failed;
  for (const PlannedRun& run : runs)
    if (!files_.isDone(run)) failed.push_back(run);
  return failed;
}

}  // namespace app
