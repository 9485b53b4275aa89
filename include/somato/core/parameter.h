#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// The numbers a parameter may take.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;

  static Range any() { return {}; }
  static Range at_least(double low) {
    return {low, std::numeric_limits<double>::infinity(), false};
  }
  static Range above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
  static Range between(double low, double high) { return {low, high, false}; }

  /// Whether `value` is a finite number inside.
  bool contains(double value) const;
};

/// "at least 1", "0 to 1", "above 0"; empty for any number.
std::string to_string(const Range& range);

/// What is said about a parameter, once: keys, flags, messages and documentation come from it.
struct ParameterInfo {
  std::string name;  ///< Spelled the same in C++, TOML, results and documentation.
  std::string type;  ///< "integer", "number", "text", "switch", "choice" or "list of ...".
  std::string unit;  ///< Empty where there is none.
  std::string text;  ///< One line; says "not given in the paper" where that is so.
  Range range;
  std::vector<std::string> choices;  ///< Of a "choice".
  std::string default_text;          ///< As TOML writes it, or "automatic".
};

/// The names of an enumeration's values in their order: specialize it for each enumeration that
/// stands in a parameter struct.
template <typename Enum>
struct Choices;  // static const std::vector<std::pair<Enum, std::string>>& all();

/// The name of an enumeration's value.
template <typename Enum>
const std::string& choice_name(Enum value) {
  const auto& all = Choices<Enum>::all();
  for (const auto& [candidate, name] : all) {
    if (candidate == value) return name;
  }
  return all.front().second;
}

namespace detail {

Result<bool> read_switch(const ParameterInfo& info, const Value& value);
Result<std::int64_t> read_integer(const ParameterInfo& info, const Value& value, std::int64_t least,
                                  std::int64_t most);
Result<double> read_number(const ParameterInfo& info, const Value& value);
Result<std::string> read_text(const ParameterInfo& info, const Value& value);
Result<std::size_t> read_choice(const ParameterInfo& info, const Value& value);
bool is_automatic(const Value& value);

/// How a field of type T is read from, written to and described by a Value.
template <typename T>
struct Field;

template <>
struct Field<bool> {
  static std::string type() { return "switch"; }
  static Result<bool> read(const ParameterInfo& info, const Value& value) {
    return read_switch(info, value);
  }
  static Value write(bool field) { return {field}; }
};

template <>
struct Field<double> {
  static std::string type() { return "number"; }
  static Result<double> read(const ParameterInfo& info, const Value& value) {
    return read_number(info, value);
  }
  static Value write(double field) { return {field}; }
};

template <>
struct Field<std::string> {
  static std::string type() { return "text"; }
  static Result<std::string> read(const ParameterInfo& info, const Value& value) {
    return read_text(info, value);
  }
  static Value write(const std::string& field) { return {field}; }
};

template <typename T>
  requires std::is_integral_v<T>
struct Field<T> {
  static std::string type() { return "integer"; }
  static Result<T> read(const ParameterInfo& info, const Value& value) {
    constexpr auto kLeast = static_cast<std::int64_t>(std::numeric_limits<T>::min());
    constexpr auto kMost = std::in_range<std::int64_t>(std::numeric_limits<T>::max())
                               ? static_cast<std::int64_t>(std::numeric_limits<T>::max())
                               : std::numeric_limits<std::int64_t>::max();
    return read_integer(info, value, kLeast, kMost).map([](std::int64_t whole) {
      return static_cast<T>(whole);
    });
  }
  static Value write(T field) { return {static_cast<std::int64_t>(field)}; }
};

template <typename T>
  requires std::is_enum_v<T>
struct Field<T> {
  static std::string type() { return "choice"; }
  static Result<T> read(const ParameterInfo& info, const Value& value) {
    return read_choice(info, value).map([](std::size_t i) { return Choices<T>::all()[i].first; });
  }
  static Value write(T field) { return {choice_name(field)}; }
};

/// An optional field is written "automatic" while it has no value.
template <typename T>
struct Field<std::optional<T>> {
  static std::string type() { return Field<T>::type(); }
  static Result<std::optional<T>> read(const ParameterInfo& info, const Value& value) {
    if (is_automatic(value)) return std::optional<T>{};
    Result<T> field = Field<T>::read(info, value);
    if (field) return std::optional<T>(std::move(*field));
    if (field.error().advice.empty()) field.error().advice = "\"automatic\" is possible too";
    return fail(std::move(field.error()));
  }
  static Value write(const std::optional<T>& field) {
    return field ? Field<T>::write(*field) : Value{std::string("automatic")};
  }
};

template <typename T>
struct Field<std::vector<T>> {
  static std::string type() { return "list of " + Field<T>::type(); }
  static Result<std::vector<T>> read(const ParameterInfo& info, const Value& value) {
    const auto* list = std::get_if<Value::List>(&value.content);
    const Value::List single{value};
    std::vector<T> fields;
    for (const Value& item : list ? *list : single) {
      Result<T> field = Field<T>::read(info, item);
      if (!field) return fail(std::move(field.error()));
      fields.push_back(std::move(*field));
    }
    return fields;
  }
  static Value write(const std::vector<T>& fields) {
    Value::List list;
    list.reserve(fields.size());
    for (const T& field : fields) list.push_back(Field<T>::write(field));
    return {std::move(list)};
  }
};

template <typename T>
struct ChoiceNames {
  static std::vector<std::string> of() {
    std::vector<std::string> names;
    if constexpr (std::is_enum_v<T>) {
      names.reserve(Choices<T>::all().size());
      for (const auto& choice : Choices<T>::all()) names.push_back(choice.second);
    }
    return names;
  }
};

template <typename T>
struct ChoiceNames<std::optional<T>> : ChoiceNames<T> {};

template <typename T>
struct ChoiceNames<std::vector<T>> : ChoiceNames<T> {};

}  // namespace detail

