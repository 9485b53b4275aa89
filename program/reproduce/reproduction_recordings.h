#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "explore/explore_table.h"
#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"
#include "studies/run/reproduction_run.h"

namespace somato::program {

/// A given recording: read_study_data() of a path, named by the path's last part.
Result<PairedRecording> read_given(const RecordingParameters& parameters, const std::string& path);

/// A recording with its description.
PairedRecording paired_recording(std::string name, std::uint64_t seed, Recording recording);

/// The things that the table explores, or the body's new ones. Errors: those of reading objects.
Result<ObjectTable> explored_things(const ExploreTable& table, bool new_objects = false);

/// Caches recordings, as long as they are small in total: several systems run on the same ones.
/// When they are not, all are released but the latest.
class KeptRecordings {
 public:
  using Kept = std::shared_ptr<const PairedRecording>;

  /// The recording with this key, or nullptr.
  Kept find(const std::string& key) const;

  Kept keep(const std::string& key, PairedRecording recording);

 private:
  std::map<std::string, Kept> kept_;
  std::size_t bytes_ = 0;
};

/// Recordings that are explored on demand and stored in a folder: a later request, also after an
/// interruption, uses the same file. If several processes need the same recording, the first
/// explores it and the others wait; different recordings are explored at the same time.
class ExploredRecordings {
 public:
  ExploredRecordings(std::filesystem::path folder, std::uint64_t first_seed, std::size_t threads)
      : folder_(std::move(folder)), first_seed_(first_seed), threads_(threads) {}

  /// Sets the seed of recording 0.
  void begin_at(std::uint64_t first_seed) { first_seed_ = first_seed; }

  /// Recording number `index` of the table, with a consecutive seed. Errors: those of exploring,
  /// also if a single exploration fails; kInterrupted.
  Result<KeptRecordings::Kept> get(const ExploreTable& table, std::size_t index);

  /// A text that identifies the recording before it is explored. Errors: kSystem, for a file of
  /// objects that cannot be read.
  Result<std::string> identity(const ExploreTable& table, std::size_t index) const;

  /// The path of the recording with this seed, or of that of the new objects. Errors: as above.
  Result<std::string> path(const ExploreTable& table, bool new_objects, std::uint64_t seed) const;

  /// Removes the file of the recording at that place, and that of its new objects, if they exist.
  /// Errors: as above.
  Result<void> remove(const ExploreTable& table, std::size_t index) const;

  /// Explores it unless its file exists. Errors: those of get().
  Result<void> explore_missing(const ExploreTable& table, bool new_objects,
                               std::uint64_t seed) const;

  /// The same, and reads it.
  Result<PairedRecording> explored(const ExploreTable& table, bool new_objects,
                                   std::uint64_t seed) const;

 private:
  Result<PairedRecording> read(const ExploreTable& table, std::uint64_t seed) const;
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
  /// Searches the path. Errors: kSystem for a path that cannot be read; kData without recordings.
  static Result<GivenRecordings> at(const std::filesystem::path& path);

  /// The recording at a path, which is known to be one; get() reads it.
  static GivenRecordings one(const std::filesystem::path& path, RecordingParameters parameters);

  /// Only the recordings' files in a folder.
  static GivenRecordings files_in(const std::filesystem::path& folder);

  std::size_t count() const { return places_.size(); }
  const std::filesystem::path& path(std::size_t number) const { return places_[number].path; }

  /// The numbers of recordings with a format of the study: automatic, recordings of bodies.
  std::vector<std::size_t> of_format(RecordingFormat format) const;

  Result<KeptRecordings::Kept> get(std::size_t number);

 private:
  struct Place {
    std::filesystem::path path;
    RecordingParameters parameters;  ///< With kAutomatic for a recording's file.
  };

  /// Whether it is a recording or a known data set.
  void add(const std::filesystem::path& place);

  std::vector<Place> places_;
  KeptRecordings kept_;
};

}  // namespace somato::program
