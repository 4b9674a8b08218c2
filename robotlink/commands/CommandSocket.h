// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/commands/ScriptRun.h"

namespace robotlink {

/// Lets other programs of the same user run lines of scripts in a running workbench (`robotctl do`), over a
/// local socket: "robotcontrol-PID.sock" in the user's folder for such files, which only that user may open.
///
/// A client sends lines, each of at most LineReader::kMaxLine bytes; each is answered with a line "printed "
/// and a text for each that it prints and, when it is done, with the line "ok", or "failed " and the reason;
/// in texts and reasons a line feed is "\n" and a backslash "\\". A client that closes its connection cancels
/// what it waits for. The line "folder PATH" sets the base folder of files. One thread, that of the
/// session; never blocks.
class CommandSocket {
 public:
  /// Listens. The objects that the lines act on must outlive this one.
  explicit CommandSocket(ScriptRun::Workbench workbench);
  ~CommandSocket();
  CommandSocket(const CommandSocket&) = delete;
  CommandSocket& operator=(const CommandSocket&) = delete;

  /// Begins to listen. Fails if the folder cannot have such a file.
  Result<void> open(const std::filesystem::path& folder);
  /// Accepts clients, and runs their lines as far as they go. `now` is real time from any zero.
  void tick(Instant now);

 private:
  struct Client;
  void accept();
  /// Returns false if the client is gone.
  bool serve(Client& client, Instant now);

  ScriptRun::Workbench workbench_;
  std::filesystem::path file_;
  int listener_ = -1;
  std::vector<std::unique_ptr<Client>> clients_;
  /// A command may run an event loop of its own, for a dialog, which calls tick() again.
  bool isTicking_ = false;
};

/// The other end: runs lines in a workbench of the same user. Blocks.
class CommandConnection {
 public:
  /// Connects to the workbench that was started last, or to that with a process id above 0. Removes files of
  /// workbenches that have ended without doing so. Fails if none runs.
  static Result<CommandConnection> connect(const std::filesystem::path& folder, int pid = 0);
  CommandConnection(CommandConnection&& other) noexcept;
  CommandConnection& operator=(CommandConnection&&) = delete;
  ~CommandConnection();

  /// Sets the folder to which files in the lines are relative: by default, that of the workbench.
  Result<void> useFolder(const std::filesystem::path& folder);
  /// Sends a line; receive() waits until it is done. Fails if the workbench has ended, or if the line failed.
  Result<void> send(const std::string& line);
  /// `printed` gets what it prints; may be empty.
  Result<void> receive(const std::function<void(const std::string&)>& printed = {});

 private:
  explicit CommandConnection(int socket) : socket_(socket) {}

  int socket_;
};

/// The folder of these files, as the environment has it (XDG_RUNTIME_DIR); empty: there is none.
std::filesystem::path commandSocketFolder();

}  // namespace robotlink
