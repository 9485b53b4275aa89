#include "files/number_source.h"

#include <utility>

#include "files/csv_source.h"
#include "files/mat_array.h"
#include "files/npy_source.h"
#include "files/numbers_in_memory.h"
#include "files/unchanged_file.h"
#include "files/whole_table.h"
#include "somato/core/check.h"
#include "somato/files/npy.h"

namespace somato {

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