/// A declared field of the struct S.
template <typename S>
struct Parameter {
  ParameterInfo info;
  std::function<Result<void>(S&, const Value&)> assign;  ///< Refuses what is out of range.
  std::function<Value(const S&)> read;
};

/// The parameters of a plain struct, declared once, in the order of the documentation.
///
/// A parameter struct S has a static function `declarations()` that returns a reference to them.
template <typename S>
class Declarations {
 public:
  /// Declares the field that `access` reaches (a callable from S& to a reference, so that fields of
  /// nested structs can be declared too).
  template <typename Access>
  Declarations& add(std::string name, Access access, std::string unit, Range range,
                    std::string text) {
    using T = std::remove_cvref_t<decltype(access(std::declval<S&>()))>;
    S defaults;
    ParameterInfo info{std::move(name),
                       detail::Field<T>::type(),
                       std::move(unit),
                       std::move(text),
                       range,
                       detail::ChoiceNames<T>::of(),
                       to_toml(detail::Field<T>::write(access(defaults)))};
    auto assign = [info, access](S& target, const Value& value) -> Result<void> {
      Result<T> field = detail::Field<T>::read(info, value);
      if (!field) return fail(std::move(field.error()));
      access(target) = std::move(*field);
      return {};
    };
    auto read = [access](const S& source) {
      S copy = source;
      return detail::Field<T>::write(access(copy));
    };
    all_.push_back({std::move(info), std::move(assign), std::move(read)});
    return *this;
  }

  const std::vector<Parameter<S>>& all() const { return all_; }

  const Parameter<S>* find(std::string_view name) const {
    for (const Parameter<S>& parameter : all_) {
      if (parameter.info.name == name) return &parameter;
    }
    return nullptr;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(all_.size());
    for (const Parameter<S>& parameter : all_) names.push_back(parameter.info.name);
    return names;
  }

 private:
  std::vector<Parameter<S>> all_;
};

/// Reads a parameter's value from a flag's argument; the text of a list is separated by commas.
/// Errors (kUsage) name the parameter.
Result<Value> value_from_text(const ParameterInfo& info, std::string_view text);

/// The failure for a key nobody declared, with the nearest known name.
Error unknown_name(std::string_view what, std::string_view name, std::string_view where,
                   const std::vector<std::string>& known);

/// The failure for a key that should hold a value, not a table.
Error not_a_value(std::string_view name, std::string_view where);

/// Reads the parameters S from all keys of `table`; keys that are missing keep their defaults.
/// Unknown keys and values out of range are errors (kUsage) with their place.
template <typename S>
Result<S> read_parameters(const Table& table, S parameters = {}) {
  const Declarations<S>& declarations = S::declarations();
  for (const Table::Entry& entry : table.entries) {
    const Parameter<S>* parameter = declarations.find(entry.name);
    if (!parameter) return fail(unknown_name("key", entry.name, entry.where, declarations.names()));
    const Value* value = std::get_if<Value>(&entry.content);
    if (!value) return fail(not_a_value(entry.name, entry.where));
    Result<void> assigned = parameter->assign(parameters, *value);
    if (!assigned) {
      assigned.error().where = entry.where;
      return fail(std::move(assigned.error()));
    }
  }
  return parameters;
}

/// Every parameter of `parameters` as a line `name = value`, in TOML.
template <typename S>
std::string parameters_to_toml(const S& parameters) {
  std::string text;
  for (const Parameter<S>& parameter : S::declarations().all()) {
    text += parameter.info.name + " = " + to_toml(parameter.read(parameters)) + "\n";
  }
  return text;
}

}  // namespace somato
