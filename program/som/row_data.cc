#include "som/row_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include "base/files/whole_file.h"
#include "flags/memory_flag.h"
#include "maps/grid/feature_ranges.h"
#include "som/column_report.h"
#include "som/data.h"
#include "somato/core/matrix.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// Large enough for every thread to be busy, small enough to stop soon.
constexpr std::size_t kLargestPart = std::size_t{8} << 20;

// Shares of the memory for rows: one part in use, one being read, and their derived data.
constexpr std::size_t kPartsInMemory = 8;

// Numbers classes in the order in which their names appear.
class ClassesByName {
 public:
  void take(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const auto [found, is_new] = numbers_.emplace(name, classes_.names.size());
      if (is_new) classes_.names.push_back(name);
      classes_.of_sample.push_back(found->second);
    }
  }

  Classes classes() && { return std::move(classes_); }

 private:
  Classes classes_;
  std::map<std::string, std::size_t> numbers_;
};

bool is_regular_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::string name_of_files(const std::vector<std::string>& paths) {
  if (paths.size() == 1) return paths.front();
  return fmt::format("{} and {}", paths.front(), counted(paths.size() - 1, "more file"));
}

}  // namespace

// Reads all rows once, so that errors are reported before any work begins.
class RowReader {
 public:
  RowReader(const Arguments& arguments, JoinedProcesses* processes)
      : arguments_(arguments), processes_(processes) {}

  Result<RowData> read(ColumnChoice choice, std::shared_ptr<const std::string> text) {
    rows_.text = std::move(text);
    auto read = check_labels_given_once(arguments_)
                    .and_then([&] { return check_shareable(); })
                    .and_then([&] { return open(std::move(choice)); })
                    .and_then([&] { return go_through(); })
                    .and_then([&] { return add_labels_of_file(); });
    SOMATO_TRY_VOID(agreed(std::move(read), processes_));
    finish();
    if (processes_) combine();
    return std::move(rows_);
  }

 private:
  // Means and classes would depend on the rows of other processes.
  Result<void> check_shareable() const {
    for (const char* flag : {"labels", "label-column", "missing"}) {
      if (!processes_ || !arguments_.has(flag)) continue;
      return fail(ErrorKind::kUsage, "several processes cannot share the work of this flag",
                  "--" + std::string(flag), "start one process");
    }
    return {};
  }

  tl::unexpected<Error> refuse_to_share() const {
    return fail(ErrorKind::kUsage, "several processes can only share the rows of files", rows_.path,
                "save the rows in a file that all processes can read");
  }

  // Memory that is not given is that of all processes on this machine.
  Result<std::size_t> memory() const {
    const bool divided = processes_ && !arguments_.has("memory");
    return read_memory(arguments_).map([&](std::size_t bytes) {
      return divided ? bytes / processes_->on_this_machine() : bytes;
    });
  }

  void combine() {
    auto count = static_cast<std::int64_t>(rows_.count);
    rows_.first = static_cast<std::size_t>(processes_->sum_before(count));
    processes_->sum({&count, 1});
    rows_.count = static_cast<std::size_t>(count);
    combine_ranges(*processes_, rows_.size(), rows_.low, rows_.high);
  }

  // A file that is not regular cannot be read in parts, and its size is unknown in advance.
  Result<void> open(ColumnChoice choice) {
    SOMATO_TRY(const auto memory, this->memory());
    SOMATO_TRY(auto options, read_table_options(arguments_));
    options.columns.features = std::move(choice.features);
    options.columns.scales = std::move(choice.scales);
    const std::vector<std::string> paths = data_files(arguments_);
    rows_.path = name_of_files(paths);
    is_file_ = paths.size() > 1 || is_regular_file(rows_.path);
    if (!is_file_ && processes_) return refuse_to_share();
    if (!is_file_) SOMATO_TRY_VOID(read_once(memory));
    auto source =
        is_file_ ? open_numbers(paths, options, std::min(kLargestPart, memory / kPartsInMemory))
                 : numbers_in(*rows_.text, rows_.path, options);
    if (!source) return fail(std::move(source.error()));
    rows_.file_ = std::move(*source);
    if (processes_) take_part(*rows_.file_, processes_->rank(), processes_->size());
    is_kept_ = rows_.file_->memory_of_all() <= static_cast<double>(memory);
    rows_.columns = rows_.file_->columns();
    rows_.features = rows_.columns.feature_names();
    return read_missing(arguments_).map([&](MissingFill missing) { rows_.missing = missing; });
  }

  Result<void> read_once(std::size_t memory) {
    if (rows_.text) return {};
    SOMATO_TRY(std::string bytes, read_whole(rows_.path, memory));
    rows_.text = std::make_shared<const std::string>(std::move(bytes));
    return {};
  }

