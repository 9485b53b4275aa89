#include "base/files/toml_file.h"

#include <fmt/format.h>

// Without exceptions, and compiled in so that an installed library needs nothing more.
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
// With NDEBUG, the compiler would assume what toml++ asserts, which is wrong for texts such as
// "[=]"; they are refused a few lines later.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <utility>

#include "base/files/whole_file.h"
#include "base/text/dotted_keys.h"
#include "base/text/json_text.h"
#include "base/text/toml_letters.h"

namespace somato {
namespace {

using Content = std::variant<Value, Table, std::vector<Table>>;

class Converter {
 public:
  explicit Converter(std::string_view where) : where_(where) {}

  Result<Table> table(const toml::table& source, int depth) const {
    if (depth > kDeepestNesting) return too_deep(source);
    Table out{line(source.source()), {}};
    for (const auto& item : in_order(source)) {
      SOMATO_TRY(Content converted, content(*item.second, depth + 1));
      out.entries.push_back(
          {without_stand_ins(item.first->str()), line(item.first->source()), std::move(converted)});
    }
    return out;
  }

 private:
  using Item = std::pair<const toml::key*, const toml::node*>;

  static std::vector<Item> in_order(const toml::table& source) {
    std::vector<Item> items;
    for (auto&& [key, node] : source) items.emplace_back(&key, &node);
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return a.first->source().begin < b.first->source().begin;
    });
    return items;
  }

  std::string line(const toml::source_region& source) const {
    if (!source.begin) return where_;
    return fmt::format("{}:{}", where_, source.begin.line);
  }

  tl::unexpected<Error> refuse(const toml::node& node, std::string what, std::string advice) const {
    const toml::source_position begin = node.source().begin;
    return fail(ErrorKind::kUsage, std::move(what),
                fmt::format("{}:{}:{}", where_, begin.line, begin.column), std::move(advice));
  }

  tl::unexpected<Error> too_deep(const toml::node& node) const {
    return refuse(node, fmt::format("more than {} levels of nesting", kDeepestNesting),
                  "flatten the description");
  }

  Result<Content> content(const toml::node& node, int depth) const {
    if (const toml::table* inner = node.as_table()) {
      return table(*inner, depth).map([](Table&& out) { return Content(std::move(out)); });
    }
    const toml::array* array = node.as_array();
    if (array && !array->empty() && array->is_array_of_tables()) return tables(*array, depth);
    return value(node, depth).map([](Value&& out) { return Content(std::move(out)); });
  }

  Result<Content> tables(const toml::array& array, int depth) const {
    std::vector<Table> out;
    for (const toml::node& node : array) {
      SOMATO_TRY(Table converted, table(*node.as_table(), depth));
      out.push_back(std::move(converted));
    }
    return Content(std::move(out));
  }

  Result<Value> value(const toml::node& node, int depth) const {
    switch (node.type()) {
      case toml::node_type::boolean:
        return Value{node.as_boolean()->get()};
      case toml::node_type::integer:
        return Value{node.as_integer()->get()};
      case toml::node_type::floating_point:
        return Value{node.as_floating_point()->get()};
      case toml::node_type::string:
        return Value{without_stand_ins(node.as_string()->get())};
      case toml::node_type::array:
        return list(*node.as_array(), depth);
      default:
        return refuse(node, "dates and times are not supported in descriptions",
                      "put it in quotation marks if it is a text");
    }
  }

  Result<Value> list(const toml::array& array, int depth) const {
    if (depth > kDeepestNesting) return too_deep(array);
    Value::List out;
    for (const toml::node& node : array) {
      if (node.is_table()) {
        return refuse(node, "an array of values contains a table", "use an array of tables");
      }
      if (!same_kind(node, array[0])) {
        return refuse(node, "the array mixes types", "give all its values the same type");
      }
      Result<Value> converted = value(node, depth + 1);
      if (!converted) return converted;
      out.push_back(std::move(*converted));
    }
    return Value{std::move(out)};
  }

  static bool same_kind(const toml::node& a, const toml::node& b) {
    return a.type() == b.type() || (a.is_number() && b.is_number());
  }

  std::string where_;
};

// Line and column of what follows `before`.
std::string place_after(std::string_view before, std::string_view where) {
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::string_view of_line = before.substr(before.rfind('\n') + 1);
  const auto column = 1 + std::ranges::count_if(of_line, [](char c) { return (c & 0xC0) != 0x80; });
  return fmt::format("{}:{}:{}", where, line, column);
}

std::string written_key(const std::string& name) {
  const bool is_bare = !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  return is_bare ? name : to_toml(Value{name});
}

// The entries of a table with the name `path`, which ends with a point unless it is empty.
std::string written(const Table& table, const std::string& path) {
  std::string text;
  for (const Table::Entry& entry : table.entries) {
    const auto* value = std::get_if<Value>(&entry.content);
    if (value) text += written_key(entry.name) + " = " + to_toml(*value) + "\n";
  }
  for (const Table::Entry& entry : table.entries) {
    const std::string name = path + written_key(entry.name);
    if (const auto* inner = std::get_if<Table>(&entry.content)) {
      text += "\n[" + name + "]\n" + written(*inner, name + ".");
    }
    if (const auto* list = std::get_if<std::vector<Table>>(&entry.content)) {
      for (const Table& one : *list) text += "\n[[" + name + "]]\n" + written(one, name + ".");
    }
  }
  return text;
}

}  // namespace

std::string to_toml(const Table& table) {
  return written(table, "");
}

Result<Table> parse_toml(std::string_view text, std::string_view where) {
  if (text.size() > kLargestToml) {
    return fail(ErrorKind::kUsage, fmt::format("the text is larger than {} bytes", kLargestToml),
                std::string(where), "check that it is the right file");
  }
  if (const std::size_t line = line_of_long_key(text, kDeepestNesting); line > 0) {
    return fail(ErrorKind::kUsage, fmt::format("a key of more than {} parts", kDeepestNesting + 1),
                fmt::format("{}:{}", where, line), "flatten the description");
  }
  if (const std::size_t bad = first_stand_in(text); bad != std::string_view::npos) {
    return fail(ErrorKind::kUsage,
                "a character of U+C0000 to U+CFFFF, which Unicode does not assign",
                place_after(text.substr(0, bad), where), "replace it");
  }
  const toml::parse_result parsed = toml::parse(with_stand_ins(text));
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    const toml::source_position begin = error.source().begin;
    return fail(ErrorKind::kUsage, without_stand_ins(error.description()),
                fmt::format("{}:{}:{}", where, begin.line, begin.column), "correct the TOML there");
  }
  return Converter(where).table(parsed.table(), 0);
}

Result<Table> read_toml(const std::string& path) {
  return read_whole(path, kLargestToml).and_then([&](const std::string& bytes) {
    return parse_toml(bytes, path);
  });
}

const Table* table_in(const Table& table, const std::string& name) {
  const Table::Entry* entry = table.find(name);
  return entry ? std::get_if<Table>(&entry->content) : nullptr;
}

}  // namespace somato
