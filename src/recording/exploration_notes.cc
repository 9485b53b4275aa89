#include "recording/exploration_notes.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "files/text.h"

namespace somato {
namespace {

constexpr std::string_view kLabel = "somato.label";
constexpr std::string_view kLeftOut = "somato.left_out";

std::optional<std::string> text_of(const McapMetadata& metadata, const std::string& field) {
  const auto found = metadata.texts.find(field);
  if (found == metadata.texts.end() || !is_utf8(found->second)) return {};
  return found->second;
}

std::optional<std::uint64_t> index_of(const McapMetadata& metadata) {
  const std::string text = text_of(metadata, "exploration").value_or("");
  std::uint64_t index = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (status != std::errc() || end != text.data() + text.size()) return {};
  return index;
}

}  // namespace

McapMetadata ExplorationNotes::label(std::uint64_t index, const Label& label) {
  return {std::string(kLabel),
          {{"exploration", std::to_string(index)}, {"name", label.name}, {"value", label.value}}};
}

McapMetadata ExplorationNotes::left_out(std::uint64_t index) {
  return {std::string(kLeftOut), {{"exploration", std::to_string(index)}}};
}

bool ExplorationNotes::add(const McapMetadata& metadata) {
  const auto index = index_of(metadata);
  if (!index) return false;
  if (metadata.name == kLeftOut) return left_out_.insert(*index).second;
  const auto name = text_of(metadata, "name");
  const auto value = text_of(metadata, "value");
  if (metadata.name != kLabel || !name || !value) return false;
  names_.give(static_cast<std::size_t>(*index), {*name, *value});
  return true;
}

}  // namespace somato
