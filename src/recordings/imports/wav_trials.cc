#include "recordings/imports/wav_trials.h"

#include <utility>

#include "base/arrays/wav.h"
#include "base/files/whole_file.h"
#include "recordings/tables/name_pattern.h"
#include "recordings/tables/trial_files.h"

namespace somato {
namespace {

Result<Exploration> exploration_of(const TrialFile& file) {
  SOMATO_TRY(const std::string bytes, read_whole(file.path));
  SOMATO_TRY(Sound sound, decode_wav(bytes, file.path));
  Channel channel{"sound", "", {}, std::move(sound.samples), {}, sound.rate};
  Exploration exploration{file.labels, file.path, {}};
  exploration.channels.push_back(std::move(channel));
  return exploration;
}

}  // namespace

Result<Recording> import_wav_trials(const std::filesystem::path& folder, const std::string& files,
                                    bool pass_over_others) {
  auto pattern = NamePattern::parse(files);
  if (!pattern) {
    pattern.error().what = "'files': " + pattern.error().what;
    return fail(std::move(pattern.error()));
  }
  SOMATO_TRY(const auto found, find_trial_files(folder, *pattern, pass_over_others));
  Recording recording;
  recording.explorations.reserve(found.size());
  for (const TrialFile& file : found) {
    SOMATO_TRY(Exploration exploration, exploration_of(file));
    recording.explorations.push_back(std::move(exploration));
    auto alike = check_alike(recording.explorations.back(), recording.explorations.front());
    if (alike) continue;
    alike.error().where = file.path;
    return fail(std::move(alike.error()));
  }
  return recording;
}

}  // namespace somato
