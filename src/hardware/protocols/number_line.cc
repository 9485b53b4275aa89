#include "hardware/protocols/number_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

bool read_number(std::string_view text, float& number) {
  text = without_blanks(text);
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end && std::isfinite(number);
}

}  // namespace

std::size_t encode_number_line(std::span<const float> values, std::span<std::uint8_t> bytes) {
  require(!values.empty(), "a line without numbers");
  require(bytes.size() >= kMostNumberBytes * values.size(), "the memory for a line is too small");
  char* const begin = reinterpret_cast<char*>(bytes.data());
  char* end = begin;
  for (const float value : values) {
    require(std::isfinite(value), "a sensor value is not finite");
    end = std::to_chars(end, begin + bytes.size(), value).ptr;
    *end++ = ',';
  }
  end[-1] = '\n';
  return static_cast<std::size_t>(end - begin);
}

NumberLineDecoder::NumberLineDecoder(std::size_t values)
    : values_(values), candidate_(values), line_(kMostNumberBytes * values) {
  require(values > 0, "a line without numbers");
}

// A line that is too long is counted only, and finish() rejects it.
bool NumberLineDecoder::take(std::uint8_t byte) {
  if (byte == '\n') return finish();
  if (size_ < line_.size()) line_[size_] = static_cast<char>(byte);
  ++size_;
  return false;
}

bool NumberLineDecoder::finish() {
  if (size_ > 0 && size_ <= line_.size() && line_[size_ - 1] == '\r') --size_;
  const bool counts = began_ && size_ > 0;
  const bool accepted = counts && size_ <= line_.size() && read();
  if (counts && !accepted) ++rejected_;
  began_ = true;
  size_ = 0;
  return accepted;
}

bool NumberLineDecoder::read() {
  std::string_view rest(line_.data(), size_);
  for (std::size_t i = 0; i < candidate_.size(); ++i) {
    const bool last = i + 1 == candidate_.size();
    const std::size_t comma = rest.find(',');
    if (last != (comma == std::string_view::npos)) return false;
    if (!read_number(rest.substr(0, comma), candidate_[i])) return false;
    if (!last) rest.remove_prefix(comma + 1);
  }
  std::copy(candidate_.begin(), candidate_.end(), values_.begin());
  return true;
}

}  // namespace somato::wire
