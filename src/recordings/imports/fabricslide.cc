#include "recordings/imports/fabricslide.h"

#include "recordings/imports/data_sets.h"
#include "somato/recording/csv_import.h"

namespace somato {

Result<Recording> import_fabricslide(const std::filesystem::path& folder) {
  CsvChannel touch;
  touch.name = "touch";
  touch.unit = "counts";
  touch.columns = {"channel1..channel16"};

  CsvChannel speed;
  speed.name = "speed";
  speed.unit = "mm/s";
  speed.from_label = "velocity";
  speed.absolute = true;

  CsvImport description;
  description.trials.files = kFabricslideFiles;
  description.trials.time = {"timestamp"};
  description.trials.time_unit = TimeUnit::kMilliseconds;
  description.trials.ignore = {"proximity1", "proximity2"};
  description.channels = {touch, speed};
  return import_csv_trials(folder, description);
}

}  // namespace somato
