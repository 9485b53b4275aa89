#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// The range of the numbers that a parameter accepts.
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

  /// Whether `value` is finite and in the range.
  bool contains(double value) const;
};

/// "at least 1", "0 to 1", "above 0"; empty for any number.
std::string to_string(const Range& range);

/// The description of a parameter: keys, flags, messages and documentation are derived from it.
struct ParameterInfo {
  std::string name;  ///< Identical in C++, TOML, results and documentation.
  std::string type;  ///< "integer", "number", "text", "switch", "choice" or "list of ...".
  std::string unit;  ///< Empty if there is none.
  std::string text;  ///< One line; contains "not given in the paper" if that is the case.
  Range range;
  std::vector<std::string> choices;  ///< The names of a "choice".
  std::string default_text;          ///< In TOML notation, or "automatic".
};

/// The names of an enumeration's values in order; specialize it for each enumeration that is used
/// in a parameter struct.
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

Result<std::int64_t> read_integer(const ParameterInfo& info, const Value& value, std::int64_t least,
                                  std::int64_t most);
bool is_automatic(const Value& value);

/// `read`, whose error message also mentions "automatic" unless it gives other advice.
Result<void> or_automatic(Result<void> read);

/// The index of the choice that `value` names.
Result<void> read_choice(const ParameterInfo& info, const Value& value, std::size_t& choice);

/// Describes a field of type T, reads it from a Value and writes it to a Value. A field is
/// unchanged if reading fails.
template <typename T>
struct Field;

template <typename T>
concept Scalar = std::integral<T> || std::same_as<T, double> || std::same_as<T, std::string>;

template <Scalar T>
struct Field<T> {
  static std::string type();
  static std::vector<std::string> choices() { return {}; }
  static Result<void> read(const ParameterInfo& info, const Value& value, T& field);
  static Value write(const T& field);
};

template <typename T>
  requires std::is_enum_v<T>
struct Field<T> {
  static std::string type() { return "choice"; }
  static std::vector<std::string> choices() {
    std::vector<std::string> names;
    names.reserve(Choices<T>::all().size());
    for (const auto& choice : Choices<T>::all()) names.push_back(choice.second);
    return names;
  }
  static Result<void> read(const ParameterInfo& info, const Value& value, T& field) {
    std::size_t choice = 0;
    Result<void> read = read_choice(info, value, choice);
    if (read) field = Choices<T>::all()[choice].first;
    return read;
  }
  static Value write(T field) { return {choice_name(field)}; }
};

/// An optional field without a value is written as "automatic".
template <typename T>
struct Field<std::optional<T>> {
  static std::string type() { return Field<T>::type(); }
  static std::vector<std::string> choices() { return Field<T>::choices(); }
  static Result<void> read(const ParameterInfo& info, const Value& value, std::optional<T>& field) {
    std::optional<T> given;
    Result<void> read;
    if (!is_automatic(value)) read = or_automatic(Field<T>::read(info, value, given.emplace()));
    if (read) field = std::move(given);
    return read;
  }
  static Value write(const std::optional<T>& field) {
    return field ? Field<T>::write(*field) : Value{std::string("automatic")};
  }
};

/// A list of one item may be written as that item.
template <typename T>
struct Field<std::vector<T>> {
  static std::string type() { return "list of " + Field<T>::type(); }
  static std::vector<std::string> choices() { return Field<T>::choices(); }
  static Result<void> read(const ParameterInfo& info, const Value& value, std::vector<T>& field) {
    const auto* list = std::get_if<Value::List>(&value.content);
    const Value::List single{value};
    std::vector<T> items;
    for (const Value& item : list ? *list : single) {
      Result<void> read = Field<T>::read(info, item, items.emplace_back());
      if (!read) return read;
    }
    field = std::move(items);
    return {};
  }
  static Value write(const std::vector<T>& field) {
    Value::List list;
    list.reserve(field.size());
    for (const T& item : field) list.push_back(Field<T>::write(item));
    return {std::move(list)};
  }
};

/// Any value, unchanged.
template <>
struct Field<Value> {
  static std::string type() { return "value"; }
  static std::vector<std::string> choices() { return {}; }
  static Result<void> read(const ParameterInfo& /*info*/, const Value& value, Value& field) {
    field = value;
    return {};
  }
  static Value write(const Value& field) { return field; }
};

/// A type-erased Field<T>, so that code for fields is compiled once.
struct FieldType {
  std::size_t size;
  std::string (*type)();
  std::vector<std::string> (*choices)();
  Result<void> (*read)(const ParameterInfo& info, const Value& value, void* field);
  Value (*write)(const void* field);
};

template <typename T>
const FieldType& field_type() {
  static constexpr FieldType kType{
      sizeof(T), &Field<T>::type, &Field<T>::choices,
      [](const ParameterInfo& info, const Value& value, void* field) {
        return Field<T>::read(info, value, *static_cast<T*>(field));
      },
      [](const void* field) { return Field<T>::write(*static_cast<const T*>(field)); }};
  return kType;
}

// The most common types of parameters, compiled once.
extern template const FieldType& field_type<bool>();
extern template const FieldType& field_type<double>();
extern template const FieldType& field_type<std::size_t>();
extern template const FieldType& field_type<std::string>();
extern template const FieldType& field_type<std::optional<double>>();
extern template const FieldType& field_type<std::optional<std::size_t>>();
extern template const FieldType& field_type<std::vector<double>>();
extern template const FieldType& field_type<std::vector<std::size_t>>();
extern template const FieldType& field_type<std::vector<std::string>>();

/// A declared field of a type-erased struct.
struct DeclaredField {
  ParameterInfo info;
  const FieldType* type;
  std::size_t offset;  ///< Offset from the start of the struct, in bytes.

