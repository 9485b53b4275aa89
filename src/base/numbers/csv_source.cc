#include "base/numbers/csv_source.h"

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
  const auto text = static_cast<double>(end_ - begin_);
  const auto features = static_cast<double>(size());
  const double others = static_cast<double>(columns().width) - features;
  const double row = (options_.keeps_missing ? 1.0 : 2.0) * features + others;
  return 4.0 * (text / row) * features * sizeof(float);
}

double CsvSource::share_read() const {
  const std::size_t place = std::clamp(window_->place(), begin_, end_);
  if (begin_ == end_) return 1.0;
  return static_cast<double>(place - begin_) / static_cast<double>(end_ - begin_);
}

void CsvSource::take_places(std::size_t begin, std::size_t end) {
  begin_ = begin;
  end_ = end;
  first_row_.reset();
}

// The names stay the same as long as the file does.
Result<void> CsvSource::rewind() {
  SOMATO_TRY_VOID(file_.check());
  if (first_row_) return go_to(*first_row_);
  auto window = std::make_unique<TextWindow>(file_.file(), file_.path());
  auto reader =
      std::make_unique<CsvTableReader>(CsvRecords(*window, file_.path()), file_.path(), options_);
  SOMATO_TRY_VOID(reader->begin());
  reader_ = std::move(reader);
  window_ = std::move(window);
  return {};
}

Result<void> CsvSource::go_to(const CsvRecords::Start& start) {
  auto window =
      std::make_unique<TextWindow>(file_.file(), file_.path(), start.place, start.line - 1);
  if (is_known_) reader_->trust_precision();
  SOMATO_TRY_VOID(reader_->continue_with(CsvRecords(*window, file_.path(), start.line)));
  window_ = std::move(window);
  return {};
}

// A row may contain line ends in quotation marks, so that it can only be found from the beginning.
Result<void> CsvSource::go_to_first_row() {
  reader_->end_at(end_);
  SOMATO_TRY_VOID(reader_->skip_to(begin_));
  first_row_ = reader_->start();
  return {};
}

Result<std::shared_ptr<const NumberPart>> CsvSource::next_part() {
  if (begin_ == end_) return std::shared_ptr<const NumberPart>();
  if (!first_row_) {
    SOMATO_TRY_VOID(go_to_first_row());
  }
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
