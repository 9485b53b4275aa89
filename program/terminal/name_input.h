#pragma once

#include <optional>
#include <string>

namespace somato::program {

/// Names for explorations, one per line of standard input. A line is read when it is wanted, so
/// that other lines remain for other readers.
class NameInput {
 public:
  /// The name in a line that is there already; an empty line, and one that is no name, which is
  /// reported, give none.
  std::optional<std::string> take();

  /// The same, but waits for a line until the input ends or a stop is requested. On a terminal it
  /// asks with `question` before.
  std::optional<std::string> ask(const std::string& question);

 private:
  std::optional<std::string> read_name();
  bool has_line_within(int milliseconds);

  bool has_ended_ = false;
};

}  // namespace somato::program
