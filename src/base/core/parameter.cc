#include "somato/core/parameter.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text/number_of_text.h"
#include "somato/core/check.h"

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

// A flag's argument has no type, so it is read according to the parameter's type.
Value scalar_from_text(std::string_view type, std::string_view text) {
  if (type == "switch" && text == "true") return {true};
  if (type == "switch" && text == "false") return {false};
  if (type == "integer" || type == "number") {
    if (const auto whole = number_of_text<std::int64_t>(text)) return {*whole};
  }
  if (type == "number") {
    if (const auto real = number_of_text<double>(text)) return {*real};
  }
  return {std::string(text)};
}

Result<void> read_scalar(const ParameterInfo& info, const Value& value, bool& field) {
  const bool* on = std::get_if<bool>(&value.content);
  if (!on) return refuse(info, "true or false", value);
  field = *on;
  return {};
}

Result<void> read_scalar(const ParameterInfo& info, const Value& value, double& field) {
  const auto* whole = std::get_if<std::int64_t>(&value.content);
  const auto* real = std::get_if<double>(&value.content);
  const double number = whole ? static_cast<double>(*whole) : real ? *real : std::nan("");
  if (!info.range.contains(number)) {
    return refuse(info, with_range("a number", info.range), value);
  }
  field = number;
  return {};
}

Result<void> read_scalar(const ParameterInfo& info, const Value& value, std::string& field) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (!text) return refuse(info, "a text", value);
  field = *text;
  return {};
}

template <std::integral T>
Result<void> read_scalar(const ParameterInfo& info, const Value& value, T& field) {
  constexpr auto kLeast = static_cast<std::int64_t>(std::numeric_limits<T>::min());
  constexpr auto kMost = std::in_range<std::int64_t>(std::numeric_limits<T>::max())
                             ? static_cast<std::int64_t>(std::numeric_limits<T>::max())
                             : std::numeric_limits<std::int64_t>::max();
  SOMATO_TRY(const auto whole, detail::read_integer(info, value, kLeast, kMost));
  field = static_cast<T>(whole);
  return {};
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

Result<std::int64_t> read_integer(const ParameterInfo& info, const Value& value, std::int64_t least,
                                  std::int64_t most) {
  const auto* whole = std::get_if<std::int64_t>(&value.content);
  if (!whole || !info.range.contains(static_cast<double>(*whole))) {
    return refuse(info, with_range("a whole number", info.range), value);
  }
  if (*whole >= least && *whole <= most) return *whole;
  return refuse(info, fmt::format("a whole number, {} to {}", least, most), value);
}

bool is_automatic(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  return text && *text == "automatic";
}

Result<void> or_automatic(Result<void> read) {
  if (!read && read.error().advice.empty()) {
    read.error().advice = "\"automatic\" is also accepted";
  }
  return read;
}

Result<void> read_choice(const ParameterInfo& info, const Value& value, std::size_t& choice) {
  const auto* text = std::get_if<std::string>(&value.content);
  for (std::size_t i = 0; text && i < info.choices.size(); ++i) {
    if (*text != info.choices[i]) continue;
    choice = i;
    return {};
  }
  auto refused = refuse(info, fmt::format("one of {}", fmt::join(info.choices, ", ")), value);
  const std::string nearest = text ? nearest_name(*text, info.choices) : std::string();
  if (!nearest.empty()) refused.value().advice = fmt::format("did you mean '{}'?", nearest);
  return refused;
}

template <Scalar T>
std::string Field<T>::type() {
  if constexpr (std::same_as<T, bool>) return "switch";
  if constexpr (std::same_as<T, double>) return "number";
  return std::same_as<T, std::string> ? "text" : "integer";
}

template <Scalar T>
Result<void> Field<T>::read(const ParameterInfo& info, const Value& value, T& field) {
  return read_scalar(info, value, field);
}

template <Scalar T>
Value Field<T>::write(const T& field) {
  if constexpr (std::integral<T> && !std::same_as<T, bool>) {
    return {static_cast<std::int64_t>(field)};
  } else {
    return {field};
  }
}

template struct Field<bool>;
template struct Field<double>;
template struct Field<std::string>;
template struct Field<unsigned char>;
template struct Field<short>;
template struct Field<unsigned short>;
template struct Field<int>;
template struct Field<unsigned>;
template struct Field<long>;
template struct Field<unsigned long>;
template struct Field<long long>;
template struct Field<unsigned long long>;

template const FieldType& field_type<bool>();
template const FieldType& field_type<double>();
template const FieldType& field_type<std::size_t>();
template const FieldType& field_type<std::string>();
template const FieldType& field_type<std::optional<double>>();
template const FieldType& field_type<std::optional<std::size_t>>();
template const FieldType& field_type<std::vector<double>>();
template const FieldType& field_type<std::vector<std::size_t>>();
template const FieldType& field_type<std::vector<std::string>>();

Result<void> DeclaredField::assign(void* target, const Value& value) const {
  return type->read(info, value, static_cast<std::byte*>(target) + offset);
}

Value DeclaredField::read(const void* source) const {
  return type->write(static_cast<const std::byte*>(source) + offset);
}

void DeclaredFields::add(const void* field, const FieldType& type, std::string_view name,
                         std::string_view unit, const Range& range, std::string_view text) {
  add({std::string(name),
       type.type(),
       std::string(unit),
       std::string(text),
       range,
       type.choices(),
       {}},
      type, field);
}

void DeclaredFields::add_from(const void* part, const DeclaredFields& declared,
                              std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    const DeclaredField* field = declared.find(name);
    if (!field)
      throw InvalidArgument(to_string(unknown_name("parameter", name, {}, declared.names())));
    add(field->info, *field->type, static_cast<const std::byte*>(part) + field->offset);
  }
}

