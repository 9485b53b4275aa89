#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/result.h"

namespace somato::program {

/// Another program that runs beside this one, in a process group of its own, so that Ctrl-C does
/// not end it. It is ended with this object, unless it is left.
class ChildProcess {
 public:
  /// Starts `words[0]`, which is searched in PATH, with the other words as arguments. A connection
  /// to this program stands in the place of the descriptors `connected`; standard input, output and
  /// error are /dev/null unless they are among them. Errors: kSystem with the system's reason, at
  /// `words[0]`.
  static Result<ChildProcess> start(std::vector<std::string> words,
                                    const std::vector<int>& connected = {});

  ChildProcess(const ChildProcess&) = delete;
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Errors: kSystem if the program does not read any more.
  Result<void> send(std::string_view bytes);

  /// The next bytes; nothing at the end. Errors: kSystem if none come for `patience`.
  Result<std::string> receive(std::chrono::milliseconds patience);

  /// Closes the connection and waits for the end of the program. Errors: kSystem if it fails, or
  /// does not end within `patience`.
  Result<void> finish(std::chrono::milliseconds patience);

  /// Lets it run.
  void leave() { process_ = 0; }

 private:
  ChildProcess(std::string name, pid_t process, int connection)
      : name_(std::move(name)), process_(process), connection_(connection) {}

  tl::unexpected<Error> failed(const std::string& what) const;
  void close();

  std::string name_;
  pid_t process_;
  int connection_;  // or -1
};

}  // namespace somato::program
