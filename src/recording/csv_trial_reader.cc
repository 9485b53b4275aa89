#include "recording/csv_trial_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "files/column_precision.h"
#include "files/csv_number.h"
#include "files/csv_records.h"
#include "files/text.h"
#include "somato/core/value.h"

namespace somato {
namespace {

double units_per_second(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::kSeconds:
      return 1.0;
    case TimeUnit::kMilliseconds:
      return 1e3;
    case TimeUnit::kMicroseconds:
      return 1e6;
    case TimeUnit::kNanoseconds:
      return 1e9;
  }
  return 1.0;
}

double scaled(const CsvChannel& channel, double number) {
  const double value = channel.factor * number;
  return channel.absolute ? std::fabs(value) : value;
}

// Whether the fields of a first line may be names.
bool is_header(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return read_csv_number<double>(field).meaning == CsvMeaning::kText;
  });
}

// Reads one file; every error knows its place in it.
class TrialReader {
 public:
  TrialReader(const CsvImport& description, const CsvLayout& layout, std::string_view text,
              const std::string& where)
      : description_(description),
        layout_(layout),
        records_(text, where),
        where_(where),
        read_(description.channels.size()) {}

  Result<std::vector<Channel>> read() {
    separator_ = records_.guess_separator();
    auto done =
        next().and_then([&] { return read_header(); }).and_then([&] { return read_rows(); });
    if (!done) return fail(std::move(done.error()));
    return channels();
  }

 private:
  enum class Use { kNothing, kTime, kValue };
  struct Column {
    Use use = Use::kNothing;
    CsvSlot slot = {};
  };
  struct Values {
    std::vector<float> values;
    std::vector<std::uint8_t> valid;
    bool all_valid = true;
    ColumnPrecision precision = {};
  };

  Result<void> next() { return records_.next(separator_, fields_); }

  Result<void> read_header() {
    if (fields_.empty()) return no_rows();
    std::vector<std::string> names;
    names.reserve(fields_.size());
    for (const CsvField& field : fields_) {
      names.push_back(description_.trials.header ? field.text : std::to_string(names.size() + 1));
    }
    Result<void> used =
        use_columns(names).and_then([&] { return refuse_missing(names); }).and_then([&] {
          return refuse_others(names);
        });
    if (!used || !description_.trials.header) return used;
    return next();
  }

  Column use_of(const std::string& name) const {
    if (!description_.trials.time.empty() && name == description_.trials.time) {
      return {Use::kTime, {}};
    }
    const auto slot = layout_.slots.find(name);
    return slot == layout_.slots.end() ? Column{} : Column{Use::kValue, slot->second};
  }

  Result<void> use_columns(const std::vector<std::string>& names) {
    std::set<std::string> seen;
    columns_.reserve(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      columns_.push_back(use_of(names[i]));
      if (columns_[i].use == Use::kNothing || seen.insert(names[i]).second) continue;
      return fail(ErrorKind::kData, fmt::format("there are two columns {}", shown(names[i])),
                  records_.place(fields_[i]), "rename one of them");
    }
    return {};
  }

