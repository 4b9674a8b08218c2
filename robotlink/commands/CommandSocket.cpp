// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandSocket.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/commands/LineReader.h"

namespace robotlink {

namespace {

constexpr std::size_t kMaxClients = 8;
constexpr std::string_view kBegin = "robotcontrol-", kEnd = ".sock";
constexpr std::string_view kOk = "ok", kFailure = "failed ", kFolder = "folder ", kPrinted = "printed ";

std::string inOneLine(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\' || c == '\n') result += '\\';
    result += c == '\n' ? 'n' : c;
  }
  return result;
}

std::string inLines(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isEscape = text[at] == '\\' && at + 1 < text.size();
    result += !isEscape ? text[at] : text[++at] == 'n' ? '\n' : text[at];
  }
  return result;
}

/// The address of a socket's file; fails if its path is too long for one.
Result<sockaddr_un> addressOf(const std::filesystem::path& file) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = file.string();
  if (path.size() >= sizeof address.sun_path)
    return failure("socket.path", "the path is too long for a socket", {path});
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

const sockaddr* generic(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

bool isOfThisUser(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return ::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == ::geteuid();
}

/// The process of a socket's file; 0: it is another file.
int pidOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return 0;
  const std::string_view digits(name.data() + kBegin.size(), name.size() - kBegin.size() - kEnd.size());
  return parsedNumber<int>(digits).value_or(0);
}

/// The sockets' files in a folder, the newest first.
std::vector<std::filesystem::path> socketsIn(const std::filesystem::path& folder) {
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (pidOf(entry.path()) > 0) found.emplace_back(entry.last_write_time(ignored), entry.path());
  }
  std::ranges::sort(found, std::greater<>());
  std::vector<std::filesystem::path> files;
  for (auto& [time, file] : found) files.push_back(std::move(file));
  return files;
}

}  // namespace

struct CommandSocket::Client {
  Client(int connected, const ScriptRun::Workbench& workbench) : socket(connected), run(workbench) {
    run.setOutput(
        [this](const std::string& text) { answers += std::string(kPrinted) + inOneLine(text) + "\n"; });
  }
  ~Client() { ::close(socket); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  int socket;
  LineReader reader;
  ScriptRun run;
  /// Whether a line runs that is not answered yet.
  bool isBusy = false;
  /// The part of the answers that could not be sent yet.
  std::string answers;

  /// Reads what has arrived; returns false at the end. Nothing is read while a line runs, so that a client
  /// cannot fill the memory.
  bool read() {
    std::array<char, 4096> buffer{};
    const ssize_t count =
        ::recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT | (isBusy ? MSG_PEEK : 0));
    if (count > 0 && !isBusy) reader.feed({buffer.data(), static_cast<std::size_t>(count)});
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  }
  bool write() {
    if (answers.empty()) return true;
    const ssize_t count = ::send(socket, answers.data(), answers.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) answers.erase(0, static_cast<std::size_t>(count));
    return count > 0 || errno == EAGAIN || errno == EINTR;
  }
  void answer() {
    const auto& failed = run.failed();
    answers += (failed ? std::string(kFailure) + inOneLine(failed->describe()) : std::string(kOk)) + "\n";
    isBusy = false;
  }
};

CommandSocket::CommandSocket(ScriptRun::Workbench workbench) : workbench_(std::move(workbench)) {}

CommandSocket::~CommandSocket() {
  if (listener_ < 0) return;
  ::close(listener_);
  ::unlink(file_.c_str());
}

Result<void> CommandSocket::open(const std::filesystem::path& folder) {
  const auto file = folder / (std::string(kBegin) + std::to_string(::getpid()) + std::string(kEnd));
  const auto address = addressOf(file);
  if (!address) return tl::unexpected(address.error());
  const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  ::unlink(file.c_str());  // of a process that had the same id
  // The mode is set before the file exists, so that no other user can ever open it.
  const bool isOpen = listener >= 0 && ::fchmod(listener, S_IRUSR | S_IWUSR) == 0 &&
                      ::bind(listener, generic(*address), sizeof *address) == 0 &&
                      ::listen(listener, kMaxClients) == 0;
  if (!isOpen) {
    const std::string why = std::strerror(errno);
    if (listener >= 0) ::close(listener);
    return failure("socket.open", "other programs cannot run commands here: " + why, {file.string()});
  }
  listener_ = listener;
  file_ = file;
  return {};
}

