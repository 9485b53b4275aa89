#include "recordings/mcap/exploration_notes.h"

#include <optional>
#include <string_view>
#include <system_error>

#include "base/text/number_of_text.h"
#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::string_view kLabelNote = "somato.label";
constexpr std::string_view kLeftOutNote = "somato.left_out";

std::optional<std::string> note_text(const McapMetadata& metadata, const std::string& field) {
  const auto found = metadata.texts.find(field);
  if (found == metadata.texts.end() || !is_utf8(found->second)) return {};
  return found->second;
}

std::optional<std::uint64_t> note_index(const McapMetadata& metadata) {
  return number_of_text<std::uint64_t>(note_text(metadata, "exploration").value_or(""));
}

}  // namespace

McapMetadata ExplorationNotes::label(std::uint64_t index, const Label& label) {
  return {std::string(kLabelNote),
          {{"exploration", std::to_string(index)}, {"name", label.name}, {"value", label.value}}};
}

McapMetadata ExplorationNotes::left_out(std::uint64_t index) {
  return {std::string(kLeftOutNote), {{"exploration", std::to_string(index)}}};
}

bool ExplorationNotes::add(const McapMetadata& metadata) {
  const auto index = note_index(metadata);
  if (!index) return false;
  if (metadata.name == kLeftOutNote) return left_out_.insert(*index).second;
  const auto name = note_text(metadata, "name");
  const auto value = note_text(metadata, "value");
  if (metadata.name != kLabelNote || !name || !value) return false;
  names_.give(static_cast<std::size_t>(*index), {*name, *value});
  return true;
}

}  // namespace somato
