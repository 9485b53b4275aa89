#include "recordings/tables/csv_import_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/text/flag_hint.h"
#include "recordings/tables/column_names.h"
#include "recordings/tables/name_pattern.h"

namespace somato {
namespace {

tl::unexpected<Error> wrong(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), {}, std::move(advice));
}

Result<void> check_pattern(const CsvTrials& trials) {
  const bool other_labels =
      !trials.labels.empty() || !trials.exploration.empty() || divides_files(trials);
  if (trials.files.empty() && other_labels) return {};
  if (trials.files.empty()) {
    return wrong("'files' is missing", "write for example files = \"{object}_{trial:number}.csv\"");
  }
  const auto pattern = NamePattern::parse(trials.files, !other_labels);
  if (!pattern) return wrong("'files': " + pattern.error().what, pattern.error().advice);
  return {};
}

Result<void> check_rate(const CsvTrials& trials) {
  if (!std::isfinite(trials.rate) || trials.rate < 0.0) {
    return wrong(fmt::format("the rate is {} Hz", trials.rate), "use a rate above 0, or none");
  }
  if (trials.time.empty() || trials.rate == 0.0) return {};
  return wrong("there are both 'time' and 'rate'", "keep the correct one");
}

Result<void> check_time(const CsvTrials& trials) {
  if (trials.time.size() > 2) {
    return wrong(fmt::format("'time' has {} columns", trials.time.size()),
                 "name one column, or those of the date and of the time of day");
  }
  if (trials.time.size() < 2 || trials.time_unit == TimeUnit::kIso) return {};
  return wrong("'time' has two columns, but numbers are in one",
               fmt::format("write time_unit = \"iso\"{} for dates and times of day",
                           flag_hint("time-unit", "iso")));
}

Result<void> check_window(const CsvTrials& trials) {
  if (trials.overlap > 0 && !trials.window) {
    return wrong("there is 'overlap', but no 'window'", "write for example window = 500");
  }
  if (trials.incomplete == IncompleteWindow::kKeep && !trials.window) {
    return wrong("'incomplete' has no effect without 'window'", "write for example window = 500");
  }
  if (!trials.window || trials.overlap < *trials.window) return {};
  return wrong(fmt::format("'overlap' is {}, which is not below 'window', {}", trials.overlap,
                           *trials.window),
               "windows must begin at least one row apart");
}

// An exploration of one row has no windows and no times.
Result<void> check_rows(const CsvTrials& trials) {
  if (trials.rows != CsvRows::kExplorations) return {};
  const std::pair<bool, const char*> without_effect[] = {{trials.window.has_value(), "window"},
                                                         {!trials.time.empty(), "time"},
                                                         {trials.rate > 0.0, "rate"}};
  for (const auto& [given, key] : without_effect) {
    if (!given) continue;
    return wrong(fmt::format("'{}' has no effect with rows = \"explorations\"", key),
                 "leave one of them out");
  }
  return {};
}

Result<void> check_exploration(const CsvTrials& trials) {
  if (trials.exploration.empty() || !divides_files(trials)) return {};
  return wrong(fmt::format("there are both 'exploration' and {}",
                           trials.window ? "'window'" : "rows = \"explorations\""),
               "divide the files in one way");
}

Result<void> check_labels(const CsvTrials& trials) {
  std::set<std::string> seen;
  if (divides_files(trials)) seen = {kFileLabel, trials.window ? kWindowLabel : kRowLabel};
  const std::set<std::string> made = seen;
  for (const std::string& label : csv_label_names(trials)) {
    if (label.empty()) return wrong("'labels': a column has no name", "name it, or leave it out");
    if (seen.insert(label).second) continue;
    if (!made.contains(label)) {
      return wrong(fmt::format("there are two labels '{}'", label), "rename or remove one of them");
    }
    return wrong(fmt::format("the label '{}' is generated from the windows or rows", label),
                 "rename it");
  }
  return {};
}

Result<void> check_trials(const CsvTrials& trials) {
  return check_pattern(trials)
      .and_then([&] { return check_rate(trials); })
      .and_then([&] { return check_time(trials); })
      .and_then([&] { return check_window(trials); })
      .and_then([&] { return check_rows(trials); })
      .and_then([&] { return check_exploration(trials); })
      .and_then([&] { return check_labels(trials); });
}

Result<void> check_source(const CsvChannel& channel) {
  if (channel.name.empty()) return wrong("the channel has no name", "write name = \"touch\"");
  if (channel.columns.empty() == channel.from_label.empty()) {
    return wrong(fmt::format("channel '{}' has {}", channel.name,
                             channel.columns.empty() ? "neither columns nor a label"
                                                     : "both columns and a label"),
                 "write columns = [...] or from_label = \"...\"");
  }
  return {};
}

