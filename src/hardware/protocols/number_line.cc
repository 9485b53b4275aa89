#include "hardware/protocols/number_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

// A line may be longer than its numbers: it has names, or is the wrong one that a message quotes.
constexpr std::size_t kLeastLineBytes = 256;

std::size_t most_line_bytes(std::size_t values, const std::vector<LineName>& names) {
  std::size_t bytes = kMostNumberBytes * values;
  for (const LineName& name : names) bytes += name.name.size() + 1;
  return std::max(kLeastLineBytes, bytes);
}

std::string printable(std::span<const char> text) {
  constexpr std::size_t kShown = 80;
  std::string shown;
  for (const char c : text.first(std::min(text.size(), kShown))) {
    const bool is_plain = c >= ' ' && c <= '~';
    shown += c == '\t'  ? "\\t"
             : is_plain ? std::string(1, c)
                        : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return shown + (text.size() > kShown ? "..." : "");
}

}  // namespace

std::size_t encode_number_line(std::span<const float> values, std::span<std::uint8_t> bytes) {
  require(!values.empty(), "a line without numbers");
  require(bytes.size() >= kMostNumberBytes * values.size(), "the memory for a line is too small");
  char* const begin = reinterpret_cast<char*>(bytes.data());
  char* end = begin;
  for (const float value : values) {
    require(!std::isinf(value), "a sensor value is infinite");
    end = std::to_chars(end, begin + bytes.size(), value).ptr;
    *end++ = ',';
  }
  end[-1] = '\n';
  return static_cast<std::size_t>(end - begin);
}

NumberLineDecoder::NumberLineDecoder(std::size_t values, const std::vector<LineName>& names)
    : fields_(values, names),
      values_(values),
      candidate_(values),
      line_(most_line_bytes(values, names)),
      last_(line_.size()),
      wrong_(line_.size()) {}

// A line that is too long is counted only, and finish() rejects it.
bool NumberLineDecoder::take(std::uint8_t byte) {
  if (byte == '\n' || byte == '\r') return finish();
  if (size_ < line_.size()) line_[size_] = static_cast<char>(byte);
  ++size_;
  return false;
}

bool NumberLineDecoder::finish() {
  if (size_ == 0) {
    began_ = true;
    return false;
  }
  const bool counts = std::exchange(began_, true);
  const bool accepted = counts && read();
  std::swap(line_, last_);
  last_size_ = std::min(std::exchange(size_, 0), last_.size());
  if (accepted || !counts) return accepted;
  ++rejected_;
  wrong_ = last_;
  wrong_size_ = last_size_;
  return false;
}

bool NumberLineDecoder::read() {
  if (size_ > line_.size()) {
    fault_ = {LineFault::Kind::kTooLong, line_.size()};
    return false;
  }
  const auto fault = fields_.read({line_.data(), size_}, candidate_);
  if (fault) fault_ = *fault;
  if (!fault) std::copy(candidate_.begin(), candidate_.end(), values_.begin());
  return !fault;
}

std::string NumberLineDecoder::complaint() const {
  if (rejected_ > 0) {
    return fmt::format("the last line was '{}': {}",
                       printable(std::span(wrong_).first(wrong_size_)), fields_.to_string(fault_));
  }
  if (began_ || size_ == 0) return {};
  return fmt::format("{} characters arrived without an end of line: '{}'", size_,
                     printable(std::span(line_).first(std::min(size_, line_.size()))));
}

std::string NumberLineDecoder::last_line() const {
  return printable(std::span(last_).first(last_size_));
}

}  // namespace somato::wire
