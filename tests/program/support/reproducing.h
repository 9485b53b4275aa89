#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/support/program_test.h"

namespace somato {

namespace fs = std::filesystem;

/// Runs `somato reproduce` on small systems of a test's own.
class Reproduce : public ProgramTest {
 protected:
  // Small maps of two presses of each of the probe's things: done in a moment.
  static std::string press(const std::string& name = "press", const std::string& iterations = "50",
                           const std::string& side = "3") {
    return "[study]\nname = '" + name +
           "'\nlabel = 'material'\nprotocols = ['train_is_test', 'leave_one_out']\n"
           "[module.potentiometer]\ntype = 'channel'\nchannel = 'potentiometer'\nshape = [1]\n"
           "[module.reading]\ntype = 'last'\ninput = 'potentiometer'\n"
           "[module.map]\ntype = 'som'\ninput = 'reading'\nrows = " +
           side + "\ncolumns = " + side + "\niterations = " + iterations +
           "\n[explore]\nbody = 'hardness'\nexplorations = 2\n";
  }
  // Lines of press(), which ends with its table [explore].
  static constexpr int kLines = 20;

  static Words reproduce(const std::string& system, const std::string& out,
                         const Words& more = {}) {
    Words words{"reproduce", system, "--out", out, "--pairs", "3", "--recordings", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  nlohmann::json results(const std::string& out) const {
    return nlohmann::json::parse(read(out + "/results.json"));
  }

  // Files below a folder, by their paths in it.
  Words files(const std::string& folder) const {
    Words found;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (entry.is_regular_file()) found.push_back(fs::relative(entry, path(folder)).string());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<fs::file_time_type> times(const std::string& folder) const {
    std::vector<fs::file_time_type> found;
    for (const std::string& file : files(folder)) {
      found.push_back(fs::last_write_time(path(folder + "/" + file)));
    }
    return found;
  }
};

}  // namespace somato