  Result<void> refuse_others(const std::vector<std::string>& names) const {
    if (description_.trials.other_columns == Unmentioned::kIgnore) return {};
    std::vector<std::string> others;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool mentioned = columns_[i].use != Use::kNothing || layout_.ignored.contains(names[i]);
      if (!mentioned) others.push_back(shown(names[i]));
    }
    if (others.empty()) return {};
    return fail(ErrorKind::kData,
                fmt::format("columns that are not mentioned: {}", fmt::join(others, ", ")),
                line_place(), "give them to a channel, or list them under 'ignore'");
  }

  Result<void> refuse_missing(const std::vector<std::string>& names) const {
    const auto missing = [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) == names.end();
    };
    std::vector<std::string> wanted;
    if (!description_.trials.time.empty()) wanted.push_back(description_.trials.time);
    for (const auto& columns : layout_.columns) {
      wanted.insert(wanted.end(), columns.begin(), columns.end());
    }
    const auto first = std::find_if(wanted.begin(), wanted.end(), missing);
    if (first == wanted.end()) return {};
    const bool lacks_header = description_.trials.header && !is_header(names);
    return fail(ErrorKind::kData, fmt::format("there is no column {}", shown(*first)), line_place(),
                lacks_header ? "where the first line holds no names, write header = false"
                             : name_advice(*first, names));
  }

  Result<void> read_rows() {
    if (fields_.empty()) return no_rows();
    while (!fields_.empty()) {
      Result<void> read = read_row().and_then([&] { return next(); });
      if (!read) return read;
    }
    for (std::size_t c = 0; c < read_.size(); ++c) {
      auto kept = read_[c].precision.check(layout_.columns[c], where_);
      if (!kept) return kept;
    }
    return {};
  }

  Result<void> read_row() {
    if (fields_.size() != columns_.size()) {
      return fail(ErrorKind::kData,
                  fmt::format("expected {} fields, found {}", columns_.size(), fields_.size()),
                  line_place(), "repair the file or take it out");
    }
    for (std::size_t c = 0; c < read_.size(); ++c) {
      read_[c].values.resize(read_[c].values.size() + layout_.columns[c].size());
      read_[c].valid.resize(read_[c].values.size(), 1);
    }
    Result<void> read;
    for (std::size_t i = 0; read && i < columns_.size(); ++i) {
      if (columns_[i].use == Use::kTime) read = read_time(fields_[i]);
      if (columns_[i].use == Use::kValue) read = read_value(fields_[i], columns_[i].slot);
    }
    return read;
  }

  Result<void> read_time(const CsvField& field) {
    const auto [meaning, time] = read_csv_number<double>(field.text);
    if (meaning != CsvMeaning::kNumber) return refuse(field, meaning);
    if (times_.empty()) first_time_ = time;
    const double seconds = (time - first_time_) / units_per_second(description_.trials.time_unit);
    if (times_.empty() || seconds >= times_.back()) {
      times_.push_back(seconds);
      return {};
    }
    return fail(ErrorKind::kData,
                fmt::format("the time runs backwards: {} follows a later one", shown(field.text)),
                records_.place(field), "repair the file or take it out");
  }

  Result<void> read_value(const CsvField& field, const CsvSlot& slot) {
    Values& read = read_[slot.channel];
    const std::size_t at = read.values.size() - layout_.columns[slot.channel].size() + slot.element;
    const auto [meaning, number] = read_csv_number<double>(field.text);
    if (meaning == CsvMeaning::kMissing && description_.trials.missing == MissingValues::kMask) {
      read.valid[at] = 0;
      read.all_valid = false;
      return {};
    }
    if (meaning != CsvMeaning::kNumber) return refuse(field, meaning);
    const CsvChannel& channel = description_.channels[slot.channel];
    const std::optional<float> value = csv_value(channel, number);
    if (!value) return refuse(field, CsvMeaning::kTooLarge);
    read.values[at] = *value;
    read.precision.take(slot.element, scaled(channel, number), *value);
    return {};
  }

  Result<void> refuse(const CsvField& field, CsvMeaning meaning) const {
    auto refused = no_csv_number(field, meaning, records_.place(field),
                                 "correct it, or list its column under 'ignore'");
    if (meaning == CsvMeaning::kMissing) {
      refused.value().advice = "fill in a number, or import with missing = \"mask\"";
    }
    return refused;
  }

  Result<void> no_rows() const {
    return fail(ErrorKind::kData, "there are no rows of numbers", where_, "take the file out");
  }

  // Of the record that was read last.
  std::string line_place() const { return fmt::format("{}:{}", where_, fields_[0].line); }

  std::vector<Channel> channels() {
    std::vector<Channel> channels;
    channels.reserve(read_.size());
    for (std::size_t c = 0; c < read_.size(); ++c) {
      const CsvChannel& described = description_.channels[c];
      const std::vector<std::string>& columns = layout_.columns[c];
      Channel channel{described.name, described.unit, columns, {}, {}};
      channel.shape = described.shape;
      if (!columns.empty()) fill(channel, read_[c]);
      channels.push_back(std::move(channel));
    }
    return channels;
  }

  void fill(Channel& channel, Values& read) const {
    const std::size_t columns = channel.element_names.size();
    const std::size_t rows = read.values.size() / columns;
    channel.frames = Matrix<float>(rows, columns, std::move(read.values));
    if (!read.all_valid) channel.valid = Matrix<std::uint8_t>(rows, columns, std::move(read.valid));
    channel.times = times_;
    channel.rate = description_.trials.rate;
  }

  const CsvImport& description_;
  const CsvLayout& layout_;
  CsvRecords records_;
  std::string where_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  std::vector<Column> columns_;
  std::vector<Values> read_;  // Of each channel.
  std::vector<double> times_;
  double first_time_ = 0.0;
};

}  // namespace

Result<CsvLayout> csv_layout_of(const CsvImport& description) {
  CsvLayout layout;
  layout.columns.reserve(description.channels.size());
  for (const CsvChannel& channel : description.channels) {
    auto columns = expand_columns(channel.columns);
    if (!columns) return fail(std::move(columns.error()));
    for (std::size_t i = 0; i < columns->size(); ++i) {
      layout.slots[(*columns)[i]] = {layout.columns.size(), i};
    }
    layout.columns.push_back(std::move(*columns));
  }
  auto ignored = expand_columns(description.trials.ignore);
  if (!ignored) return fail(std::move(ignored.error()));
  layout.ignored.insert(ignored->begin(), ignored->end());
  return layout;
}

std::optional<float> csv_value(const CsvChannel& channel, double number) {
  const double value = scaled(channel, number);
  if (!(std::fabs(value) <= std::numeric_limits<float>::max())) return std::nullopt;
  return static_cast<float>(value);
}

Result<std::vector<Channel>> read_csv_trial(const CsvImport& description, const CsvLayout& layout,
                                            std::string_view text, const std::string& where) {
  return TrialReader(description, layout, text, where).read();
}

}  // namespace somato
