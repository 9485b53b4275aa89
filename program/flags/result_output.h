#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "flags/command_line.h"
#include "somato/core/value.h"

namespace somato::program {

/// The flag `--json` of commands that print results.
Flag json_flag();

/// An entry of a result: a name with a figure, a text, texts, numbers or tables.
Table::Entry entry(std::string name, std::uint64_t count);
Table::Entry entry(std::string name, double figure);
Table::Entry entry(std::string name, bool is_so);
Table::Entry entry(std::string name, std::string text);
Table::Entry entry(std::string name, const std::vector<std::string>& texts);
Table::Entry entry(std::string name, const std::vector<std::size_t>& numbers);
Table::Entry entry(std::string name, std::vector<Table> tables);

/// An entry with a table for each of `items`, created by `make`.
template <typename Item, typename Make>
Table::Entry entry(std::string name, const std::vector<Item>& items, const Make& make) {
  std::vector<Table> tables;
  tables.reserve(items.size());
  for (const Item& item : items) tables.push_back(make(item));
  return entry(std::move(name), std::move(tables));
}

/// The numbers and texts of a table, one per line: "samples 12". Numbers have six digits.
std::string lines_of(const Table& table);

/// Prints the result of a command on standard output: `text`, or with --json `json`.
void print_result(const Arguments& arguments, const std::string& text, const std::string& json);
void print_result(const Arguments& arguments, const std::string& text, const Table& table);

/// The same for a command whose results are saved in files: --quiet suppresses the text.
void print_summary(const Arguments& arguments, const std::string& text, const std::string& json);
void print_summary(const Arguments& arguments, const std::string& text, const Table& table);

}  // namespace somato::program
