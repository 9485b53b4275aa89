#include "base/support/json_schema.h"
#include "base/support/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

namespace somato::testing {
namespace {

using Json = nlohmann::json;
using Files = std::map<std::string, Json>;

// A schema, and the file that its references start from.
struct Schema {
  const Json& json;
  const std::string& file;

  bool has(const char* keyword) const { return json.contains(keyword); }
  Schema at(const char* keyword) const { return {json.at(keyword), file}; }
  Schema of(const Json& part) const { return {part, file}; }
};

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw std::invalid_argument(place + ": " + what);
}

Schema referred(const Files& files, const std::string& from, const std::string& reference) {
  const std::size_t sign = reference.find('#');
  const std::string name = sign == 0 ? from : reference.substr(0, sign);
  const auto file = files.find(name);
  if (file == files.end()) refuse(from, "'" + reference + "' names no file");
  if (sign == std::string::npos) return {file->second, file->first};
  const Json::json_pointer pointer(reference.substr(sign + 1));
  if (!file->second.contains(pointer)) refuse(from, "'" + reference + "' refers to nothing");
  return {file->second.at(pointer), file->first};
}

bool is_of_type(const Json& value, const std::string& type) {
  if (type == "integer") {
    return value.is_number_integer() ||
           (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
  }
  if (type == "number") return value.is_number();
  return value.type_name() == type;  // null, boolean, string, array, object
}

std::vector<std::string> types_of(const Json& keyword) {
  if (keyword.is_string()) return {keyword.get<std::string>()};
  return keyword.get<std::vector<std::string>>();
}

// The values that additionalProperties admits.
bool admits_nothing(const Json& keyword) {
  return keyword.is_boolean() && !keyword.get<bool>();
}

// Whether a schema is one of the subset.
class SchemaCheck {
 public:
  explicit SchemaCheck(const Files& files) : files_(files) {}

  void check(const Schema& schema, const std::string& place) const {
    if (!schema.json.is_object()) refuse(place, "a schema is an object");
    for (const auto& [keyword, content] : schema.json.items()) {
      check_keyword(schema, keyword, content, place + "/" + keyword);
    }
    const bool is_object =
        schema.json.contains("properties") || schema.json.value("type", Json()) == "object";
    if (is_object && !schema.has("additionalProperties")) {
      refuse(place, "an object states its additionalProperties");
    }
  }

 private:
  void check_keyword(const Schema& schema, const std::string& keyword, const Json& content,
                     const std::string& place) const {
    static const std::set<std::string> any{"$schema", "description", "const"};
    static const std::set<std::string> lists{"enum", "anyOf", "required"};
    static const std::set<std::string> numbers{"minimum", "maximum", "minItems", "maxItems"};
    static const std::set<std::string> schemas{"items", "additionalProperties"};
    static const std::set<std::string> maps{"$defs", "properties"};
    const auto expect = [&](bool is) {
      if (!is) refuse(place, fmt::format("is {}", content.type_name()));
    };
    if (keyword == "$ref") {
      expect(content.is_string());
      static_cast<void>(referred(files_, schema.file, content.get<std::string>()));
    } else if (keyword == "type") {
      check_types(content, place);
    } else if (lists.contains(keyword)) {
      expect(content.is_array());
      if (keyword == "anyOf") check_each(schema, content, place);
    } else if (numbers.contains(keyword)) {
      expect(content.is_number());
    } else if (schemas.contains(keyword)) {
      if (!admits_nothing(content)) check(schema.of(content), place);
    } else if (maps.contains(keyword)) {
      expect(content.is_object());
      check_each(schema, content, place);
    } else if (!any.contains(keyword)) {
      refuse(place, "is an unknown keyword");
    }
  }

  static void check_types(const Json& content, const std::string& place) {
    static const std::set<std::string> known{"null",   "boolean", "integer", "number",
                                             "string", "array",   "object"};
    if (!content.is_string() && !content.is_array()) refuse(place, "is no type");
    for (const std::string& type : types_of(content)) {
      if (!known.contains(type)) refuse(place, "'" + type + "' is no type");
    }
  }

  void check_each(const Schema& schema, const Json& parts, const std::string& place) const {
    for (const auto& [name, part] : parts.items()) check(schema.of(part), place + "/" + name);
  }

  const Files& files_;
};

// The errors in a value.
class Validation {
 public:
  explicit Validation(const Files& files) : files_(files) {}

  void visit(const Schema& schema, const Json& value, const std::string& place) {
    if (schema.has("$ref")) {
      visit(referred(files_, schema.file, schema.json["$ref"].get<std::string>()), value, place);
    }
    visit_choices(schema, value, place);
    if (value.is_number()) visit_number(schema, value, place);
    if (value.is_array()) visit_array(schema, value, place);
    if (value.is_object()) visit_object(schema, value, place);
  }

  std::vector<std::string> take() && { return std::move(problems_); }

 private:
  void report(const std::string& place, const std::string& what) {
    problems_.push_back((place.empty() ? "the whole" : place) + " " + what);
  }

  void visit_choices(const Schema& schema, const Json& value, const std::string& place) {
    if (schema.has("type")) {
      const auto types = types_of(schema.json["type"]);
      if (std::none_of(types.begin(), types.end(),
                       [&](const std::string& type) { return is_of_type(value, type); })) {
        report(place, fmt::format("is {}, not {}", value.type_name(), fmt::join(types, " or ")));
      }
    }
    if (schema.has("const") && value != schema.json["const"]) {
      report(place, "is not " + schema.json["const"].dump());
    }
    if (schema.has("enum")) {
      const Json& choices = schema.json["enum"];
      if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
        report(place, "is " + value.dump() + ", not one of " + choices.dump());
      }
    }
    if (schema.has("anyOf")) visit_alternatives(schema.at("anyOf"), value, place);
  }

  // If none is met, all that is wrong by any of them.
  void visit_alternatives(const Schema& alternatives, const Json& value, const std::string& place) {
    std::vector<std::string> all;
    for (const Json& alternative : alternatives.json) {
      Validation other(files_);
      other.visit(alternatives.of(alternative), value, place);
      if (other.problems_.empty()) return;
      all.insert(all.end(), other.problems_.begin(), other.problems_.end());
    }
    problems_.insert(problems_.end(), all.begin(), all.end());
  }

  void visit_number(const Schema& schema, const Json& value, const std::string& place) {
    if (schema.has("minimum") && value < schema.json["minimum"]) {
      report(place, "is " + value.dump() + ", below " + schema.json["minimum"].dump());
    }
    if (schema.has("maximum") && value > schema.json["maximum"]) {
      report(place, "is " + value.dump() + ", above " + schema.json["maximum"].dump());
    }
  }

  void visit_array(const Schema& schema, const Json& value, const std::string& place) {
    if (schema.has("minItems") && value.size() < schema.json["minItems"].get<std::size_t>()) {
      report(place, fmt::format("has only {} items", value.size()));
    }
    if (schema.has("maxItems") && value.size() > schema.json["maxItems"].get<std::size_t>()) {
      report(place, fmt::format("has {} items", value.size()));
    }
    if (!schema.has("items")) return;
    for (std::size_t i = 0; i < value.size(); ++i) {
      visit(schema.at("items"), value[i], place + "/" + std::to_string(i));
    }
  }

  void visit_object(const Schema& schema, const Json& value, const std::string& place) {
    if (schema.has("required")) {
      for (const Json& name : schema.json["required"]) {
        if (!value.contains(name.get<std::string>())) report(place, "lacks " + name.dump());
      }
    }
    static const Json none = Json::object();
    const Json& known = schema.has("properties") ? schema.json["properties"] : none;
    for (const auto& [name, part] : value.items()) {
      const std::string inside = place + "/" + name;
      if (known.contains(name)) {
        visit(schema.of(known[name]), part, inside);
      } else if (schema.has("additionalProperties")) {
        visit_other(schema.at("additionalProperties"), part, inside);
      }
    }
  }

  void visit_other(const Schema& others, const Json& part, const std::string& place) {
    if (admits_nothing(others.json)) {
      report(place, "is unknown");
    } else {
      visit(others, part, place);
    }
  }

  const Files& files_;
  std::vector<std::string> problems_;
};

Files files_of(const std::filesystem::path& folder) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(entry.path());
    files[entry.path().filename().string()] = Json::parse(stream);
  }
  return files;
}

