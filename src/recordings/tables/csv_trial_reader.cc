#include "recordings/tables/csv_trial_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "base/tables/column_precision.h"
#include "base/tables/csv_dialect.h"
#include "base/tables/csv_header.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_records.h"
#include "base/tables/csv_text.h"
#include "base/text/flag_hint.h"
#include "base/text/text.h"
#include "recordings/tables/csv_import_check.h"
#include "recordings/tables/csv_times.h"

namespace somato {
namespace {

constexpr std::size_t kLongestFloat = 32;  // Characters; to_chars() requires 15.

double scaled(const CsvChannel& channel, double number) {
  const double value = channel.factor * number;
  return channel.absolute ? std::fabs(value) : value;
}

// The value before it was rounded. A number that is the shortest text of the rounded value loses
// nothing: it was written from a number of that precision.
double exact_value(const CsvChannel& channel, double number, float rounded) {
  const double exact = scaled(channel, number);
  if (exact == double{rounded}) return exact;
  char text[kLongestFloat];
  const char* end = std::to_chars(text, text + kLongestFloat, rounded).ptr;
  double shortest = 0.0;
  std::from_chars(text, end, shortest);
  return exact == shortest ? double{rounded} : exact;
}

// Whether a field is not a label. 'none' is a label: the object of an empty hand.
bool is_missing_label(const std::string& text) {
  return text != "none" && read_csv_number<double>(text).meaning == CsvMeaning::kMissing;
}

// Reads one file; every error has its location.
class TrialReader {
 public:
  TrialReader(const CsvImport& description, const CsvLayout& layout, CsvFilesInCommon& common,
              std::string_view text, const std::string& where)
      : description_(description),
        layout_(layout),
        common_(common),
        records_(text, where),
        where_(where),
        labels_(description.trials.labels.size()),
        times_(description.trials, records_),
        read_(description.channels.size()) {}

  Result<CsvTrial> read() {
    SOMATO_TRY(separator_, begin_csv(records_, description_.trials.decimal, {}, fields_));
    auto done = read_header().and_then([&] { return read_rows(); });
    if (!done) return fail(std::move(done.error()));
    return CsvTrial{channels(), std::move(parts_), times_.clock()};
  }

 private:
  struct Values {
    std::vector<float> values;
    std::vector<std::uint8_t> valid;
    bool all_valid = true;
    ColumnPrecision precision = {};
  };

  Result<void> next() { return records_.next(separator_, fields_); }

  Result<void> read_header() {
    if (fields_.empty()) return no_rows();
    Result<void> used = use_columns(names_of_columns());
    if (!used || !description_.trials.header) return used;
    return next();
  }

  std::vector<std::string> names_of_columns() const {
    if (description_.trials.header) return names_in_header(fields_);
    std::vector<std::string> names;
    names.reserve(fields_.size());
    for (std::size_t i = 1; i <= fields_.size(); ++i) names.push_back(std::to_string(i));
    return names;
  }

  Result<void> use_columns(const std::vector<std::string>& names) {
    auto found = find_csv_columns(description_, layout_, names);
    if (!found) {
      found.error().where = line_place();
      return fail(std::move(found.error()));
    }
    columns_ = std::move(*found);
    return refuse_duplicates(names).and_then([&] { return refuse_others(names); }).and_then([&] {
      return common_.take(columns_, names, where_);
    });
  }

  Result<void> refuse_duplicates(const std::vector<std::string>& names) const {
    std::map<std::string, bool> used_names;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool used = columns_.columns[i].use != CsvUse::kNothing;
      const auto [name, is_new] = used_names.emplace(names[i], used);
      if (is_new || (!used && !name->second)) continue;
      return fail(ErrorKind::kData, fmt::format("there are two columns {}", shown(names[i])),
                  records_.place(fields_[i]), "rename one of them");
    }
    return {};
  }

  Result<void> refuse_others(const std::vector<std::string>& names) const {
    const bool ignore = description_.trials.other_columns == Unmentioned::kIgnore;
    if (ignore || columns_.others.empty()) return {};
    if (columns_.nameless.size() == columns_.others.size()) return refuse_nameless(names);
    std::vector<std::string> others;
    others.reserve(columns_.others.size());
    for (const std::string& name : columns_.others) others.push_back(shown(name));
    return fail(ErrorKind::kData,
                fmt::format("columns that are not mentioned: {}", fmt::join(others, ", ")),
                line_place(), "assign them to a channel, or list them under 'ignore'");
  }

  Result<void> refuse_nameless(const std::vector<std::string>& names) const {
    const std::string columns = columns_by_number(names, columns_.nameless);
    return fail(nameless_columns(
        columns_.nameless, names.size(), line_place(),
        fmt::format("list {} under 'ignore'{}", columns, flag_hint("ignore", columns))));
  }

  Result<void> read_rows() {
    if (fields_.empty()) return no_rows();
    while (!fields_.empty()) {
      Result<void> read = read_row().and_then([&] { return next(); });
      if (!read) return read;
    }
    for (std::size_t c = 0; c < read_.size(); ++c) {
      auto kept = read_[c].precision.check(columns_.channels[c], where_);
      if (!kept) return kept;
    }
    return times_.check();
  }

  Result<void> read_row() {
    if (fields_.size() != columns_.columns.size()) {
      return fail(wrong_number_of_fields(fields_, columns_.columns.size(),
                                         rows_ == 0 && description_.trials.header, line_place(),
                                         "repair or remove the file"));
    }
    for (std::size_t c = 0; c < read_.size(); ++c) {
      read_[c].values.resize(read_[c].values.size() + columns_.channels[c].size());
      read_[c].valid.resize(read_[c].values.size(), 1);
    }
    Result<void> read;
    for (std::size_t i = 0; read && i < fields_.size(); ++i) {
      read = read_field(fields_[i], columns_.columns[i]);
    }
    return read.and_then([&] { return add_to_part(); }).and_then([&] {
      return times_.end_row(begins_exploration_);
    });
  }

