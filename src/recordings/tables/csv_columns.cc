#include "recordings/tables/csv_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/tables/csv_header.h"
#include "base/tables/csv_number.h"
#include "base/text/text.h"
#include "recordings/tables/column_names.h"
#include "recordings/tables/csv_import_check.h"
#include "somato/core/value.h"

namespace somato {
namespace {

// Whether the fields of a first line may be names.
bool is_header(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(),
                     [](const std::string& field) { return is_csv_text(field); });
}

std::string without_stars(std::string pattern) {
  std::erase(pattern, '*');
  return pattern;
}

class ColumnFinder {
 public:
  ColumnFinder(const CsvImport& description, const CsvLayout& layout,
               const std::vector<std::string>& names)
      : description_(description), layout_(layout), names_(names) {
    found_.columns.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) places_.emplace(names[i], i);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_nameless(names[i], i)) places_.emplace(number_of(i), i);
    }
  }

  Result<CsvColumns> find() && {
    Result<void> done = find_ignored().and_then([&] { return find_ranges(); }).and_then([&] {
      return find_trials();
    });
    for (std::size_t c = 0; done && c < layout_.channels.size(); ++c) done = find_channel(c);
    if (!done) return fail(std::move(done.error()));
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const bool used = found_.columns[i].use != CsvUse::kNothing;
      if (used || is_ignored_[i]) continue;
      found_.others.push_back(names_[i]);
      if (is_nameless(names_[i], i)) found_.nameless.push_back(i);
    }
    return std::move(found_);
  }

 private:
  Result<void> find_ignored() {
    is_ignored_.resize(names_.size());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (layout_.ignored.contains(names_[i])) ignore(i, names_[i]);
      if (is_at(number_of(i), i) && layout_.ignored.contains(number_of(i))) ignore(i, number_of(i));
    }
    is_refused_ = is_ignored_;
    for (const std::string& pattern : layout_.ignored_patterns) {
      if (!is_column_range(pattern)) {
        ignore_fitting(pattern);
      } else if (places_.contains(pattern)) {
        ignore(places_.at(pattern), pattern);
      } else {
        SOMATO_TRY(const std::vector<std::size_t> places, places_in(pattern));
        for (const std::size_t place : places) {
          ignore(place, pattern);
          is_refused_[place] = true;
        }
      }
    }
    return {};
  }

  void ignore_fitting(const std::string& pattern) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (fits_column_pattern(pattern, names_[i])) ignore(i, pattern);
    }
  }

  Result<std::vector<std::size_t>> places_in(const std::string& range) const {
    return columns_in_range(range, names_, [&](const std::string& name) -> Result<std::size_t> {
      const auto place = places_.find(name);
      if (place == places_.end()) return fail(std::move(missing(name).error()));
      return place->second;
    });
  }

  // The columns of ranges are named, so that patterns do not match them. A column may have a name
  // like a range.
  Result<void> find_ranges() {
    is_in_range_.resize(names_.size());
    for (const auto& channel : layout_.channels) {
      for (const std::string& entry : channel) {
        if (!is_column_range(entry) || places_.contains(entry)) continue;
        SOMATO_TRY(std::vector<std::size_t> places, places_in(entry));
        for (const std::size_t place : places) is_in_range_[place] = true;
        ranges_[entry] = std::move(places);
      }
    }
    return {};
  }

  void ignore(std::size_t column, const std::string& entry) {
    found_.ignored.insert(entry);
    is_ignored_[column] = true;
  }

  Result<void> find_trials() {
    const CsvTrials& trials = description_.trials;
    Result<void> found;
    for (std::size_t i = 0; found && i < trials.time.size(); ++i) {
      found = take_named(trials.time[i], {CsvUse::kTime, 0, i});
    }
    const auto& labels = trials.labels;
    const bool is_label =
        std::find(labels.begin(), labels.end(), trials.exploration) != labels.end();
    if (found && !trials.exploration.empty() && !is_label) {
      found = take_named(trials.exploration, {CsvUse::kExploration});
    }
    for (std::size_t i = 0; found && i < labels.size(); ++i) {
      found = take_named(labels[i], {CsvUse::kLabel, 0, i});
    }
    return found;
  }

  Result<void> find_channel(std::size_t channel) {
    std::vector<std::string>& columns = found_.channels.emplace_back();
    bool patterns = false;
    for (const std::string& entry : layout_.channels[channel]) {
      const CsvColumn next{CsvUse::kValue, channel, columns.size()};
      const auto range = ranges_.find(entry);
      if (range != ranges_.end()) {
        SOMATO_TRY_VOID(take_range(range->second, next, columns));
      } else if (is_column_pattern(entry) && !is_column_range(entry)) {
        SOMATO_TRY_VOID(take_fitting(entry, next, columns));
      } else {
        SOMATO_TRY_VOID(take_named(entry, next));
        columns.push_back(names_[places_.at(entry)]);
        continue;
      }
      patterns = true;
    }
    if (!patterns) return {};
    return check_csv_shape(description_.channels[channel], columns.size());
  }

  Result<void> take_named(const std::string& name, CsvColumn column) {
    const auto place = places_.find(name);
    if (place == places_.end()) return missing(name);
    return take_place(place->second, column);
  }

  Result<void> take_place(std::size_t place, CsvColumn column) {
    if (is_refused_[place]) {
      return fail(ErrorKind::kData,
                  fmt::format("column {} is both used and ignored", shown(names_[place])), {},
                  "remove one of them");
    }
    if (found_.columns[place].use != CsvUse::kNothing) {
      return fail(
          ErrorKind::kData,
          fmt::format("column {} is mentioned twice, by name, number or range",
                      is_nameless(names_[place], place) ? number_of(place) : shown(names_[place])),
          {}, "mention it once");
    }
    found_.columns[place] = column;
    return {};
  }

  Result<void> take_range(const std::vector<std::size_t>& places, CsvColumn next,
                          std::vector<std::string>& columns) {
    for (const std::size_t place : places) {
      next.element = columns.size();
      SOMATO_TRY_VOID(take_place(place, next));
      columns.push_back(names_[place]);
    }
    return {};
  }

  Result<void> take_fitting(const std::string& pattern, CsvColumn next,
                            std::vector<std::string>& columns) {
    const std::size_t before = columns.size();
    bool fits = false;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!fits_column_pattern(pattern, names_[i]) || is_nameless(names_[i], i)) continue;
      fits = true;
      if (is_ignored_[i] || is_in_range_[i] || layout_.named.contains(names_[i])) continue;
      CsvColumn& column = found_.columns[i];
      if (column.use == CsvUse::kValue && column.channel == next.channel) continue;
      if (column.use == CsvUse::kValue) return taken_twice(names_[i], column.channel, next.channel);
      next.element = columns.size();
      column = next;
      columns.push_back(names_[i]);
    }
    if (columns.size() > before) return {};
    if (!fits) return none_fits(pattern);
    return fail(
        ErrorKind::kData,
        fmt::format("all columns that match {} are ignored or already used", shown(pattern)), {},
        "leave the pattern out, or correct it");
  }

  static std::string number_of(std::size_t column) { return std::to_string(column + 1); }

  bool is_at(const std::string& entry, std::size_t column) const {
    const auto place = places_.find(entry);
    return place != places_.end() && place->second == column;
  }

  Result<void> missing(const std::string& name) const {
    const bool lacks_header = description_.trials.header && !is_header(names_);
    return fail(ErrorKind::kData, fmt::format("there is no column {}", shown(name)), {},
                lacks_header ? "write header = false if the first line contains no names"
                             : name_advice(name, names_));
  }

  Result<void> none_fits(const std::string& pattern) const {
    auto refused = missing(without_stars(pattern));
    refused.error().what = fmt::format("no column matches {}", shown(pattern));
    return refused;
  }

  Result<void> taken_twice(const std::string& name, std::size_t channel, std::size_t other) const {
    return fail(ErrorKind::kData,
                fmt::format("patterns of the channels '{}' and '{}' both match column {}",
                            description_.channels[channel].name, description_.channels[other].name,
                            shown(name)),
                {}, "name the column in one of them, or narrow a pattern");
  }

  const CsvImport& description_;
  const CsvLayout& layout_;
  const std::vector<std::string>& names_;
  std::map<std::string, std::size_t> places_;
  std::vector<bool> is_ignored_;
  std::vector<bool> is_refused_;  // those of them that are ignored by name, number or range
  std::map<std::string, std::vector<std::size_t>> ranges_;  // of channels
  std::vector<bool> is_in_range_;                           // one of these
  CsvColumns found_;
};

