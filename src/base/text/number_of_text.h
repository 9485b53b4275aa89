#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace somato {

/// The number that `text` is as a whole, in the form of std::from_chars and without blanks; nothing
/// for another text, and for a number that the type does not hold.
template <typename Number>
std::optional<Number> number_of_text(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, number);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace somato
