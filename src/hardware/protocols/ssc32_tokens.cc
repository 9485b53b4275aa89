#include "hardware/protocols/ssc32_tokens.h"

namespace somato::wire {
namespace {

constexpr int kMostNumber = 1'000'000;

bool is_ssc32_space(char c) {
  return c == ' ' || c == '\t' || c == '\n';
}

bool is_ssc32_digit(char c) {
  return c >= '0' && c <= '9';
}

bool starts_number(char c) {
  return is_ssc32_digit(c) || c == '+' || c == '-';
}

char in_upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool is_of_name(char c) {
  return c == '#' || (in_upper_case(c) >= 'A' && in_upper_case(c) <= 'Z');
}

bool is_whole_name(char c) {
  return c == ':' || c == '=' || c == '?';
}

void skip_spaces(std::string_view& rest) {
  while (!rest.empty() && is_ssc32_space(rest.front())) rest.remove_prefix(1);
}

// A letter that does not fit is replaced by a mark that no command contains, so that no long name
// becomes a short one.
void add_letter(Ssc32Token& token, char letter) {
  if (token.length < token.letters.size()) {
    token.letters[token.length++] = in_upper_case(letter);
  } else {
    token.letters.back() = '~';
  }
}

bool take_name(std::string_view& rest, Ssc32Token& token) {
  if (!rest.empty() && is_whole_name(rest.front())) {
    add_letter(token, rest.front());
    rest.remove_prefix(1);
  } else {
    for (; !rest.empty() && is_of_name(rest.front()); rest.remove_prefix(1)) {
      add_letter(token, rest.front());
    }
  }
  return token.length > 0;
}

bool take_number(std::string_view& rest, Ssc32Token& token) {
  skip_spaces(rest);
  if (rest.empty() || !starts_number(rest.front())) return true;
  const bool negative = rest.front() == '-';
  if (!is_ssc32_digit(rest.front())) rest.remove_prefix(1);
  int value = 0;
  const std::size_t before = rest.size();
  for (; !rest.empty() && is_ssc32_digit(rest.front()); rest.remove_prefix(1)) {
    value = value * 10 + (rest.front() - '0');
    if (value > kMostNumber) return false;
  }
  token.number = negative ? -value : value;
  return rest.size() < before;
}

}  // namespace

std::optional<Ssc32Tokens> Ssc32Tokens::of(std::string_view line) {
  Ssc32Tokens tokens;
  for (skip_spaces(line); !line.empty(); skip_spaces(line)) {
    if (tokens.count_ == tokens.tokens_.size()) return {};
    Ssc32Token& token = tokens.tokens_[tokens.count_++];
    if (!take_name(line, token) || !take_number(line, token)) return {};
  }
  return tokens;
}

}  // namespace somato::wire
