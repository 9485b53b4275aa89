#include "hardware/device_files/device_text.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "base/text/text.h"
#include "somato/core/value.h"

namespace somato::devices {
namespace {

std::vector<std::string> lines_in(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return lines;
}

// The name of the table whose header a line is.
std::optional<std::string> header(std::string_view line) {
  line = trimmed(line);
  const std::size_t end = line.find(']');
  if (!line.starts_with('[') || end == std::string_view::npos) return std::nullopt;
  return std::string(trimmed(line.substr(1, end - 1)));
}

bool has_key(std::string_view line, std::string_view key) {
  line = trimmed(line);
  return line.starts_with(key) && trimmed(line.substr(key.size())).starts_with('=');
}

// The comment at the end of a line with a value that contains no '#'.
std::string comment_of(std::string_view line) {
  const std::size_t hash = line.find('#');
  return hash == std::string_view::npos ? "" : fmt::format("  {}", line.substr(hash));
}

// The lines of a table: from the one after its header to the next header.
struct Section {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::optional<Section> section_of(const std::vector<std::string>& lines, std::string_view table) {
  std::optional<Section> found;
  if (table.empty()) found = Section{0, lines.size()};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto name = header(lines[i]);
    if (!name) continue;
    if (found) return Section{found->begin, i};
    if (*name == table) found = Section{i + 1, lines.size()};
  }
  return found;
}

// The place for a new key: before the comments and empty lines that introduce what follows.
std::size_t place_in(const std::vector<std::string>& lines, const Section& section) {
  std::size_t place = section.end;
  while (place > section.begin) {
    const std::string_view line = trimmed(lines[place - 1]);
    if (!line.empty() && !line.starts_with('#')) break;
    --place;
  }
  return place;
}

}  // namespace

std::string with_key(std::string_view text, std::string_view table, std::string_view key,
                     std::string_view value) {
  std::vector<std::string> lines = lines_in(text);
  auto section = section_of(lines, table);
  if (!section) {
    lines.insert(lines.end(), {"", fmt::format("[{}]", table)});
    section = Section{lines.size(), lines.size()};
  }
  bool is_there = false;
  for (std::size_t i = section->begin; i < section->end && !is_there; ++i) {
    is_there = has_key(lines[i], key);
    if (is_there) lines[i] = fmt::format("{} = {}{}", key, value, comment_of(lines[i]));
  }
  if (!is_there) {
    const auto place = static_cast<std::ptrdiff_t>(place_in(lines, *section));
    lines.insert(lines.begin() + place, fmt::format("{} = {}", key, value));
  }
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

namespace {

// The calibration of a servo that has the middle of its limits in the middle of the bus.
struct BusCalibration {
  double zero = 0.0;
  double scale = 0.0;
};

BusCalibration calibration_of(const ServoSettings& servo, const BusTraits& bus) {
  const double scale =
      servo.unit == "deg" ? bus.per_degree : 2.0 * bus.swing / (servo.most - servo.least);
  return {bus.middle - scale * 0.5 * (servo.least + servo.most), scale};
}

}  // namespace

Result<std::string> with_bus(std::string_view text, std::string_view where, BusKind bus) {
  SOMATO_TRY(const auto file, parse_device_file(text, where));
  if (!file.servo_line || file.servo_line->bus == bus) return std::string(text);
  std::string changed = with_key(text, "servos", "bus", fmt::format("\"{}\"", choice_name(bus)));
  const BusTraits& traits = traits_of(bus);
  changed = with_key(changed, "servos", "baud", fmt::format("{}", traits.baud));
  for (std::size_t i = 0; i < file.servos.size(); ++i) {
    const BusCalibration calibration = calibration_of(file.servos[i], traits);
    const std::string table = "servo." + file.servos[i].name;
    changed = with_key(changed, table, "channel", fmt::format("{}", traits.first_channel + i));
    changed = with_key(changed, table, "zero", fmt::format("{:.6g}", calibration.zero));
    changed = with_key(changed, table, "scale", fmt::format("{:.6g}", calibration.scale));
  }
  return changed;
}

}  // namespace somato::devices