const JsonSchemas& page_schemas() {
  static const JsonSchemas schemas(files_of(source_path("web/schema")));
  return schemas;
}

}  // namespace

JsonSchemas::JsonSchemas(std::map<std::string, Json> files) : files_(std::move(files)) {
  for (const auto& [name, schema] : files_) SchemaCheck(files_).check({schema, name}, name + "#");
}

std::vector<std::string> JsonSchemas::problems(const Json& value,
                                               const std::string& reference) const {
  Validation validation(files_);
  validation.visit(referred(files_, {}, reference), value, {});
  return std::move(validation).take();
}

::testing::AssertionResult fits_schema(const Json& value, const std::string& reference) {
  constexpr std::size_t kMostShown = 10;
  std::vector<std::string> problems = page_schemas().problems(value, reference);
  if (problems.empty()) return ::testing::AssertionSuccess();
  const std::size_t count = problems.size();
  problems.resize(std::min(count, kMostShown));
  return ::testing::AssertionFailure()
         << fmt::format("{} problems by {}:\n{}", count, reference, fmt::join(problems, "\n"));
}

::testing::AssertionResult text_fits_schema(std::string_view text, const std::string& reference) {
  const Json value = Json::parse(text, nullptr, false);
  if (!value.is_discarded()) return fits_schema(value, reference);
  return ::testing::AssertionFailure() << "no JSON: " << text;
}

}  // namespace somato::testing