void CommandSocket::accept() {
  while (clients_.size() < kMaxClients) {
    const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0) return;
    if (isOfThisUser(socket)) {
      clients_.push_back(std::make_unique<Client>(socket, workbench_));
    } else {
      ::close(socket);
    }
  }
}

void CommandSocket::tick(Instant now) {
  if (listener_ < 0 || std::exchange(isTicking_, true)) return;
  accept();
  std::erase_if(clients_, [&](const auto& client) { return !serve(*client, now); });
  isTicking_ = false;
}

bool CommandSocket::serve(Client& client, Instant now) {
  const bool isThere = client.read();
  while (isThere) {
    if (!client.isBusy) {
      const auto line = client.reader.next();
      if (!line) break;
      const bool isFolder = line->starts_with(kFolder);
      if (isFolder) client.run.setFolder(line->substr(kFolder.size()));
      client.run.runLines({}, isFolder ? std::string() : *line);
      client.isBusy = true;
    }
    client.run.tick(now);
    if (!client.run.isIdle()) break;
    client.answer();
  }
  if (client.reader.isTooLong()) {
    client.answers += std::string(kFailure) + "the line is longer than " +
                      std::to_string(LineReader::kMaxLine) + " bytes\n";
    static_cast<void>(client.write());
    return false;
  }
  return client.write() && isThere;
}

Result<CommandConnection> CommandConnection::connect(const std::filesystem::path& folder, int pid) {
  for (const auto& file : socketsIn(folder)) {
    if (pid > 0 && pidOf(file) != pid) continue;
    const auto address = addressOf(file);
    if (!address) return tl::unexpected(address.error());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket >= 0 && ::connect(socket, generic(*address), sizeof *address) == 0)
      return CommandConnection(socket);
    if (errno == ECONNREFUSED) ::unlink(file.c_str());  // no process listens any longer
    if (socket >= 0) ::close(socket);
  }
  const std::string which = pid > 0 ? "with the process id " + std::to_string(pid) : "here";
  return failure("socket.none", "no workbench of yours runs " + which + "; start robotcontrol first");
}

CommandConnection::CommandConnection(CommandConnection&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)) {}

CommandConnection::~CommandConnection() {
  if (socket_ >= 0) ::close(socket_);
}

Result<void> CommandConnection::send(const std::string& line) {
  if (line.find('\n') != std::string::npos)
    return failure("socket.line", "a line must not contain a line feed; give each line separately");
  std::string bytes = line + "\n";
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) bytes.erase(0, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  // The workbench's answer to an overlong line can still be read.
  return {};
}

Result<void> CommandConnection::useFolder(const std::filesystem::path& folder) {
  return send(std::string(kFolder) + folder.string()).and_then([this] { return receive(); });
}

Result<void> CommandConnection::receive(const std::function<void(const std::string&)>& printed) {
  LineReader reader;
  std::array<char, 4096> buffer{};
  while (true) {
    if (const auto line = reader.next()) {
      if (*line == kOk) return {};
      if (line->starts_with(kPrinted)) {
        if (printed) printed(inLines(std::string_view(*line).substr(kPrinted.size())));
        continue;
      }
      return failure(
          "socket.failed",
          inLines(std::string_view(*line).substr(line->starts_with(kFailure) ? kFailure.size() : 0)));
    }
    const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0 || reader.isTooLong())
      return failure("socket.closed", "the workbench has ended, or closed the connection");
    reader.feed({buffer.data(), static_cast<std::size_t>(count)});
  }
}

std::filesystem::path commandSocketFolder() {
  const char* folder = std::getenv("XDG_RUNTIME_DIR");
  return folder != nullptr ? folder : "";
}

}  // namespace robotlink
