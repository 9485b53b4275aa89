#pragma once

#include <csignal>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace somato {

/// The world that a program is run in.
struct ProgramWorld {
  std::string folder = ".";                                      ///< Where it is run.
  std::vector<std::pair<std::string, std::string>> environment;  ///< Beside the test's own.
  std::string input_from;       ///< File for its standard input; empty: nothing.
  std::string output_to;        ///< File or device for its standard output; "closed": none.
  bool terminal = false;        ///< Standard error is a terminal.
  std::string interrupt_at;     ///< Once standard error says this, Ctrl-C is pressed.
  int interrupt_with = SIGINT;  ///< The signal that is sent then.
  /// With its standard output and its standard error so far.
  std::function<void(const std::string& said)> before_interrupt;
  std::size_t largest_file = 0;  ///< Bytes it may write to a file; 0: no limit.
  std::size_t memory = 0;        ///< Bytes of address space; 0: no limit.
  bool closes_output = false;    ///< Close the program's standard output after one byte.
  int seconds = 120;             ///< After which it is killed.
};

/// The results of the run.
struct ProgramRun {
  int exit_code = -1;  ///< -1 when a signal ended it.
  int signal = 0;      ///< The signal that ended it, or 0.
  bool timed_out = false;
  std::size_t most_memory = 0;  ///< Bytes of physical memory that it used at most.
  std::string out;              ///< Standard output.
  std::string err;              ///< Standard error; a terminal's lines end in "\r\n".

  /// Whether a sanitizer found fault with it.
  bool accused() const;
};

/// The exit code of a program that a sanitizer found fault with: none of its own.
inline constexpr int kAccused = 99;

/// Runs the program `arguments[0]` and waits for it. Throws std::runtime_error when it cannot be
/// started at all.
ProgramRun run_program(const std::vector<std::string>& arguments, const ProgramWorld& world = {});

}  // namespace somato
