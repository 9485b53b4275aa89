#include "recordings/ros/definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "base/text/text.h"
#include "recordings/ros/field_line.h"

namespace somato {
namespace {

constexpr std::size_t kDeepestType = 32;
constexpr std::string_view kFolder = "/msg/";
constexpr std::string_view kSectionHead = "MSG:";

// A line of `text` without its end, which is cut off.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool is_rule(std::string_view line) {
  const std::string_view content = trimmed(line);
  return !content.empty() && content.find_first_not_of('=') == std::string_view::npos;
}

// Compiles a type after those that it contains.
class DefinitionCompiler {
 public:
  explicit DefinitionCompiler(const std::map<std::string, RosDefinitions::Text>& texts)
      : texts_(&texts) {}

  Result<RosType> run(const std::string& name) {
    SOMATO_TRY_VOID(compile(name, "the topic's type"));
    return std::move(type_);
  }

 private:
  Result<std::size_t> compile(const std::string& name, const std::string& user) {
    const auto known = compiled_.find(name);
    if (known != compiled_.end()) return known->second;
    const auto* definition = find(name);
    if (!definition) {
      return fail(ErrorKind::kData, fmt::format("there is no definition of {}", shown(name)), user);
    }
    if (open_.size() == kDeepestType ||
        std::find(open_.begin(), open_.end(), name) != open_.end()) {
      return fail(ErrorKind::kData,
                  fmt::format("{} contains itself, or more than {} levels of types",
                              shown(open_.front()), kDeepestType),
                  user);
    }
    open_.push_back(name);
    SOMATO_TRY(RosStructure structure, compile_fields(name, *definition));
    open_.pop_back();
    type_.structures.push_back(std::move(structure));
    return compiled_.emplace(name, type_.structures.size() - 1).first->second;
  }

  const RosDefinitions::Text* find(const std::string& name) const {
    static const RosDefinitions::Text time{"int32 sec\nuint32 nanosec\n", "builtin", 1};
    const auto found = texts_->find(name);
    if (found != texts_->end()) return &found->second;
    const bool is_time = name == "builtin_interfaces/Time" || name == "builtin_interfaces/Duration";
    return is_time ? &time : nullptr;
  }

  Result<RosStructure> compile_fields(const std::string& name,
                                      const RosDefinitions::Text& definition) {
    RosStructure structure{name, {}, 0};
    std::set<std::string> names;
    std::string_view rest = definition.text;
    for (std::size_t line = definition.line; !rest.empty(); ++line) {
      const std::string place = fmt::format("{}:{}", definition.where, line);
      auto declared = parse_field_line(take_line(rest));
      if (!declared) {
        declared.error().where = place;
        return fail(std::move(declared.error()));
      }
      if (!*declared) continue;
      if (!names.insert((*declared)->field.name).second) {
        return fail(ErrorKind::kData,
                    fmt::format("there are two fields {}", shown((*declared)->field.name)), place);
      }
      SOMATO_TRY_VOID(add(structure, std::move(**declared), place));
    }
    // IDL has no structures without members: ROS 2 adds one byte.
    structure.least_bytes = std::max<std::size_t>(structure.least_bytes, 1);
    return structure;
  }

  Result<void> add(RosStructure& structure, DeclaredField declared, const std::string& place) {
    if (!declared.is_primitive) {
      SOMATO_TRY(const std::size_t index, compile(resolve(declared.type, structure.name), place));
      declared.field.structure = index;
    }
    const std::size_t least = least_bytes_of(type_, declared.field);
    structure.least_bytes =
        least > kUnbounded - structure.least_bytes ? kUnbounded : structure.least_bytes + least;
    structure.fields.push_back(std::move(declared.field));
    return {};
  }

  // The name with its package, as the type `user` means it.
  std::string resolve(const std::string& type, const std::string& user) const {
    if (type == "time") return "builtin_interfaces/Time";
    if (type == "duration") return "builtin_interfaces/Duration";
    if (type.find('/') != std::string::npos) return ros_type_name(type);
    const std::string sibling = user.substr(0, user.find('/')) + "/" + type;
    return type == "Header" && !find(sibling) ? "std_msgs/Header" : sibling;
  }

  const std::map<std::string, RosDefinitions::Text>* texts_;
  RosType type_;
  std::map<std::string, std::size_t> compiled_;
  std::vector<std::string> open_;
};

}  // namespace

std::string ros_type_name(std::string_view name) {
  const std::size_t folder = name.find(kFolder);
  if (folder == std::string_view::npos) return std::string(name);
  return fmt::format("{}/{}", name.substr(0, folder), name.substr(folder + kFolder.size()));
}

void RosDefinitions::add(std::string_view name, std::string_view text, std::string where,
                         std::size_t line) {
  texts_.emplace(ros_type_name(name), Text{std::string(text), std::move(where), line});
}

void RosDefinitions::add_all(std::string_view name, std::string_view text) {
  const std::string where = fmt::format("definition of {}", name);
  std::string section(name);
  std::size_t first = 1;
  std::string_view begin = text;
  std::string_view rest = text;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::string_view before = rest;
    if (!is_rule(take_line(rest))) continue;
    add(section, begin.substr(0, static_cast<std::size_t>(before.data() - begin.data())), where,
        first);
    const std::string_view head = trimmed(take_line(rest));
    ++line;
    section = head.starts_with(kSectionHead) ? trimmed(head.substr(kSectionHead.size())) : head;
    begin = rest;
    first = line + 1;
  }
  add(section, begin, where, first);
}

Result<RosType> RosDefinitions::compile(std::string_view name) const {
  return DefinitionCompiler(texts_).run(ros_type_name(name));
}

Result<std::string> RosDefinitions::all_of(std::string_view name) const {
  SOMATO_TRY(RosType type, compile(name));
  std::string all = texts_.at(type.root().name).text;
  type.structures.pop_back();
  for (const RosStructure& structure : type.structures) {
    const auto found = texts_.find(structure.name);
    if (found == texts_.end()) continue;
    all += fmt::format("\n===\nMSG: {}\n{}", structure.name, found->second.text);
  }
  return all;
}

Result<RosType> compile_ros_definition(std::string_view name, std::string_view encoding,
                                       std::string_view definition) {
  if (encoding != "ros2msg") {
    return fail(
        ErrorKind::kData,
        fmt::format("its definition is in the encoding {}, not in ros2msg", shown(encoding)), {},
        "give its .msg files");
  }
  RosDefinitions definitions;
  definitions.add_all(name, definition);
  return definitions.compile(name);
}

}  // namespace somato
