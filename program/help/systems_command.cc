#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/result_output.h"
#include "somato/studies/own_systems.h"

namespace somato::program {
namespace {

// The body of the file's exploration; empty if it requires data.
std::string body_of(const Table& file) {
  const Table::Entry* explore = file.find("explore");
  const auto* table = explore ? std::get_if<Table>(&explore->content) : nullptr;
  const Table::Entry* body = table ? table->find("body") : nullptr;
  const auto* value = body ? std::get_if<Value>(&body->content) : nullptr;
  const auto* name = value ? std::get_if<std::string>(&value->content) : nullptr;
  return name ? *name : std::string();
}

std::string text_of(const std::string& title, const std::vector<NamedFile>& files) {
  std::size_t width = 0;
  for (const NamedFile& file : files) width = std::max(width, file.name.size());
  std::string text = title + "\n";
  for (const NamedFile& file : files) {
    const std::string body = body_of(file.content);
    text += body.empty() ? fmt::format("  {}\n", file.name)
                         : fmt::format("  {:<{}}  explores with {}\n", file.name, width, body);
  }
  return text;
}

Table table_of(const NamedFile& file) {
  Table table{
      {}, {entry("name", file.name), entry("file", std::string(find_own_file(file.name)->path))}};
  const std::string body = body_of(file.content);
  if (!body.empty()) table.entries.push_back(entry("body", body));
  return table;
}

void list(const Arguments& arguments, const OwnSystems& own) {
  const auto of_file = [](const NamedFile& file) { return table_of(file); };
  print_result(
      arguments,
      text_of("The papers' systems, for somato run and somato reproduce:", own.systems) +
          text_of("\nThe same systems for public data sets, with --data:", own.recorded) +
          text_of("\nStudies of public data sets, with --data:", own.studies) +
          text_of("\nQuestions about the papers' systems, for somato reproduce:", own.questions) +
          text_of("\nSystems beyond the papers, which their authors announced:", own.announced) +
          text_of("\nComparisons of these with the papers' systems, for somato reproduce:",
                  own.announced_questions) +
          "\n'somato systems NAME' prints the file of a system as a template; 'somato modules' "
          "lists the\ntypes of modules.\n",
      Table{{},
            {entry("systems", own.systems, of_file), entry("recorded", own.recorded, of_file),
             entry("studies", own.studies, of_file), entry("questions", own.questions, of_file),
             entry("announced", own.announced, of_file),
             entry("announced_questions", own.announced_questions, of_file)}});
}

Result<void> print_file(const Arguments& arguments) {
  const std::string name = arguments.text("NAME");
  if (arguments.has("json")) {
    return fail(ErrorKind::kUsage, "the file is TOML, not JSON", "--json",
                "omit --json, or omit NAME");
  }
  if (const auto file = find_own_file(name)) {
    std::fwrite(file->text.data(), 1, file->text.size(), stdout);
    return {};
  }
  return fail(unknown_name("system", name, "systems", own_file_names()));
}

Result<void> run_systems(const Arguments& arguments) {
  if (arguments.has("NAME")) return print_file(arguments);
  return own_systems().map([&](const OwnSystems& own) { list(arguments, own); });
}

}  // namespace

Command systems_command() {
  return {"systems",
          "List the built-in systems and studies, or print the file of one",
          {{"NAME", "Print the file of this system or study", false, false, Role::kValue,
            own_file_names}},
          {json_flag()},
          {},
          run_systems};
}

}  // namespace somato::program