void DeclaredFields::add(ParameterInfo info, const FieldType& type, const void* field) {
  // As numbers, since pointers into different structs cannot be subtracted.
  const std::size_t offset =
      reinterpret_cast<std::uintptr_t>(field) - reinterpret_cast<std::uintptr_t>(defaults_);
  require(offset < size_ && type.size <= size_ - offset, "a parameter is a field of its struct");
  info.default_text = to_toml(type.write(field));
  all_.push_back({std::move(info), &type, offset});
}

const DeclaredField* DeclaredFields::find(std::string_view name) const {
  for (const DeclaredField& field : all_) {
    if (field.info.name == name) return &field;
  }
  return nullptr;
}

std::vector<std::string> DeclaredFields::names() const {
  std::vector<std::string> names;
  names.reserve(all_.size());
  for (const DeclaredField& field : all_) names.push_back(field.info.name);
  return names;
}

std::vector<ParameterInfo> DeclaredFields::infos() const {
  std::vector<ParameterInfo> infos;
  infos.reserve(all_.size());
  for (const DeclaredField& field : all_) infos.push_back(field.info);
  return infos;
}

Result<void> read_parameters(const DeclaredFields& declared, const Table& table, void* target) {
  for (const Table::Entry& entry : table.entries) {
    const DeclaredField* field = declared.find(entry.name);
    if (!field) return fail(unknown_name("key", entry.name, entry.where, declared.names()));
    const Value* value = std::get_if<Value>(&entry.content);
    if (!value) return fail(not_a_value(entry.name, entry.where));
    Result<void> assigned = field->assign(target, *value);
    if (assigned) continue;
    assigned.error().where = entry.where;
    return assigned;
  }
  return {};
}

Result<void> check_ranges(const DeclaredFields& declared, const void* parameters, void* scratch) {
  for (const DeclaredField& field : declared.all()) {
    Result<void> assigned = field.assign(scratch, field.read(parameters));
    if (!assigned) return assigned;
  }
  return {};
}

std::string parameters_to_toml(const DeclaredFields& declared, const void* parameters) {
  std::string text;
  for (const DeclaredField& field : declared.all()) {
    text += field.info.name + " = " + to_toml(field.read(parameters)) + "\n";
  }
  return text;
}

}  // namespace detail

Value value_from_text(const ParameterInfo& info, std::string_view text) {
  constexpr std::string_view kListOf = "list of ";
  if (!info.type.starts_with(kListOf)) return scalar_from_text(info.type, text);
  const std::string item_type = info.type.substr(kListOf.size());
  Value::List list;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    list.push_back(scalar_from_text(item_type, text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return {std::move(list)};
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
