#include "somato/core/parameter.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace somato {
namespace {

tl::unexpected<Error> refuse(const ParameterInfo& info, const std::string& wanted,
                             const Value& value) {
  return fail(ErrorKind::kUsage,
              fmt::format("'{}' must be {}, not {}", info.name, wanted, to_toml(value)));
}

std::string with_range(const std::string& noun, const Range& range) {
  const std::string limits = to_string(range);
  return limits.empty() ? noun : noun + ", " + limits;
}

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, number);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return number;
}

// A flag's argument says no type, so the parameter's type decides how it is read.
Value scalar_from_text(std::string_view type, std::string_view text) {
  if (type == "switch" && text == "true") return {true};
  if (type == "switch" && text == "false") return {false};
  if (type == "integer" || type == "number") {
    if (const auto whole = parse<std::int64_t>(text)) return {*whole};
  }
  if (type == "number") {
    if (const auto real = parse<double>(text)) return {*real};
  }
  return {std::string(text)};
}

}  // namespace

bool Range::contains(double value) const {
  return std::isfinite(value) && (low_excluded ? value > low : value >= low) && value <= high;
}

std::string to_string(const Range& range) {
  const bool has_low = std::isfinite(range.low);
  const bool has_high = std::isfinite(range.high);
  if (has_low && has_high && !range.low_excluded) {
    return fmt::format("{} to {}", range.low, range.high);
  }
  std::string limits;
  if (has_low) limits = fmt::format("{} {}", range.low_excluded ? "above" : "at least", range.low);
  if (has_high) limits += fmt::format("{}at most {}", has_low ? ", " : "", range.high);
  return limits;
}

namespace detail {

Result<bool> read_switch(const ParameterInfo& info, const Value& value) {
  if (const bool* on = std::get_if<bool>(&value.content)) return *on;
  return refuse(info, "true or false", value);
}

Result<std::int64_t> read_integer(const ParameterInfo& info, const Value& value, std::int64_t least,
                                  std::int64_t most) {
  const auto* whole = std::get_if<std::int64_t>(&value.content);
  if (!whole || !info.range.contains(static_cast<double>(*whole))) {
    return refuse(info, with_range("a whole number", info.range), value);
  }
  if (*whole >= least && *whole <= most) return *whole;
  return refuse(info, fmt::format("a whole number, {} to {}", least, most), value);
}

Result<double> read_number(const ParameterInfo& info, const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value.content);
  const auto* real = std::get_if<double>(&value.content);
  const double number = whole ? static_cast<double>(*whole) : real ? *real : std::nan("");
  if (info.range.contains(number)) return number;
  return refuse(info, with_range("a number", info.range), value);
}

Result<std::string> read_text(const ParameterInfo& info, const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
  return refuse(info, "a text", value);
}

Result<std::size_t> read_choice(const ParameterInfo& info, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  for (std::size_t i = 0; text && i < info.choices.size(); ++i) {
    if (*text == info.choices[i]) return i;
  }
  auto refused = refuse(info, fmt::format("one of {}", fmt::join(info.choices, ", ")), value);
  const std::string nearest = text ? nearest_name(*text, info.choices) : std::string();
  if (!nearest.empty()) refused.value().advice = fmt::format("did you mean '{}'?", nearest);
  return refused;
}

bool is_automatic(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  return text && *text == "automatic";
}

}  // namespace detail

Result<Value> value_from_text(const ParameterInfo& info, std::string_view text) {
  constexpr std::string_view kListOf = "list of ";
  if (!info.type.starts_with(kListOf)) return scalar_from_text(info.type, text);
  const std::string item_type = info.type.substr(kListOf.size());
  Value::List list;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    list.push_back(scalar_from_text(item_type, text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return Value{std::move(list)};
}

Error unknown_name(std::string_view what, std::string_view name, std::string_view where,
                   const std::vector<std::string>& known) {
  return {ErrorKind::kUsage, fmt::format("unknown {} '{}'", what, name), std::string(where),
          name_advice(name, known)};
}

Error not_a_value(std::string_view name, std::string_view where) {
  return {ErrorKind::kUsage, fmt::format("'{}' must be a value, not a table", name),
          std::string(where), fmt::format("write {} = ...", name)};
}

}  // namespace somato