  Result<void> read_field(const CsvField& field, const CsvColumn& column) {
    switch (column.use) {
      case CsvUse::kNothing:
        return {};
      case CsvUse::kTime:
        times_.take(field, column.element);
        return {};
      case CsvUse::kExploration:
        return read_label(field, description_.trials.exploration, exploration_);
      case CsvUse::kLabel:
        return read_label_of_row(field, column.element);
      case CsvUse::kValue:
        return read_value(field, column);
    }
    return {};
  }

  // Explorations may be divided where a label changes.
  Result<void> read_label_of_row(const CsvField& field, std::size_t label) {
    const CsvTrials& trials = description_.trials;
    SOMATO_TRY_VOID(read_label(field, trials.labels[label], labels_[label]));
    if (trials.labels[label] == trials.exploration) exploration_ = labels_[label];
    return {};
  }

  Result<void> read_label(const CsvField& field, const std::string& name,
                          std::string& value) const {
    if (is_missing_label(field.text)) {
      return fail(ErrorKind::kData,
                  fmt::format("the label '{}' is missing: {}", name, shown(field.text)),
                  records_.place(field), "fill it in, remove the row, or leave the label out");
    }
    if (!is_name(field.text)) {
      return fail(
          ErrorKind::kData,
          fmt::format("the label '{}' is not 1 to 255 bytes of text without control characters: {}",
                      name, shown(field.text)),
          records_.place(field), "correct it");
    }
    value = unguarded_text(field.text);
    return {};
  }

  // Adds the row to the rows before it that have the same labels and exploration.
  Result<void> add_to_part() {
    begins_exploration_ = parts_.empty() || exploration_ != last_exploration_;
    const bool changes = begins_exploration_ || parts_.back().values != labels_;
    if (changes && !begins_exploration_ && !divides_files(description_.trials)) {
      return labels_change();
    }
    if (changes) parts_.push_back({rows_, 0, labels_});
    last_exploration_ = exploration_;
    ++parts_.back().rows;
    ++rows_;
    return {};
  }

  tl::unexpected<Error> labels_change() const {
    const CsvTrials& trials = description_.trials;
    const auto [changed, before] =
        std::mismatch(labels_.begin(), labels_.end(), parts_.back().values.begin());
    const std::string& name = trials.labels[static_cast<std::size_t>(changed - labels_.begin())];
    if (!trials.exploration.empty()) {
      return fail(ErrorKind::kData,
                  fmt::format("the label '{}' changes within an exploration, in which '{}' is {}",
                              name, trials.exploration, shown(exploration_)),
                  line_place(),
                  "divide the file at a column that numbers the explorations, or leave the label "
                  "out");
    }
    return fail(ErrorKind::kData, fmt::format("the label '{}' changes within the file", name),
                line_place(),
                fmt::format("divide it where the label changes: exploration = \"{}\"; or into "
                            "windows: window = 500; or into rows: rows = \"explorations\"",
                            name));
  }

  Result<void> read_value(const CsvField& field, const CsvColumn& slot) {
    Values& read = read_[slot.channel];
    const std::size_t at =
        read.values.size() - columns_.channels[slot.channel].size() + slot.element;
    const auto [meaning, number] = read_csv_number<double>(field.text, description_.trials.decimal);
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
    read.precision.take(slot.element, exact_value(channel, number, *value), *value);
    return {};
  }

  Result<void> refuse(const CsvField& field, CsvMeaning meaning) const {
    auto refused = no_csv_number(field, meaning, description_.trials.decimal, records_.place(field),
                                 "correct it, or list its column under 'ignore'");
    if (meaning == CsvMeaning::kMissing) {
      refused.value().advice = "fill in a number, or import with missing = \"mask\"";
    }
    return refused;
  }

  Result<void> no_rows() const {
    return fail(ErrorKind::kData, "there are no rows of numbers", where_, "remove the file");
  }

  // The place of the last record.
  std::string line_place() const { return records_.line_place(fields_[0]); }

  std::vector<Channel> channels() {
    std::vector<Channel> channels;
    channels.reserve(read_.size());
    for (std::size_t c = 0; c < read_.size(); ++c) {
      const CsvChannel& described = description_.channels[c];
      const std::vector<std::string>& columns = columns_.channels[c];
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
    channel.times = times_.seconds();
    channel.rate = description_.trials.rate;
  }

  const CsvImport& description_;
  const CsvLayout& layout_;
  CsvFilesInCommon& common_;
  CsvRecords records_;
  std::string where_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  CsvColumns columns_;
  std::vector<std::string> labels_;  // The labels of the last row.
  CsvTimes times_;
  std::vector<LabelledRows> parts_;
  std::size_t rows_ = 0;
  std::vector<Values> read_;  // The values of each channel.
  std::string exploration_;   // That of the last row, and of the row before it.
  std::string last_exploration_;
  bool begins_exploration_ = false;
};

}  // namespace

std::optional<float> csv_value(const CsvChannel& channel, double number) {
  const double value = scaled(channel, number);
  if (!(std::fabs(value) <= std::numeric_limits<float>::max())) return std::nullopt;
  return static_cast<float>(value);
}

Result<CsvTrial> read_csv_trial(const CsvImport& description, const CsvLayout& layout,
                                CsvFilesInCommon& common, std::string_view text,
                                const std::string& where) {
  return TrialReader(description, layout, common, text, where).read();
}

}  // namespace somato