  Result<void> go_through() {
    constexpr std::uint64_t kSteps = 1000;
    const Progress progress = is_file_ ? terminal_progress("reading") : Progress();
    NumberSource& file = *rows_.file_;
    for (;;) {
      SOMATO_TRY(const auto part, file.next_part());
      if (!part) break;
      SOMATO_TRY_VOID(take(*part));
      const auto done = static_cast<std::uint64_t>(file.share_read() * (kSteps - 1));
      if (progress && !progress(done, kSteps)) return reading_stopped();
    }
    if (progress) progress(kSteps, kSteps);
    rows_.rounded = file.rounded();
    rows_.classes = std::move(classes_).classes();
    return {};
  }

  Result<void> take(const NumberPart& part) {
    rows_.count += part.samples.count();
    classes_.take(part.labels);
    if (is_kept_) keep(part.samples);
    if (rows_.missing == MissingFill::kRefuse) {
      widen_ranges(part.samples, rows_.low, rows_.high);
      return {};
    }
    Result<void> taken = rows_.known.take(part.samples);
    if (!taken) taken.error().where = rows_.path;
    return taken;
  }

  // The number of rows is estimated from the first part.
  void keep(const Samples& samples) {
    if (values_.empty()) {
      const auto numbers = static_cast<double>(samples.count() * samples.size());
      values_.reserve(static_cast<std::size_t>(std::ceil(numbers / rows_.file_->share_read())));
    }
    for (std::size_t i = 0; i < samples.count(); ++i) {
      const std::span<const float> row = samples[i].values;
      values_.insert(values_.end(), row.begin(), row.end());
    }
  }

  Result<void> add_labels_of_file() {
    SOMATO_TRY(const auto labels, read_labels_of(arguments_, rows_.count));
    if (!labels.empty()) rows_.classes = Classes::from_names(labels);
    return {};
  }

  void finish() {
    rows_.own_count = rows_.count;
    if (rows_.missing != MissingFill::kRefuse) {
      rows_.low = rows_.known.low();
      rows_.high = rows_.known.high();
      rows_.holds_missing = rows_.known.missing() > 0;
    }
    if (is_kept_) {
      rows_.keep(Samples(Matrix<float>(rows_.count, rows_.size(), std::move(values_))));
      rows_.file_.reset();
    } else {
      rows_.samples_ = std::make_unique<StoppableRows>(*rows_.file_);
    }
  }

  const Arguments& arguments_;
  JoinedProcesses* processes_;
  RowData rows_;
  bool is_file_ = false;  // a regular one
  bool is_kept_ = false;  // all rows, in memory
  std::vector<float> values_;
  ClassesByName classes_;
};

void RowData::keep(Samples samples) {
  all_ = std::make_unique<const Samples>(std::move(samples));
  samples_ = std::make_unique<SamplesInMemory>(*all_);
}

Result<void> RowData::fill(const std::vector<double>& means, const std::vector<double>& scale) {
  if (!holds_missing) return {};
  holds_missing = missing == MissingFill::kLeaveOut;
  if (missing == MissingFill::kMean) {
    if (all_) {
      keep(filled_with(means, *all_));
    } else {
      filled_ = std::make_unique<ChangedSamples>(
          *samples_, [means](const Samples& part) { return filled_with(means, part); });
    }
    return {};
  }
  if (!all_) {
    return fail(ErrorKind::kSystem,
                fmt::format("--missing {} needs all rows in memory, and they exceed the memory for "
                            "rows",
                            choice_name(missing)),
                path, "use --missing mean, or a larger --memory");
  }
  if (missing == MissingFill::kLeaveOut) return {};
  auto filled = filled_from_nearest(*all_, scale, terminal_progress("filling"));
  if (!filled) {
    filled.error().where = path;
    if (filled.error().kind == ErrorKind::kData) {
      filled.error().advice = "use --missing mean, or leave columns out with --skip";
    }
    return fail(std::move(filled.error()));
  }
  keep(std::move(*filled));
  return {};
}

Result<RowData> read_rows(const Arguments& arguments, const std::vector<std::string>& features,
                          JoinedProcesses* processes, const std::vector<ColumnScale>& scales,
                          std::shared_ptr<const std::string> text) {
  SOMATO_TRY(auto rows,
             RowReader(arguments, processes).read({{}, {}, features, scales}, std::move(text)));
  if (!processes || processes->is_first()) note_rounded(rows);
  return rows;
}

Result<void> refuse_constant_columns(const RowData& rows, const std::string& path) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows.low[i] != rows.high[i]) continue;
    const std::string name = rows.features.empty() ? "" : fmt::format(" ('{}')", rows.features[i]);
    return fail(ErrorKind::kData,
                fmt::format("column {}{} has the same value in every row",
                            rows.columns.features[i] + 1, name),
                path, "leave the column out with --skip, or use --keep-constant-columns");
  }
  return {};
}

}  // namespace somato::program
