#include "views/exports/csv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/text/text.h"
#include "somato/core/value.h"
#include "somato/files/csv.h"

namespace somato {
namespace {

constexpr std::size_t kPartBytes = std::size_t{1} << 16;

// Whether an import takes the column's name for none, a range or a pattern.
bool is_special(const std::string& name) {
  return trimmed(name).empty() || name.find("..") != std::string::npos ||
         name.find('*') != std::string::npos;
}

// The names of the elements, or numbered names of the channel: of elements without names, and
// where a name does not identify a column.
std::vector<std::string> columns_of(const ChannelDescription& channel, std::size_t elements,
                                    const std::set<std::string>& taken) {
  std::set<std::string> names = taken;
  const bool are_usable = !channel.element_names.empty() &&
                          std::all_of(channel.element_names.begin(), channel.element_names.end(),
                                      [&](const std::string& name) {
                                        return !is_special(name) && names.insert(name).second;
                                      });
  if (are_usable) return channel.element_names;
  names = taken;
  const std::string stem = is_special(channel.name) ? "value" : channel.name;
  std::vector<std::string> columns;
  columns.reserve(elements);
  for (std::size_t i = 1; i <= elements; ++i) {
    columns.push_back(free_name(fmt::format("{}_{}", stem, i), names));
  }
  return columns;
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  quoted.reserve(texts.size());
  for (const std::string& text : texts) quoted.push_back(to_toml(Value(text)));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string quoted(const std::string& text) {
  return to_toml(Value(text));
}

// The time of a frame in seconds, or nothing.
std::string time_text(const ChannelDescription& channel, std::uint64_t frame, double time) {
  if (channel.rate > 0.0) return fmt::format("{}", static_cast<double>(frame) / channel.rate);
  return channel.times_known ? fmt::format("{}", time) : std::string();
}

}  // namespace

Result<std::unique_ptr<RecordingExport>> CsvExport::begin(const std::string& path) {
  SOMATO_TRY(NewFolder folder, NewFolder::begin(path));
  return std::make_unique<CsvExport>(std::move(folder));
}

Result<void> CsvExport::open_tables(const ExplorationStart& first) {
  std::set<std::string> files;
  for (const Label& label : first.labels) labels_.push_back(label.name);
  tables_.reserve(first.channels.size());
  for (const ChannelDescription& channel : first.channels) {
    std::set<std::string> taken(labels_.begin(), labels_.end());
    const std::string exploration = free_name("exploration", taken);
    const std::string time = free_name("time", taken);
    const std::string name = free_name(plain_name(channel.name, "_-."), files);
    SOMATO_TRY(FileWriter file, FileWriter::begin(folder_.file(name + ".csv")));
    tables_.push_back({name, std::move(file), channel, exploration, time});
  }
  return {};
}

Result<void> CsvExport::begin_exploration(const ExplorationStart& start) {
  if (explorations_ == 0) SOMATO_TRY_VOID(open_tables(start));
  ++explorations_;
  channels_ = start.channels;
  beginning_ = fmt::format("{}", explorations_);
  for (const Label& label : start.labels) beginning_ += "," + csv_field(label.value);
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    ChannelTable& table = tables_[i];
    const ChannelDescription& channel = channels_[i];
    table.frames = 0;
    table.is_rate_constant = table.is_rate_constant && channel.rate == table.description.rate;
    table.is_time_known = table.is_time_known && (channel.times_known || channel.rate > 0.0);
  }
  return {};
}

// The number of elements is known once there is a frame.
void CsvExport::begin_table(ChannelTable& table, std::size_t elements,
                            const std::vector<std::string>& labels) {
  std::set<std::string> taken(labels.begin(), labels.end());
  taken.insert({table.exploration, table.time});
  table.elements = columns_of(table.description, elements, taken);
  table.rows = csv_field(table.exploration);
  for (const std::string& label : labels) table.rows += "," + csv_field(label);
  table.rows += "," + csv_field(table.time);
  for (const std::string& element : table.elements) table.rows += "," + csv_field(element);
  table.rows += '\n';
}

Result<void> CsvExport::frame(std::size_t channel, std::span<const float> values, double time,
                              std::span<const std::uint8_t> valid) {
  ChannelTable& table = tables_[channel];
  if (table.elements.empty()) begin_table(table, values.size(), labels_);
  table.rows += beginning_ + "," + time_text(channels_[channel], table.frames++, time);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_valid = valid.empty() || valid[i] != 0;
    table.has_missing = table.has_missing || !is_valid;
    table.rows += ',';
    if (is_valid) fmt::format_to(std::back_inserter(table.rows), "{}", values[i]);
  }
  table.rows += '\n';
  if (table.rows.size() < kPartBytes) return {};
  SOMATO_TRY_VOID(table.file.write(table.rows));
  table.rows.clear();
  return {};
}

Result<void> CsvExport::end_exploration() {
  return {};
}

std::string CsvExport::description_of_table(const ChannelTable& table) const {
  std::string text = fmt::format(
      "# somato import csv {0}.csv -o {0}.mcap --description {0}.toml\n\n[import]\n"
      "exploration = {1}\nlabels = {2}\n",
      table.name, quoted(table.exploration), quoted_list(labels_));
  const double rate = table.is_rate_constant ? table.description.rate : 0.0;
  if (table.is_time_known && rate == 0.0) {
    text += fmt::format("time = {}\n", quoted(table.time));
  } else {
    if (rate > 0.0) text += fmt::format("rate = {}\n", to_toml(Value(rate)));
    text += fmt::format("ignore = {}\n", quoted_list({table.time}));
  }
  if (table.has_missing) text += "missing = \"mask\"\n";
  const ChannelDescription& channel = table.description;
  text += fmt::format("\n[[channel]]\nname = {}\ncolumns = {}\n", quoted(channel.name),
                      quoted_list(table.elements));
  if (!channel.unit.empty()) text += fmt::format("unit = {}\n", quoted(channel.unit));
  if (!channel.shape.empty()) text += fmt::format("shape = [{}]\n", fmt::join(channel.shape, ", "));
  return text;
}

Result<void> CsvExport::finish() {
  for (ChannelTable& table : tables_) {
    SOMATO_TRY_VOID(table.file.write(table.rows));
    SOMATO_TRY_VOID(table.file.commit());
    SOMATO_TRY(FileWriter description, FileWriter::begin(folder_.file(table.name + ".toml")));
    SOMATO_TRY_VOID(description.write(description_of_table(table)));
    SOMATO_TRY_VOID(description.commit());
  }
  return folder_.commit();
}

}  // namespace somato
