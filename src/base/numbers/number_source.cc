#include "base/numbers/number_source.h"

#include <algorithm>
#include <utility>

#include "base/arrays/mat_array.h"
#include "base/files/unchanged_file.h"
#include "base/numbers/csv_source.h"
#include "base/numbers/joined_numbers.h"
#include "base/numbers/npy_source.h"
#include "base/numbers/numbers_in_memory.h"
#include "base/numbers/whole_table.h"
#include "base/text/flag_hint.h"
#include "somato/core/check.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

Result<void> check_columns(const NumberSource& file, const std::string& path,
                           const NumberSource& first) {
  const TableColumns& own = file.columns();
  const TableColumns& others = first.columns();
  if (own.features.size() == others.features.size() &&
      own.feature_names() == others.feature_names()) {
    return {};
  }
  return fail(ErrorKind::kData, "the file has other columns than the first one", path,
              "name files with the same columns, or select the same columns of each" +
                  flag_hint("columns-to-use"));
}

}  // namespace

Result<SamplePart> NumberSource::next() {
  return next_part().map([](const std::shared_ptr<const NumberPart>& part) {
    return part ? SamplePart(part, &part->samples) : SamplePart();
  });
}

Result<std::unique_ptr<NumberSource>> open_numbers(const std::string& path,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes) {
  return detail::open_numbers(operating_system(), path, options, part_bytes);
}

Result<std::unique_ptr<NumberSource>> open_numbers(const std::vector<std::string>& paths,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes) {
  require(!paths.empty(), "there are no files of numbers");
  if (paths.size() == 1) return open_numbers(paths.front(), options, part_bytes);
  std::vector<std::unique_ptr<NumberSource>> files;
  files.reserve(paths.size());
  for (const std::string& path : paths) {
    SOMATO_TRY(auto file, open_numbers(path, options, part_bytes));
    if (!files.empty()) {
      SOMATO_TRY_VOID(check_columns(*file, path, *files.front()));
    }
    files.push_back(std::move(file));
  }
  return std::make_unique<JoinedNumbers>(std::move(files));
}

void take_part(NumberSource& source, std::size_t part, std::size_t of) {
  const std::size_t each = source.extent() / of;
  const std::size_t more = source.extent() % of;  // parts with one place more
  const std::size_t begin = part * each + std::min(part, more);
  source.take_places(begin, begin + each + (part < more ? 1 : 0));
}

Result<std::unique_ptr<NumberSource>> numbers_in(const std::string& bytes, const std::string& where,
                                                 const CsvOptions& options) {
  return whole_table(bytes, where, options)
      .map([](WholeTable&& whole) -> std::unique_ptr<NumberSource> {
        return std::make_unique<NumbersInMemory>(std::move(whole));
      });
}

Result<std::unique_ptr<NumberSource>> detail::open_numbers(FileSystem& files,
                                                           const std::string& path,
                                                           const CsvOptions& options,
                                                           std::size_t part_bytes) {
  SOMATO_TRY(auto file, UnchangedFile::open(files, path));
  char start[kMatHeader];
  const std::size_t size = std::min(sizeof start, file.size());
  SOMATO_TRY_VOID(file.read(0, start, size));
  if (holds_variables({start, size}) || !options.variable.empty()) {
    std::string bytes(file.size(), '\0');
    SOMATO_TRY_VOID(file.read(0, bytes.data(), bytes.size()));
    return numbers_in(bytes, path, options);
  }
  if (!is_npy({start, size})) return CsvSource::begin(std::move(file), options, part_bytes);
  return NpySource::begin(std::move(file), options, part_bytes);
}

}  // namespace somato
