#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "views/report/results_file.h"
#include "views/skins/channel_places.h"

namespace somato {

/// The known properties of an object or material.
struct ReportThing {
  std::string name;
  std::string shape;                          ///< As in a table of objects; empty: none.
  std::optional<std::array<double, 3>> size;  ///< Width, depth, height in mm.
  double top_diameter = 0.0;                  ///< mm.
  std::string material;
  std::string hardness;
  std::optional<std::array<double, 3>> colour;  ///< Red, green, blue, 0 to 1.
  std::optional<double> mass;                   ///< kg.
};

/// A trained system and the file it was in.
struct ReportModel {
  std::string path;
  SystemModel model;
};

/// Results and the path of their file.
struct ReportFile {
  std::string path;
  Results results;
};

/// The text of an inference.json and the path of its file.
struct ReportInference {
  std::string path;
  std::string text;
};

/// Sources of the data that results refer to.
struct ReportSources {
  std::string version;  ///< Version of the program.
  /// Returns the valid recording with that content_hash(), or nullptr; may be empty.
  std::function<std::shared_ptr<const Recording>(const std::string& hash)> recording;
  /// Returns the trained system of the results at a path; may be empty.
  std::function<Result<ReportModel>(const std::string& results, const ModelFile& model)> model;
  /// Returns the path of the recording with that content_hash(), as a command may name it; may be
  /// empty.
  std::function<std::string(const std::string& hash)> recording_path = {};
  std::string named_recordings =
      {};                           ///< The path in which the user searched for them; empty: none.
  std::vector<ReportThing> things;  ///< Those that the user describes.
  std::vector<ReportThing> built_in_things;  ///< Those of the simulated bodies' tables.
  std::map<std::string, std::string>
      units;  ///< The units of settings, such as "explore.simulation.noise".
  std::size_t threads = 1;
  std::vector<ChannelPlaces> places = {};  ///< Places of elements, from a layout file.
};

/// A report, before it is embedded in a page.
struct Report {
  std::string
      json;  ///< As described in docs/formats/report.md; the same bytes for the same sources.
  std::size_t systems = 0;
  std::size_t claims = 0;
  std::size_t inferences = 0;
  std::vector<std::string> missing;  ///< Sentences about missing data, without repeats.
};

/// Composes the report for the systems in `files` and for `inferences`. Missing data are omitted,
/// with a sentence. Errors: kData for winners that are not on the map of their study, and for
/// fields of an inference that are missing or wrong; those of check_channels() and places_for().
Result<Report> make_report(const std::vector<ReportFile>& files, const ReportSources& sources,
                           const std::vector<ReportInference>& inferences = {});

/// The page with the report instead of its placeholder `null`, escaped so that it cannot end the
/// element or be interpreted as code. Errors (kUsage): the page has no placeholder, or more than
/// one.
Result<std::string> report_page(std::string_view page, std::string_view json);

}  // namespace somato
