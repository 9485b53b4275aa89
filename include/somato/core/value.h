#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace somato {

/// One value of a description: a TOML value, a flag's argument, a parameter's default.
struct Value {
  using List = std::vector<Value>;
  std::variant<bool, std::int64_t, double, std::string, List> content;

  bool operator==(const Value&) const = default;
};

/// The value in TOML notation: `true`, `15`, `0.5`, `"plane"`, `[1, 2]`. Reading a written number
/// gives the same bits.
std::string to_toml(const Value& value);

/// A table of a description, with the location of every key for messages.
struct Table {
  struct Entry;

  std::string where;  ///< `FILE:LINE` of the table's header, or of the file.
  std::vector<Entry> entries;

  /// The entry with that name, or nullptr.
  const Entry* find(std::string_view name) const;
};

/// A key of a table with a value, a table, or a list of tables.
struct Table::Entry {
  std::string name;
  std::string where;  ///< `FILE:LINE` of the key.
  std::variant<Value, Table, std::vector<Table>> content;
};

/// The name in `known` with the smallest edit distance to `name`, or an empty string if none is
/// similar enough.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// "did you mean 'NEAREST'?", or "known are: A, B, C" if none is similar.
std::string name_advice(std::string_view name, const std::vector<std::string>& known);

}  // namespace somato
