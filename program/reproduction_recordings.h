#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explore_table.h"
#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"
#include "somato/studies/reproduction.h"

namespace somato::program {

/// A recording to run a system on, with one to test new individuals with if there is any.
struct PairedRecording {
  RecordingInfo info;
  Recording recording;
  std::optional<Recording> test;
};

/// Recordings for whoever asks again, as long as they are small together: several systems run on
/// the same.
class KeptRecordings {
 public:
  using Kept = std::shared_ptr<const PairedRecording>;

  /// What was kept under the key, or nullptr.
  Kept find(const std::string& key) const;

  Kept keep(const std::string& key, PairedRecording recording);

 private:
  std::map<std::string, Kept> kept_;
  std::size_t bytes_ = 0;
};

/// Recordings that are explored when they are asked for, and kept in a folder: who asks again, or
/// goes on after an interruption, gets the same file. Of several processes that need the same one
/// the first explores it and the others wait.
class ExploredRecordings {
 public:
  ExploredRecordings(std::filesystem::path folder, std::uint64_t first_seed, std::size_t threads)
      : folder_(std::move(folder)), first_seed_(first_seed), threads_(threads) {}

  /// Recording number `index` of those that the table asks for, with the seed after those before
  /// it. Errors: those of exploring, also when a single exploration fails; kInterrupted.
  Result<KeptRecordings::Kept> get(const ExploreTable& table, std::size_t index);

  /// A text that differs where the recording does, known before it is explored. Errors: kSystem,
  /// for a file of objects that cannot be read.
  Result<std::string> identity(const ExploreTable& table, std::size_t index) const;

 private:
  Result<PairedRecording> read(const ExploreTable& table, std::uint64_t seed) const;
  Result<Recording> explored(const ExploreTable& table, bool new_objects, std::uint64_t seed,
                             std::string& name) const;
  Result<void> explore(const ExploreTable& table, bool new_objects, std::uint64_t seed,
                       const std::string& name) const;

  std::filesystem::path folder_;
  std::uint64_t first_seed_;
  std::size_t threads_;
  KeptRecordings kept_;
};

/// Recordings at a path: a file; the files of a folder; a data set; or the data sets in a folder.
class GivenRecordings {
 public:
  /// Looks what is there. Errors: kSystem for a path that cannot be read; kData when nothing is.
  static Result<GivenRecordings> at(const std::filesystem::path& path);

  /// The recordings' files in a folder, and nothing else of it.
  static GivenRecordings files_in(const std::filesystem::path& folder);

  std::size_t count() const { return places_.size(); }
  const std::filesystem::path& path(std::size_t number) const { return places_[number].path; }

  /// Numbers of those a study of this format can be about: automatic, recordings of bodies.
  std::vector<std::size_t> of_format(RecordingFormat format) const;

  Result<KeptRecordings::Kept> get(std::size_t number);

 private:
  struct Place {
    std::filesystem::path path;
    RecordingFormat format;  ///< kAutomatic for a recording's file.
  };

  /// If it is a recording or a known data set.
  void add(const std::filesystem::path& place);

  std::vector<Place> places_;
  KeptRecordings kept_;
};

}  // namespace somato::program
