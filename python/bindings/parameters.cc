#include "parameters.h"

#include <fmt/format.h>

#include <limits>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

Failure unusable(const nb::handle& value, const std::string& where) {
  return {Error{ErrorKind::kUsage,
                fmt::format("a value of type {} is not a parameter's value",
                            nb::cast<std::string>(nb::str(value.type().attr("__name__")))),
                where, "use a number, a text, a bool, None, or a list of them"}};
}

Value list_of(const nb::handle& values, const std::string& where);

// One that no parameter can have is inexact, so that it is refused by its range.
Value whole_number(const nb::object& number) {
  std::int64_t whole = 0;
  if (nb::try_cast(number, whole)) return {whole};
  const double real = PyLong_AsDouble(number.ptr());
  const bool is_larger = PyErr_Occurred() != nullptr;  // than every floating-point number
  PyErr_Clear();
  return {is_larger ? std::numeric_limits<double>::infinity() : real};
}

// Numbers of numpy are numbers too.
Value value_of(const nb::handle& value, const std::string& where) {
  if (value.is_none()) return {std::string("automatic")};
  if (nb::isinstance<nb::bool_>(value)) return {nb::cast<bool>(value)};
  if (nb::isinstance<nb::str>(value)) return {nb::cast<std::string>(value)};
  if (nb::isinstance<nb::list>(value) || nb::isinstance<nb::tuple>(value)) {
    return list_of(value, where);
  }
  if (PyIndex_Check(value.ptr()) != 0) return whole_number(nb::steal(PyNumber_Index(value.ptr())));
  if (nb::hasattr(value, "__float__")) {
    return {nb::cast<double>(nb::steal(PyNumber_Float(value.ptr())))};
  }
  throw unusable(value, where);
}

Value list_of(const nb::handle& values, const std::string& where) {
  Value::List list;
  for (const nb::handle item : values) list.push_back(value_of(item, where));
  return {std::move(list)};
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    text.replace(at, what.size(), by);
    at += by.size();
  }
}

// A value at the end of a message that was refused.
void replace_end(std::string& text, std::string_view end, std::string_view by) {
  if (text.ends_with(end)) text.replace(text.size() - end.size(), end.size(), by);
}

}  // namespace

Error in_python(Error error) {
  replace_all(error.what, "\"automatic\"", "None");
  replace_all(error.advice, "\"automatic\"", "None");
  replace_all(error.what, "true or false", "True or False");
  replace_end(error.what, ", not true", ", not True");
  replace_end(error.what, ", not false", ", not False");
  return error;
}

Table table_of(const nb::dict& values, const std::string& where) {
  Table table{where, {}};
  for (const auto& [key, value] : values) {
    auto name = nb::cast<std::string>(key);
    Value read = value_of(value, fmt::format("{}({})", where, name));
    table.entries.push_back({std::move(name), where, std::move(read)});
  }
  return table;
}

nb::object object_of(const Value& value) {
  if (const auto* list = std::get_if<Value::List>(&value.content)) {
    nb::list objects;
    for (const Value& item : *list) objects.append(object_of(item));
    return objects;
  }
  if (const auto* text = std::get_if<std::string>(&value.content)) {
    return *text == "automatic" ? nb::none() : nb::object(nb::cast(*text));
  }
  if (const auto* flag = std::get_if<bool>(&value.content)) return nb::cast(*flag);
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) return nb::cast(*integer);
  return nb::cast(std::get<double>(value.content));
}

nb::list descriptions_of(const std::vector<ParameterInfo>& infos) {
  nb::list descriptions;
  for (const ParameterInfo& info : infos) {
    nb::dict description;
    description["name"] = info.name;
    description["type"] = info.type;
    description["unit"] = info.unit;
    description["text"] = info.text;
    description["range"] = to_string(info.range);
    description["choices"] = info.choices;
    description["default"] = info.default_text;
    descriptions.append(std::move(description));
  }
  return descriptions;
}

}  // namespace somato::python
