#include "recordings/ros/field_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::pair<std::string_view, RosPrimitive> kPrimitives[] = {
    {"bool", RosPrimitive::kBool},       {"byte", RosPrimitive::kUint8},
    {"char", RosPrimitive::kUint8},      {"int8", RosPrimitive::kInt8},
    {"uint8", RosPrimitive::kUint8},     {"int16", RosPrimitive::kInt16},
    {"uint16", RosPrimitive::kUint16},   {"int32", RosPrimitive::kInt32},
    {"uint32", RosPrimitive::kUint32},   {"int64", RosPrimitive::kInt64},
    {"uint64", RosPrimitive::kUint64},   {"float32", RosPrimitive::kFloat32},
    {"float64", RosPrimitive::kFloat64}, {"string", RosPrimitive::kString},
    {"wstring", RosPrimitive::kWstring},
};

tl::unexpected<Error> no_field(std::string what) {
  return fail(ErrorKind::kData, std::move(what), {},
              "a line declares a field, such as 'float64[] position', or a constant");
}

bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
}

bool continues_identifier(char c) {
  return is_letter(c) || c == '_' || ('0' <= c && c <= '9');
}

// The longest beginning of `text` whose bytes all are `accepted`, which is cut off.
template <typename Accepted>
std::string_view take_while(std::string_view& text, const Accepted& accepted) {
  const auto end = std::find_if_not(text.begin(), text.end(), accepted);
  const std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(taken.size());
  return taken;
}

bool take_text(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

// A number above 0 of at most 32 bits.
std::optional<std::size_t> take_length(std::string_view& text) {
  std::uint32_t length = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (status != std::errc{} || length == 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return length;
}

// "[]", "[3]" or "[<=3]".
bool take_brackets(std::string_view& text, RosField& field) {
  if (!take_text(text, "[")) return true;
  field.kind = RosField::Kind::kSequence;
  field.length = kUnbounded;
  if (take_text(text, "]")) return true;
  if (!take_text(text, "<=")) field.kind = RosField::Kind::kArray;
  const std::optional<std::size_t> length = take_length(text);
  field.length = length.value_or(0);
  return length && take_text(text, "]");
}

// The type with its bounds; nothing if it is not one. Bounds of texts are not used.
std::optional<DeclaredField> parse_declared_type(std::string_view text) {
  DeclaredField declared;
  declared.type = take_while(text, [](char c) { return continues_identifier(c) || c == '/'; });
  const auto* found =
      std::find_if(std::begin(kPrimitives), std::end(kPrimitives),
                   [&](const auto& primitive) { return primitive.first == declared.type; });
  declared.is_primitive = found != std::end(kPrimitives);
  if (declared.is_primitive) declared.field.primitive = found->second;
  const bool is_named = !declared.type.empty() && is_letter(declared.type.front());
  const bool is_bounded = take_text(text, "<=");
  if (is_bounded && (!is_text(declared.field.primitive) || !take_length(text))) return std::nullopt;
  if (!is_named || !take_brackets(text, declared.field) || !text.empty()) return std::nullopt;
  return declared;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

Result<std::optional<DeclaredField>> parse_field_line(std::string_view line) {
  const std::string_view content = trimmed(line.substr(0, line.find('#')));
  if (content.empty()) return std::optional<DeclaredField>();
  std::string_view rest = content;
  std::optional<DeclaredField> declared =
      parse_declared_type(take_while(rest, [](char c) { return !is_blank(c); }));
  if (!declared) return no_field(fmt::format("{} begins with no type", shown(content)));
  rest = trimmed(rest);
  const std::string_view name = take_while(rest, continues_identifier);
  const bool has_name = !name.empty() && (is_letter(name.front()) || name.front() == '_');
  if (!has_name) {
    return no_field(fmt::format("{} declares no name", shown(content)));
  }
  const bool ends = rest.empty() || is_blank(rest.front());
  rest = trimmed(rest);
  if (rest.starts_with('=')) {
    if (declared->is_primitive && declared->field.kind == RosField::Kind::kOne) {
      return std::optional<DeclaredField>();
    }
    return no_field(fmt::format("{} is a constant of no primitive type", shown(content)));
  }
  if (!ends) return no_field(fmt::format("{} declares no name", shown(content)));
  declared->field.name = name;
  return declared;
}

}  // namespace somato
