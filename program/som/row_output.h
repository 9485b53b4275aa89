#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/files/file_writer.h"
#include "base/files/spool.h"
#include "somato/core/process_group.h"
#include "somato/core/result.h"

namespace somato::program {

/// Text or numbers of rows in a file, or on standard output, written incrementally. Several
/// processes write one after the other, in their order: the first writes the file, the others keep
/// their parts in memory or temporary files until it fetches them.
class RowOutput {
 public:
  /// `path` is empty for standard output; nullptr: only this process. Errors: kSystem.
  static Result<RowOutput> begin(const std::string& path, ProcessGroup* processes);

  /// Errors: kSystem.
  Result<void> write(std::string_view bytes);

  /// Completes the output if all processes, which must call this, have `written` their parts;
  /// otherwise there is no new file. Errors: those of the first process that fails.
  Result<void> commit(Result<void> written);

 private:
  explicit RowOutput(ProcessGroup* processes) : processes_(processes) {}

  Result<void> fetch(std::size_t process, std::size_t count);

  ProcessGroup* processes_;
  std::optional<FileWriter> file_;
  Spool part_;
};

}  // namespace somato::program
