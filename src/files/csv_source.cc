#include "files/csv_source.h"

#include <algorithm>

namespace somato {

Result<std::unique_ptr<NumberSource>> CsvSource::begin(UnchangedFile file,
                                                       const CsvOptions& options,
                                                       std::size_t part_bytes) {
  auto source = std::make_unique<CsvSource>(std::move(file), options, part_bytes);
  return source->rewind().map([&]() -> std::unique_ptr<NumberSource> { return std::move(source); });
}

// A number has at least a digit and a separator, a missing or skipped one a separator; a list of
// unknown length doubles its capacity.
double CsvSource::memory_of_all() const {
  const auto text = static_cast<double>(file_.size());
  const auto features = static_cast<double>(size());
  const double others = static_cast<double>(columns().width) - features;
  const double row = (options_.keeps_missing ? 1.0 : 2.0) * features + others;
  return 4.0 * (text / row) * features * sizeof(float);
}

double CsvSource::share_read() const {
  return static_cast<double>(window_->place()) / static_cast<double>(file_.size());
}

// The names stay the same as long as the file does.
Result<void> CsvSource::rewind() {
  SOMATO_TRY_VOID(file_.check());
  auto window = std::make_unique<TextWindow>(file_.file(), file_.path());
  auto reader =
      std::make_unique<CsvTableReader>(CsvRecords(*window, file_.path()), file_.path(), options_);
  if (is_known_) reader->trust_precision();
  SOMATO_TRY_VOID(reader->begin());
  reader_ = std::move(reader);
  window_ = std::move(window);
  return {};
}

Result<std::shared_ptr<const NumberPart>> CsvSource::next_part() {
  const std::size_t rows = part_bytes_ / sizeof(float) / size();
  Result<NumberTable> table = reader_->rows(std::max<std::size_t>(1, rows));
  if (!table || table->values.empty()) {
    // A fault, or an end, that a change has made is no fault of the file.
    SOMATO_TRY_VOID(file_.check());
    if (!table) return fail(std::move(table.error()));
    is_known_ = true;
    return std::shared_ptr<const NumberPart>();
  }
  return std::make_shared<const NumberPart>(
      NumberPart{Samples(std::move(table->values)), std::move(table->labels)});
}

}  // namespace somato