Result<void> check_label(const CsvChannel& channel, const std::vector<std::string>& labels) {
  const bool known = std::find(labels.begin(), labels.end(), channel.from_label) != labels.end();
  if (known || channel.from_label.empty()) return {};
  return fail(unknown_name("label", channel.from_label, {}, labels));
}

Result<void> check_untaken(const std::vector<std::string>& columns, const CsvTrials& trials,
                           std::set<std::string>& taken) {
  for (const std::string& column : columns) {
    if (column.empty()) return wrong("a column has no name", "name it, or leave it out");
    if (taken.insert(column).second) continue;
    const auto& labels = trials.labels;
    const bool label = std::find(labels.begin(), labels.end(), column) != labels.end();
    return wrong(fmt::format("column '{}' is used twice", column),
                 label ? fmt::format("use the label for the channel: from_label = \"{}\"", column)
                       : "name each column once");
  }
  return {};
}

// Checks a channel against the preceding ones, whose names and columns are in `taken`.
Result<void> check_channel(const CsvChannel& channel, const CsvTrials& trials,
                           std::set<std::string>& names, std::set<std::string>& taken) {
  SOMATO_TRY_VOID(check_source(channel));
  if (!names.insert(channel.name).second) {
    return wrong(fmt::format("there are two channels '{}'", channel.name), "rename one of them");
  }
  SOMATO_TRY(const auto columns, expand_columns(channel.columns));
  SOMATO_TRY_VOID(check_untaken(columns, trials, taken));
  SOMATO_TRY_VOID(check_label(channel, csv_label_names(trials)));
  if (std::any_of(columns.begin(), columns.end(), is_column_pattern)) return {};
  return check_csv_shape(channel, channel.columns.empty() ? 1 : columns.size());
}

Result<void> check_ignored(const CsvTrials& trials, const std::set<std::string>& taken) {
  const auto ignored = expand_columns(trials.ignore);
  if (!ignored) return wrong("'ignore': " + ignored.error().what, ignored.error().advice);
  for (const std::string& column : *ignored) {
    if (!taken.contains(column)) continue;
    return wrong(fmt::format("column '{}' is both used and ignored", column), "remove one of them");
  }
  return {};
}

// The columns of times, explorations and labels.
Result<std::set<std::string>> columns_of_trials(const CsvTrials& trials) {
  std::set<std::string> taken;
  for (const std::string& column : trials.time) {
    if (column.empty()) return wrong("'time': a column has no name", "name it, or leave it out");
    if (taken.insert(column).second) continue;
    return wrong(fmt::format("column '{}' is used twice", column), "name each column once");
  }
  if (!trials.exploration.empty() && !taken.insert(trials.exploration).second) {
    return wrong(fmt::format("column '{}' is used twice", trials.exploration),
                 "name each column once");
  }
  std::set<std::string> labels;
  for (const std::string& label : trials.labels) {
    const bool is_free = taken.insert(label).second || label == trials.exploration;
    if (labels.insert(label).second && is_free) continue;
    return wrong(fmt::format("column '{}' is used twice", label), "name each column once");
  }
  return taken;
}

}  // namespace

std::vector<std::string> csv_label_names(const CsvTrials& trials) {
  std::vector<std::string> names;
  if (!trials.files.empty()) names = NamePattern::parse(trials.files, false).value().labels();
  names.insert(names.end(), trials.labels.begin(), trials.labels.end());
  return names;
}

Result<void> check_csv_shape(const CsvChannel& channel, std::size_t elements) {
  if (channel.shape.empty()) return {};
  std::size_t filled = 1;
  for (const std::size_t length : channel.shape) {
    filled = length > elements ? 0 : filled * length;
    if (filled == 0 || filled > elements) break;
  }
  if (filled == elements) return {};
  return wrong(fmt::format("channel '{}' has {} elements, which do not fill its shape {}",
                           channel.name, elements, fmt::join(channel.shape, " x ")),
               "correct the columns or the shape");
}

Result<void> check_csv_parts(const CsvImport& description,
                             const std::function<std::string(std::size_t)>& place) {
  std::size_t part = 0;
  Result<void> checked = check_trials(description.trials);
  if (checked && description.channels.empty()) {
    checked = wrong("there are no channels",
                    "add a channel with name, unit and columns ([[channel]] in a description)");
  }
  auto taken = checked.and_then([&] { return columns_of_trials(description.trials); });
  std::set<std::string> names;
  checked = taken.map([](const auto&) {});
  while (checked && part < description.channels.size()) {
    checked = check_channel(description.channels[part], description.trials, names, *taken);
    ++part;
  }
  if (checked) {
    part = 0;
    checked = check_ignored(description.trials, *taken);
  }
  if (!checked) checked.error().where = place(part);
  return checked;
}

}  // namespace somato
