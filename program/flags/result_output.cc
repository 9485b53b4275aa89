#include "flags/result_output.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "base/text/json_table.h"
#include "terminal/terminal.h"

namespace somato::program {

Flag json_flag() {
  return {"--json", "Print the result as JSON", false, false};
}

Table::Entry entry(std::string name, std::uint64_t count) {
  return {std::move(name), {}, Value{static_cast<std::int64_t>(count)}};
}

Table::Entry entry(std::string name, double figure) {
  return {std::move(name), {}, Value{figure}};
}

Table::Entry entry(std::string name, bool is_so) {
  return {std::move(name), {}, Value{is_so}};
}

Table::Entry entry(std::string name, std::string text) {
  return {std::move(name), {}, Value{std::move(text)}};
}

Table::Entry entry(std::string name, const std::vector<std::string>& texts) {
  Value::List list;
  list.reserve(texts.size());
  for (const std::string& text : texts) list.emplace_back().content = text;
  return {std::move(name), {}, Value{std::move(list)}};
}

Table::Entry entry(std::string name, const std::vector<std::size_t>& numbers) {
  Value::List list;
  list.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    list.emplace_back().content = static_cast<std::int64_t>(number);
  }
  return {std::move(name), {}, Value{std::move(list)}};
}

Table::Entry entry(std::string name, std::vector<Table> tables) {
  return {std::move(name), {}, std::move(tables)};
}

std::string lines_of(const Table& table) {
  std::string lines;
  for (const Table::Entry& line : table.entries) {
    const auto& value = std::get<Value>(line.content);
    const auto* figure = std::get_if<double>(&value.content);
    lines +=
        fmt::format("{} {}\n", line.name, figure ? fmt::format("{:.6g}", *figure) : to_toml(value));
  }
  return lines;
}

void print_result(const Arguments& arguments, const std::string& text, const std::string& json) {
  const std::string& printed = arguments.has("json") ? json : text;
  std::fwrite(printed.data(), 1, printed.size(), stdout);
}

void print_result(const Arguments& arguments, const std::string& text, const Table& table) {
  print_result(arguments, text, to_json(table));
}

void print_summary(const Arguments& arguments, const std::string& text, const std::string& json) {
  print_result(arguments, is_quiet() ? std::string() : text, json);
}

void print_summary(const Arguments& arguments, const std::string& text, const Table& table) {
  print_summary(arguments, text, to_json(table));
}

}  // namespace somato::program
