// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/inotify.h>
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

/// Tells what happens in a folder, or to a file.
class Watch {
 public:
  Watch(const std::filesystem::path& path, std::uint32_t events) : descriptor_(::inotify_init1(IN_CLOEXEC)) {
    EXPECT_GE(::inotify_add_watch(descriptor_, path.c_str(), events), 0);
  }
  ~Watch() { ::close(descriptor_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Waits for it to happen; false: it did not.
  bool happens() const {
    pollfd ready{descriptor_, POLLIN, 0};
    if (::poll(&ready, 1, kPatienceMs) != 1) return false;
    std::array<char, 4096> events{};
    return ::read(descriptor_, events.data(), events.size()) > 0;
  }

 private:
  static constexpr int kPatienceMs = 30'000;  // for what should take far less

  int descriptor_;
};

/// A program of ours, started in a folder; it is killed if a test forgets it. What it says of errors is in
/// the file "errors" beside that folder.
class StartedProgram {
 public:
  /// `ignored`: a signal that whoever starts it lets it ignore.
  StartedProgram(const char* program, const std::filesystem::path& folder,
                 const std::vector<std::string>& arguments, int ignored = 0)
      : folder_(folder) {
    std::vector<char*> words{const_cast<char*>(program)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    int output[2];
    if (::pipe2(output, O_CLOEXEC) != 0) std::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      if (ignored != 0) std::signal(ignored, SIG_IGN);
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
