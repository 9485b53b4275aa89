#include "recordings/imports/hkust_press_slide.h"

#include "recordings/imports/data_sets.h"
#include "somato/recording/csv_import.h"

namespace somato {

Result<Recording> import_hkust_press_slide(const std::filesystem::path& folder) {
  CsvChannel force;
  force.name = "force";
  force.unit = "N";
  force.columns = {"Fx", "Fy", "Fz"};

  CsvImport description;
  description.trials.files = kHkustPressSlideFiles;
  description.trials.rate = 97.0;
  description.trials.other_columns = Unmentioned::kIgnore;
  description.channels = {force};
  return import_csv_trials(folder, description);
}

}  // namespace somato
