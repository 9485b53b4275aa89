#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace somato::wire {

/// A name and the number after it, as the SSC-32 splits a line: a name is a run of letters and `#`,
/// or one of `:`, `=` and `?`; spaces may stand anywhere between names and numbers.
struct Ssc32Token {
  std::array<char, 8> letters{};  ///< In upper case; longer names are cut, and equal no command.
  std::size_t length = 0;
  std::optional<int> number;

  std::string_view name() const { return {letters.data(), length}; }
};

/// The tokens of one line, without its carriage return, in memory of a fixed size.
class Ssc32Tokens {
 public:
  /// Empty if the line contains other characters than those of tokens, a number without a name, or
  /// a number beyond +-1,000,000. Lines have at most as many tokens as the board's receive queue
  /// has bytes.
  static std::optional<Ssc32Tokens> of(std::string_view line);

  std::span<const Ssc32Token> all() const { return std::span(tokens_).first(count_); }

 private:
  std::array<Ssc32Token, 128> tokens_{};
  std::size_t count_ = 0;
};

}  // namespace somato::wire
