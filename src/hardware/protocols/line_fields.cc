#include "hardware/protocols/line_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

using Kind = LineFault::Kind;

constexpr std::string_view kLineBlanks = " \t";
constexpr std::string_view kNameEnds = ":=";
constexpr float kNoReading = std::numeric_limits<float>::quiet_NaN();

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kLineBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kLineBlanks) + 1);
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_same_word(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other, {}, lower, lower);
}

// std::from_chars accepts no '+', and reads words for infinity and for no number in other forms.
std::optional<float> number_in(std::string_view text) {
  constexpr std::array<std::string_view, 3> kNone{"nan", "inf", "ovf"};
  const bool has_sign = text.starts_with('+') || text.starts_with('-');
  const std::string_view digits = text.substr(has_sign ? 1 : 0);
  for (const std::string_view word : kNone) {
    if (is_same_word(digits, word)) return kNoReading;
  }
  if (digits.starts_with('-')) return std::nullopt;
  float number = 0.0F;
  const char* const begin = text.starts_with('+') ? digits.data() : text.data();
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(begin, end, number);
  const bool is_number = error == std::errc() && rest == end && std::isfinite(number);
  return is_number ? std::optional(number) : std::nullopt;
}

// The fields of a line, one after the other.
class FieldCutter {
 public:
  FieldCutter(std::string_view line, bool has_names) : rest_(trimmed(line)), names_(has_names) {
    if (rest_.find(',') != std::string_view::npos) separator_ = ',';
    if (rest_.find(';') != std::string_view::npos) separator_ = ';';
    if (separator_ != kBlank && rest_.ends_with(separator_)) rest_.remove_suffix(1);
  }

  std::optional<std::string_view> next() {
    if (ended_) return std::nullopt;
    const std::size_t end = separator_ == kBlank ? blank_after_field() : rest_.find(separator_);
    const std::string_view field = trimmed(rest_.substr(0, end));
    ended_ = end == std::string_view::npos;
    if (!ended_) rest_.remove_prefix(end + 1);
    if (separator_ == kBlank) rest_ = trimmed(rest_);
    return field;
  }

 private:
  static constexpr char kBlank = ' ';

  // Blanks around the mark behind a name, and in the name, separate nothing.
  std::size_t blank_after_field() const {
    const std::size_t mark = names_ ? rest_.find_first_of(kNameEnds) : std::string_view::npos;
    const bool is_named = mark != std::string_view::npos;
    const std::size_t number = is_named ? rest_.find_first_not_of(kLineBlanks, mark + 1) : 0;
    return rest_.find_first_of(kLineBlanks, number);
  }

  std::string_view rest_;
  bool names_;
  char separator_ = kBlank;
  bool ended_ = false;
};

// The only place with such a name; none: no such name; `count`: several places.
template <typename Same>
std::optional<std::size_t> place_of(const std::vector<LineName>& names, std::size_t count,
                                    const Same& same) {
  std::optional<std::size_t> place;
  for (const LineName& known : names) {
    if (!same(known.name)) continue;
    if (place && *place != known.place) return count;
    place = known.place;
  }
  return place;
}

}  // namespace

LineFields::LineFields(std::size_t values, std::vector<LineName> names)
    : count_(values), names_(std::move(names)), seen_(values) {
  require(values > 0, "a line without numbers");
  for (const LineName& name : names_) require(name.place < values, "a name beyond the values");
}

std::optional<LineFault> LineFields::read(std::string_view line, std::span<float> values) {
  require(values.size() == count_, "LineFields::read: another number of values");
  const auto has = [&](std::string_view marks) {
    return line.find_first_of(marks) != std::string_view::npos;
  };
  if (has(",") && has(";")) return LineFault{Kind::kSeparators, 0};
  return has(kNameEnds) ? read_by_name(line, values) : read_in_order(line, values);
}

std::optional<LineFault> LineFields::read_in_order(std::string_view line,
                                                   std::span<float> values) const {
  std::optional<LineFault> fault;
  std::size_t count = 0;
  FieldCutter fields(line, false);
  while (const auto field = fields.next()) {
    const std::optional<float> number = number_in(*field);
    ++count;
    if (!number && !fault) fault = {field->empty() ? Kind::kEmpty : Kind::kNoNumber, count};
    if (number && count <= count_) values[count - 1] = *number;
  }
  return count == count_ ? fault : LineFault{Kind::kCount, count};
}

std::optional<LineFault> LineFields::read_by_name(std::string_view line, std::span<float> values) {
  if (names_.empty()) return LineFault{Kind::kNoNames, 0};
  std::ranges::fill(values, kNoReading);
  std::ranges::fill(seen_, 0);
  std::size_t count = 0;
  FieldCutter fields(line, true);
  while (const auto field = fields.next()) {
    ++count;
    const std::size_t mark = field->find_first_of(kNameEnds);
    if (mark == std::string_view::npos) return LineFault{Kind::kUnnamed, count};
    const std::optional<float> number = number_in(trimmed(field->substr(mark + 1)));
    if (!number) return LineFault{Kind::kNoNumber, count};
    if (const auto kind = put(trimmed(field->substr(0, mark)), *number, values)) {
      return LineFault{*kind, count};
    }
  }
  for (const LineName& name : names_) {
    if (seen_[name.place] == 0) return LineFault{Kind::kMissing, name.place};
  }
  return std::nullopt;
}

std::optional<Kind> LineFields::put(std::string_view name, float number, std::span<float> values) {
  auto place = place_of(names_, count_, [&](std::string_view known) { return known == name; });
  if (!place) {
    place =
        place_of(names_, count_, [&](std::string_view known) { return is_same_word(known, name); });
  }
  if (!place) return std::nullopt;
  if (*place == count_) return Kind::kAmbiguous;
  if (std::exchange(seen_[*place], 1) != 0) return Kind::kRepeated;
  values[*place] = number;
  return std::nullopt;
}

std::string LineFields::to_string(const LineFault& fault) const {
  const std::size_t number = fault.number;
  switch (fault.kind) {
    case Kind::kTooLong:
      return fmt::format("more than {} characters", number);
    case Kind::kSeparators:
      return "both commas and semicolons";
    case Kind::kCount:
      return fmt::format("{} {} instead of {}", number, number == 1 ? "field" : "fields", count_);
    case Kind::kEmpty:
      return fmt::format("field {} is empty", number);
    case Kind::kNoNumber:
      return fmt::format("field {} is no number", number);
    case Kind::kUnnamed:
      return fmt::format("field {} has no name, but another has", number);
    case Kind::kNoNames:
      return "it names its values, but no sensor has elements in these frames";
    case Kind::kRepeated:
      return fmt::format("the name of field {} occurs twice", number);
    case Kind::kAmbiguous:
      return fmt::format("the name of field {} stands for elements of several sensors", number);
    case Kind::kMissing:
      break;
  }
  const auto missing =
      std::ranges::find_if(names_, [&](const LineName& name) { return name.place == number; });
  return fmt::format("the element '{}' is missing", missing->name);
}

}  // namespace somato::wire
