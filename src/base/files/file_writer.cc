#include "base/files/file_writer.h"

#include <utility>

#include "base/files/replacement.h"

namespace somato {

FileWriter::FileWriter(std::unique_ptr<Replacement> replacement)
    : replacement_(std::move(replacement)) {}
FileWriter::FileWriter(FileWriter&&) noexcept = default;
FileWriter& FileWriter::operator=(FileWriter&&) noexcept = default;
FileWriter::~FileWriter() = default;

Result<FileWriter> FileWriter::begin(const std::string& path) {
  SOMATO_TRY(auto replacement, Replacement::begin(operating_system(), path));
  return FileWriter(std::make_unique<Replacement>(std::move(replacement)));
}

Result<void> FileWriter::write(std::string_view bytes) {
  return replacement_->write(bytes);
}

Result<void> FileWriter::commit() {
  return replacement_->commit();
}

}  // namespace somato