  Result<void> assign(void* target, const Value& value) const;
  Value read(const void* source) const;
};

/// The declared fields of a type-erased struct.
class DeclaredFields {
 public:
  /// `defaults`, a struct of `size` bytes, must outlive this object.
  DeclaredFields(const void* defaults, std::size_t size) : defaults_(defaults), size_(size) {}

  /// Declares a field of the defaults. Throws InvalidArgument for a field outside of them.
  void add(const void* field, const FieldType& type, std::string_view name, std::string_view unit,
           const Range& range, std::string_view text);

  /// Declares fields of `part`, a nested struct in the defaults, as in `declared`. Throws
  /// InvalidArgument for a name that is not declared there.
  void add_from(const void* part, const DeclaredFields& declared,
                std::initializer_list<std::string_view> names);

  const std::vector<DeclaredField>& all() const { return all_; }
  const DeclaredField* find(std::string_view name) const;
  std::vector<std::string> names() const;
  std::vector<ParameterInfo> infos() const;

 private:
  void add(ParameterInfo info, const FieldType& type, const void* field);

  const void* defaults_;
  std::size_t size_;
  std::vector<DeclaredField> all_;
};

Result<void> read_parameters(const DeclaredFields& declared, const Table& table, void* target);
Result<void> check_ranges(const DeclaredFields& declared, const void* parameters, void* scratch);
std::string parameters_to_toml(const DeclaredFields& declared, const void* parameters);

}  // namespace detail

/// A declared field of the struct S; valid during the lifetime of its `Declarations<S>`.
template <typename S>
class Parameter {
 public:
  explicit Parameter(const detail::DeclaredField& field) : info(field.info), field_(field) {}

  const ParameterInfo& info;

  /// Errors (kUsage) name the parameter: a value of the wrong type or out of range.
  Result<void> assign(S& target, const Value& value) const { return field_.assign(&target, value); }

  Value read(const S& source) const { return field_.read(&source); }

 private:
  const detail::DeclaredField& field_;
};

/// The parameters of a plain struct, declared once, in the order of the documentation.
///
/// A parameter struct S has a static function `declarations()` that returns a reference to them.
template <typename S>
class Declarations {
 public:
  /// Declares the field that `access` refers to: `&S::field`, or for a field of a nested struct a
  /// callable from S& to a reference. Throws InvalidArgument for a field outside the struct.
  template <typename Access>
  Declarations& add(std::string_view name, Access access, std::string_view unit, const Range& range,
                    std::string_view text) {
    auto& field = std::invoke(access, defaults());
    using T = std::remove_reference_t<decltype(field)>;
    fields_.add(&field, detail::field_type<T>(), name, unit, range, text);
    return *this;
  }

  /// Declares fields of the nested struct that `access` refers to, as in its own declarations, with
  /// the defaults of S. Throws InvalidArgument for a name that is not declared there.
  template <typename Access, typename Nested>
  Declarations& add_from(Access access, const Declarations<Nested>& declared,
                         std::initializer_list<std::string_view> names) {
    Nested& part = std::invoke(access, defaults());
    fields_.add_from(&part, declared.fields(), names);
    return *this;
  }

  std::vector<Parameter<S>> all() const { return {fields_.all().begin(), fields_.all().end()}; }

  std::optional<Parameter<S>> find(std::string_view name) const {
    const detail::DeclaredField* field = fields_.find(name);
    return field ? std::optional<Parameter<S>>(*field) : std::nullopt;
  }

  std::vector<std::string> names() const { return fields_.names(); }

  /// The descriptions of the parameters.
  std::vector<ParameterInfo> infos() const { return fields_.infos(); }

  const detail::DeclaredFields& fields() const { return fields_; }

 private:
  // Not const because a callable takes an S&; nothing is written here.
  static S& defaults() {
    static S defaults;
    return defaults;
  }

  detail::DeclaredFields fields_{&defaults(), sizeof(S)};
};

/// A parameter's value from a flag's argument, with the most likely type; its validity is checked
/// on assignment. The text of a list is separated by commas.
Value value_from_text(const ParameterInfo& info, std::string_view text);

/// The error for an undeclared key, with the nearest known name.
Error unknown_name(std::string_view what, std::string_view name, std::string_view where,
                   const std::vector<std::string>& known);

/// The value of the enumeration with that name. Errors: unknown_name().
template <typename Enum>
Result<Enum> choice_named(std::string_view what, std::string_view name, std::string_view where) {
  std::vector<std::string> known;
  for (const auto& [value, value_name] : Choices<Enum>::all()) {
    if (value_name == name) return value;
    known.push_back(value_name);
  }
  return fail(unknown_name(what, name, where, known));
}

/// The error for a key that must have a value, not a table.
Error not_a_value(std::string_view name, std::string_view where);

/// Reads the parameters S from all keys of `table`; missing keys keep their defaults. Unknown keys
/// and values out of range are errors (kUsage) with their location.
template <typename S>
Result<S> read_parameters(const Table& table, S parameters = {}) {
  SOMATO_TRY_VOID(detail::read_parameters(S::declarations().fields(), table, &parameters));
  return parameters;
}

/// Whether every parameter is in its declared range, regardless of how the struct was filled.
/// Errors (kUsage) name the first parameter that is not.
template <typename S>
Result<void> check_ranges(const S& parameters) {
  S scratch;
  return detail::check_ranges(S::declarations().fields(), &parameters, &scratch);
}

/// Every parameter of `parameters` as a line `name = value`, in TOML.
template <typename S>
std::string parameters_to_toml(const S& parameters) {
  return detail::parameters_to_toml(S::declarations().fields(), &parameters);
}

}  // namespace somato
