#include "somato/simulation/exploring_parameters.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

// A table of the file, and how it is read.
struct Section {
  std::string name;
  std::function<Result<void>(const Table&)> read;
};

template <typename Parameters>
Section section(std::string name, Parameters& parameters) {
  return {std::move(name), [&parameters](const Table& table) -> Result<void> {
            auto read = read_parameters<Parameters>(table, parameters);
            if (!read) return fail(std::move(read.error()));
            parameters = std::move(*read);
            return {};
          }};
}

std::vector<Section> sections_of(ExploringParameters& parameters) {
  return {section("simulation", parameters.simulation),
          section("plan", parameters.plan),
          section("grasp", parameters.grasp),
          section("closing", parameters.closing),
          section("texture_probe", parameters.texture_probe),
          section("stroke", parameters.stroke),
          section("hardness_probe", parameters.hardness_probe),
          section("press", parameters.press)};
}

Result<void> read_section(const Table::Entry& entry, const std::vector<Section>& sections) {
  std::vector<std::string> known;
  known.reserve(sections.size());
  for (const Section& section : sections) {
    known.push_back(section.name);
    if (section.name != entry.name) continue;
    if (const auto* table = std::get_if<Table>(&entry.content)) return section.read(*table);
    return fail(ErrorKind::kUsage, "'" + entry.name + "' is no table", entry.where,
                "write [" + entry.name + "] and its keys below");
  }
  return fail(unknown_name("table", entry.name, entry.where, known));
}

}  // namespace

Result<ExploringParameters> read_exploring_parameters(const Table& file,
                                                      ExploringParameters parameters) {
  const std::vector<Section> sections = sections_of(parameters);
  for (const Table::Entry& entry : file.entries) {
    if (auto read = read_section(entry, sections); !read) return fail(std::move(read.error()));
  }
  return parameters;
}

}  // namespace somato