// The first of `names` that is not among `others`, or nothing.
std::string first_missing(const std::vector<std::string>& names,
                          const std::vector<std::string>& others) {
  const std::set<std::string> there(others.begin(), others.end());
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const std::string& name) { return !there.contains(name); });
  return found == names.end() ? std::string() : *found;
}

void order_like(const std::vector<std::string>& first, std::size_t channel, CsvColumns& columns) {
  std::map<std::string, std::size_t> elements;
  for (std::size_t i = 0; i < first.size(); ++i) elements.emplace(first[i], i);
  for (CsvColumn& column : columns.columns) {
    if (column.use != CsvUse::kValue || column.channel != channel) continue;
    column.element = elements.at(columns.channels[channel][column.element]);
  }
  columns.channels[channel] = first;
}

}  // namespace

Result<CsvLayout> csv_layout_of(const CsvImport& description) {
  CsvLayout layout;
  layout.channels.reserve(description.channels.size());
  for (const CsvChannel& channel : description.channels) {
    SOMATO_TRY(auto columns, expand_columns(channel.columns));
    layout.named.insert(columns.begin(), columns.end());
    layout.channels.push_back(std::move(columns));
  }
  SOMATO_TRY(auto ignored, expand_columns(description.trials.ignore));
  for (std::string& column : ignored) {
    auto& patterns = layout.ignored_patterns;
    if (is_column_pattern(column)) patterns.push_back(column);
    layout.ignored.insert(std::move(column));
  }
  layout.named.insert(description.trials.time.begin(), description.trials.time.end());
  layout.named.insert(description.trials.exploration);
  layout.named.insert(description.trials.labels.begin(), description.trials.labels.end());
  return layout;
}

