#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "somato/core/result.h"
#include "studies/folds/fold_run.h"

namespace somato {

/// The trainings of a study that are done, kept in a file as they are done, so that a study that
/// was interrupted resumes where it was. Each training has a line with its checksum; from the first
/// line on that is cut or damaged, lines are left out. There is no file before there is something
/// to keep.
class Journal {
 public:
  /// No file: nothing is kept.
  Journal() = default;

  /// Continues the journal at `path`, if it exists. `fingerprint` identifies the study. Errors:
  /// kSystem; kUsage if the file is the journal of another study, kData if it is not a journal.
  static Result<Journal> open(const std::string& path, const std::string& fingerprint);

  /// Continues the journal of one part of the study in the folder `own`. Errors: kSystem.
  static Result<Journal> open_part(const std::filesystem::path& own,
                                   const std::string& fingerprint);

  /// Takes in the trainings that the parts in the folders of `parts` have completed so far; lines
  /// that are cut or damaged are left out.
  void look(const std::filesystem::path& parts, const std::string& fingerprint);

  /// The result of training number `training` of protocol number `protocol`, if it is completed.
  const FoldOutcome* find(std::size_t protocol, std::size_t training) const;

  /// Stores the result of a training, from any thread. Errors: kSystem.
  Result<void> add(std::size_t protocol, std::size_t training, const FoldOutcome& outcome);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  Result<void> read(const std::string& text);
  /// Returns the length of the valid part of a journal of this study.
  std::size_t read_trainings(const std::string& text);
  bool write(const std::string& line);

  std::string path_;
  std::string header_;     ///< The line that the file begins with.
  std::size_t whole_ = 0;  ///< Bytes of whole lines that the file began with.
  std::unique_ptr<std::FILE, Close> file_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  std::map<std::pair<std::size_t, std::size_t>, FoldOutcome> known_;
};

}  // namespace somato
