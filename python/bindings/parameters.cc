#include "parameters.h"

#include <fmt/format.h>

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

// Numbers of numpy are numbers too.
Value value_of(const nb::handle& value, const std::string& where) {
  if (value.is_none()) return {std::string("automatic")};
  if (nb::isinstance<nb::bool_>(value)) return {nb::cast<bool>(value)};
  if (nb::isinstance<nb::str>(value)) return {nb::cast<std::string>(value)};
  if (nb::isinstance<nb::list>(value) || nb::isinstance<nb::tuple>(value)) {
    return list_of(value, where);
  }
  if (PyIndex_Check(value.ptr()) != 0) {
    return {nb::cast<std::int64_t>(nb::steal(PyNumber_Index(value.ptr())))};
  }
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

}  // namespace

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
