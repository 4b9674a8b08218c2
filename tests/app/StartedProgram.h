// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

/// A program of ours, started in a folder; it is killed if a test forgets it or ends abnormally. What it says
/// of errors is in the file "errors" beside that folder.
class StartedProgram {
 public:
  struct Options {
    /// A signal that whoever starts it lets it ignore.
    int ignored = 0;
    /// The network namespace that it runs in, as a file descriptor; -1: that of whoever starts it.
    int network = -1;
    /// What its environment has beside that of whoever starts it: names and values.
    std::vector<std::pair<std::string, std::string>> environment = {};
  };

  StartedProgram(const char* program, const std::filesystem::path& folder,
                 const std::vector<std::string>& arguments)
      : StartedProgram(program, folder, arguments, Options()) {}
  StartedProgram(const char* program, const std::filesystem::path& folder,
                 const std::vector<std::string>& arguments, const Options& options)
      : folder_(folder) {
    std::vector<char*> words{const_cast<char*>(program)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    int output[2];
    if (::pipe2(output, O_CLOEXEC) != 0) std::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (options.ignored != 0) std::signal(options.ignored, SIG_IGN);
      if (options.network >= 0 && ::setns(options.network, CLONE_NEWNET) != 0) ::_exit(127);
      for (const auto& [name, value] : options.environment) ::setenv(name.c_str(), value.c_str(), 1);
      const int errors = ::open(errorsFile().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      ::dup2(output[1], STDOUT_FILENO);
      ::dup2(errors, STDERR_FILENO);
      if (::chdir(folder.c_str()) == 0) ::execv(program, words.data());
      ::_exit(127);
    }
    ::close(output[1]);
    output_ = output[0];
  }
  ~StartedProgram() {
    if (pid_ > 0) ::kill(pid_, SIGKILL);
    if (pid_ > 0) ::waitpid(pid_, nullptr, 0);
    ::close(output_);
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  /// 0 after it was waited for.
  pid_t pid() const { return pid_; }
  void send(int signal) const { ::kill(pid_, signal); }
  /// Reads what it prints to the end, and yields its exit status; -1: a signal has killed it.
  int wait() {
    std::array<char, 4096> buffer{};
    for (ssize_t count; (count = ::read(output_, buffer.data(), buffer.size())) > 0;)
      text_.append(buffer.data(), static_cast<std::size_t>(count));
    return waitUnread();
  }
  /// The same without reading anything.
  int waitUnread() {
    int status = 0;
    ::waitpid(std::exchange(pid_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  const std::string& text() const { return text_; }
  std::string errors() const {
    std::ifstream file(errorsFile());
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

 private:
  std::filesystem::path errorsFile() const { return folder_.parent_path() / "errors"; }

  std::filesystem::path folder_;
  pid_t pid_ = 0;
  int output_ = -1;
  std::string text_;
};
