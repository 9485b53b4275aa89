#include "recordings/ros/json_messages.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/text/json_text.h"
#include "base/text/text.h"
#include "recordings/ros/cdr.h"

namespace somato {
namespace {

using SchemaJson = nlohmann::ordered_json;

constexpr const char* kItems = "items";
constexpr std::size_t kMostStructures = 1000;

tl::unexpected<Error> bad_schema(std::string what) {
  return fail(ErrorKind::kData, std::move(what), "JSON Schema");
}

class SchemaCompiler {
 public:
  explicit SchemaCompiler(const SchemaJson& root) : root_(&root) {}

  Result<RosType> run(std::string_view name) {
    SOMATO_TRY(const std::optional<RosField> field, field_of(*root_, 0));
    if (!field || !field->structure || field->kind != RosField::Kind::kOne) {
      return bad_schema("the messages are not objects with properties");
    }
    type_.structures.back().name = name;
    return std::move(type_);
  }

 private:
  // The schema that a reference names, or `schema` itself. Of alternatives, the first that is not
  // null.
  Result<const SchemaJson*> resolved(const SchemaJson& schema) const {
    const SchemaJson* found = &schema;
    for (int i = 0; i < kDeepestNesting; ++i) {
      if (!found->is_object()) return found;
      const SchemaJson* next = alternative_in(*found);
      if (found->contains("$ref")) {
        SOMATO_TRY(next, referred((*found)["$ref"]));
      }
      if (!next) return found;
      found = next;
    }
    return bad_schema("it refers to itself");
  }

  Result<const SchemaJson*> referred(const SchemaJson& reference) const {
    const std::string path = reference.is_string() ? reference.get<std::string>() : std::string();
    if (path.starts_with("#/")) {
      const SchemaJson* at = root_;
      for (const std::string& part : split(path.substr(2), '/')) {
        at = at && at->is_object() && at->contains(part) ? &(*at)[part] : nullptr;
      }
      if (at) return at;
    }
    return bad_schema(fmt::format("it refers to {}, which it does not contain", shown(path)));
  }

  static const SchemaJson* alternative_in(const SchemaJson& schema) {
    for (const char* key : {"oneOf", "anyOf"}) {
      if (!schema.contains(key) || !schema[key].is_array()) continue;
      for (const SchemaJson& alternative : schema[key]) {
        if (type_of(alternative) != "null") return &alternative;
      }
    }
    return nullptr;
  }

  // The type of a schema; of several, the first that is not null.
  static std::string type_of(const SchemaJson& schema) {
    if (!schema.is_object()) return {};
    if (!schema.contains("type")) return schema.contains("properties") ? "object" : "";
    const SchemaJson& type = schema["type"];
    if (type.is_string()) return type.get<std::string>();
    for (const SchemaJson& each : type) {
      if (each.is_string() && each != "null") return each.get<std::string>();
    }
    return {};
  }

  // The field of a value, without a name; nothing for types that no field has.
  Result<std::optional<RosField>> field_of(const SchemaJson& schema, int depth) {
    if (depth > kDeepestNesting) return bad_schema("it is nested too deeply");
    SOMATO_TRY(const SchemaJson* plain, resolved(schema));
    const std::string type = type_of(*plain);
    RosField field;
    if (type == "array") return array_of(*plain, depth);
    if (type == "object") return structure_of(*plain, depth);
    if (type == "number" || type == "integer") {
      field.primitive = RosPrimitive::kFloat64;
    } else if (type == "boolean") {
      field.primitive = RosPrimitive::kBool;
    } else if (type == "string") {
      field.primitive = RosPrimitive::kString;
    } else {
      return std::optional<RosField>();
    }
    return std::optional(std::move(field));
  }

