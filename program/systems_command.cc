#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "somato/studies/own_systems.h"

namespace somato::program {
namespace {

std::string body_of(const Table& file) {
  const Table::Entry* explore = file.find("explore");
  const auto* table = explore ? std::get_if<Table>(&explore->content) : nullptr;
  const Table::Entry* body = table ? table->find("body") : nullptr;
  const auto* value = body ? std::get_if<Value>(&body->content) : nullptr;
  const auto* name = value ? std::get_if<std::string>(&value->content) : nullptr;
  return name ? "  explores with " + *name : std::string();
}

void print_files(const std::string& title, const std::vector<NamedFile>& files) {
  std::size_t width = 0;
  for (const NamedFile& file : files) width = std::max(width, file.name.size());
  fmt::print("{}\n", title);
  for (const NamedFile& file : files) {
    fmt::print("  {:<{}}{}\n", file.name, width, body_of(file.content));
  }
}

Result<void> list_systems(const Arguments& /*arguments*/) {
  const auto own = own_systems();
  if (!own) return fail(own.error());
  print_files("The papers' systems, for somato run and somato reproduce:", own->systems);
  print_files("\nThe same for data sets of others, with --data:", own->recorded);
  print_files("\nQuestions about them, for somato reproduce:", own->questions);
  fmt::print("\n'somato modules' lists what systems are made of.\n");
  return {};
}

}  // namespace

Command systems_command() {
  return {"systems", "List the systems that come with the program", {}, {}, {}, list_systems};
}

}  // namespace somato::program
