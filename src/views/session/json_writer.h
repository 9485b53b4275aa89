#pragma once

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <utility>

namespace somato::live {

/// JSON as text that grows number by number, since a document of many numbers would cost more. The
/// caller opens and closes brackets, and writes a key before each value of an object.
class JsonWriter {
 public:
  /// Writes the text unchanged.
  template <typename... Arguments>
  JsonWriter& add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    return *this;
  }

  /// A name may hold anything.
  JsonWriter& key(const std::string& name);

  JsonWriter& open(char bracket) {
    text_.push_back(bracket);
    first_ = true;
    return *this;
  }
  JsonWriter& close(char bracket) {
    text_.push_back(bracket);
    first_ = false;
    return *this;
  }

  /// A comma, but before the first.
  JsonWriter& separate() {
    if (!first_) text_.push_back(',');
    first_ = false;
    return *this;
  }

  /// Five digits are more than a picture shows; most of what is sparse is 0.
  JsonWriter& numbers(std::span<const float> values);

  /// All digits; NaN and infinity are null.
  JsonWriter& exact_numbers(std::span<const float> values);

  /// Infinity and NaN are null, because JSON does not contain them.
  template <typename Number>
  JsonWriter& finite(fmt::format_string<Number&> format, Number value) {
    return std::isfinite(value) ? add(format, value) : add("null");
  }

  std::string take() && { return std::move(text_); }

 private:
  std::string text_;
  bool first_ = true;
};

}  // namespace somato::live