Result<CsvColumns> find_csv_columns(const CsvImport& description, const CsvLayout& layout,
                                    const std::vector<std::string>& names) {
  return ColumnFinder(description, layout, names).find();
}

Result<void> CsvFilesInCommon::take(CsvColumns& columns, const std::vector<std::string>& names,
                                    const std::string& where) {
  ignored_.insert(columns.ignored.begin(), columns.ignored.end());
  if (first_file_.empty()) {
    first_file_ = where;
    first_names_ = names;
    channels_ = columns.channels;
  }
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    if (columns.channels[c] == channels_[c]) continue;
    const std::string added = first_missing(columns.channels[c], channels_[c]);
    const std::string lost = first_missing(channels_[c], columns.channels[c]);
    if (added.empty() && lost.empty()) {
      order_like(channels_[c], c, columns);
      continue;
    }
    return fail(ErrorKind::kData,
                fmt::format("a pattern matches column {} {}, but not {}",
                            shown(added.empty() ? lost : added),
                            added.empty() ? "in " + first_file_ : "here",
                            added.empty() ? "here" : "in " + first_file_),
                where, "name the column, ignore it, or import the files separately");
  }
  return {};
}

Result<void> CsvFilesInCommon::check_ignored(const CsvLayout& layout,
                                             const std::string& where) const {
  for (const std::string& entry : layout.ignored) {
    if (ignored_.contains(entry)) continue;
    return fail(ErrorKind::kData, fmt::format("'ignore': no column matches {}", shown(entry)),
                where, name_advice(without_stars(entry), first_names_));
  }
  return {};
}

}  // namespace somato