  Result<std::optional<RosField>> array_of(const SchemaJson& schema, int depth) {
    if (!schema.contains(kItems)) return std::optional<RosField>();
    SOMATO_TRY(std::optional<RosField> field, field_of(schema[kItems], depth + 1));
    if (!field) return field;
    if (field->kind == RosField::Kind::kSequence) {
      field->name = kItems;
      SOMATO_TRY(field, added({"", {std::move(*field)}, 0}));
    }
    field->kind = RosField::Kind::kSequence;
    field->length = kUnbounded;
    return field;
  }

  Result<std::optional<RosField>> structure_of(const SchemaJson& schema, int depth) {
    RosStructure structure;
    if (schema.contains("properties") && schema["properties"].is_object()) {
      for (const auto& [name, property] : schema["properties"].items()) {
        SOMATO_TRY(std::optional<RosField> field, field_of(property, depth + 1));
        if (!field) continue;
        field->name = name;
        structure.fields.push_back(std::move(*field));
      }
    }
    return added(std::move(structure));
  }

  Result<std::optional<RosField>> added(RosStructure structure) {
    if (type_.structures.size() == kMostStructures) {
      return bad_schema(fmt::format("it has more than {} objects", kMostStructures));
    }
    for (const RosField& field : structure.fields) {
      structure.least_bytes += least_bytes_of(type_, field);
    }
    structure.least_bytes = std::max<std::size_t>(structure.least_bytes, 1);
    RosField field;
    field.structure = type_.structures.size();
    type_.structures.push_back(std::move(structure));
    return std::optional(std::move(field));
  }

  const SchemaJson* root_;
  RosType type_;
};

class JsonToCdr {
 public:
  explicit JsonToCdr(const RosType& type) : type_(&type) {}

  // `value` may be null, for one that is missing.
  void write_structure(const RosStructure& structure, const nlohmann::json& value) {
    if (structure.fields.empty()) writer_.number(std::uint8_t{0});
    for (const RosField& field : structure.fields) {
      const bool is_items = structure.name.empty() && field.name == kItems && value.is_array();
      const auto found = value.is_object() ? value.find(field.name) : value.end();
      const bool is_known = value.is_object() && found != value.end();
      write_field(field, is_items ? value : is_known ? *found : kNothing);
    }
  }

  const std::string& bytes() const { return writer_.bytes(); }

 private:
  void write_field(const RosField& field, const nlohmann::json& value) {
    if (field.kind == RosField::Kind::kOne) return write_element(field, value);
    writer_.number(static_cast<std::uint32_t>(value.is_array() ? value.size() : 0));
    if (!value.is_array()) return;
    for (const nlohmann::json& element : value) write_element(field, element);
  }

  void write_element(const RosField& field, const nlohmann::json& value) {
    if (field.structure) {
      write_structure(type_->structures[*field.structure], value);
    } else if (field.primitive == RosPrimitive::kBool) {
      writer_.number(static_cast<std::uint8_t>(value.is_boolean() && value.get<bool>() ? 1 : 0));
    } else if (field.primitive == RosPrimitive::kString) {
      writer_.text(value.is_string() ? value.get_ref<const std::string&>() : std::string());
    } else {
      writer_.number(value.is_number() ? value.get<double>()
                                       : std::numeric_limits<double>::quiet_NaN());
    }
  }

  static inline const nlohmann::json kNothing;
  const RosType* type_;
  CdrWriter writer_;
};

}  // namespace

Result<RosType> compile_json_schema(std::string_view name, std::string_view schema) {
  SOMATO_TRY(const auto root, parse_json<SchemaJson>(schema, "JSON Schema", ""));
  return SchemaCompiler(root).run(name);
}

Result<std::string> cdr_of_json(const RosType& type, std::string_view message) {
  SOMATO_TRY(const auto value, parse_json<nlohmann::json>(message, "message", ""));
  if (!value.is_object()) return fail(ErrorKind::kData, "the message is not a JSON object");
  JsonToCdr writer(type);
  writer.write_structure(type.root(), value);
  return writer.bytes();
}

}  // namespace somato
