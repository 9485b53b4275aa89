#include <nlohmann/json.hpp>

#include "program/support/reproducing.h"

namespace somato {
namespace {

using Json = nlohmann::json;

// A hardness probe that is fitted to one with a hidden force and offset.
class MatchCommand : public Reproduce {
 protected:
  void write_real() {
    write(
        "hidden.toml",
        "[hardness_probe]\nforce = 3.0\npotentiometer_offset = 0.08\npotentiometer_noise = 0.05\n");
    output_of({"explore", "--body", "hardness", "--settings", "hidden.toml", "--explorations", "6",
               "--seed", "77", "-o", "real.mcap"});
  }

  void write_prior(int points, const std::string& more = {}) {
    write("prior.toml", "[sweep]\ndesign = 'sobol'\npoints = " + std::to_string(points) + "\n" +
                            more +
                            "[inference]\naccepted = 0.25\nbodies = 3\npairs = 1\ntruths = 5\n"
                            "[explore]\nbody = 'hardness'\nexplorations = 3\n"
                            "[explore.hardness_probe]\npotentiometer_noise = 0.05\n" +
                            kForce + kOffset);
  }

  static Words match(const std::string& out, const Words& more = {}) {
    Words words{"sweep", "hardness", "--over", "prior.toml", "--match", "real.mcap", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::string error_of(const Words& words) const {
    const ProgramRun done = run(words);
    EXPECT_NE(done.exit_code, 0);
    EXPECT_EQ(done.signal, 0);
    return done.err;
  }

  static inline const std::string kForce =
      "[unknown.force]\nkey = 'explore.hardness_probe.force'\ntext = 'x'\nlow = 1.0\nhigh = 9.0\n"
      "scale = 'logarithmic'\n";
  static inline const std::string kOffset =
      "[unknown.offset]\nkey = 'explore.hardness_probe.potentiometer_offset'\ntext = 'x'\n"
      "low = 0.0\nhigh = 0.2\n";
};

TEST_F(MatchCommand, FitsAProbeToARecording) {
  write_real();
  write_prior(64);
  const std::string shown = output_of(match("out"));
  for (const char* said :
       {"hardness: 64 draws", "Channels: potentiometer",
        "Compared one by one, by the label 'material': rubber wood", "the body before",
        "the body after: 3 settings", "force: ", "Written: out/match.json, out/bodies"}) {
    EXPECT_NE(shown.find(said), std::string::npos) << said << "\n is not in\n" << shown;
  }
  const Json json = Json::parse(read("out/match.json"));
  EXPECT_NEAR(json["unknowns"][0]["posterior"]["median"].get<double>(), 3.0, 0.3);
  EXPECT_NEAR(json["unknowns"][1]["posterior"]["median"].get<double>(), 0.08, 0.01);
  EXPECT_LT(json["distances"]["posterior"]["root_mean_square"],
            json["distances"]["system"]["root_mean_square"]);
  // The files of a body are those of other commands.
  output_of({"explore", "--body", "hardness", "--settings", "out/bodies/02/settings.toml",
             "--explorations", "2", "-o", "again.mcap"});
  EXPECT_NE(
      read("out/bodies/02/settings.toml").find("force = " + json["bodies"][1]["force"].dump()),
      std::string::npos);
  output_of({"run", "out/bodies/02/hardness.toml", "--data", "again.mcap", "--out", "ran"});
  EXPECT_EQ(output_of(match("out")), shown) << "nothing is left to simulate";
  EXPECT_EQ(output_of(match("out", {"--json"})), read("out/match.json"));
}

TEST_F(MatchCommand, PartsAndThreadsGiveTheSameBytes) {
  write_real();
  write_prior(8);
  output_of(match("one", {"--threads", "1"}));
  output_of(match("two", {"--threads", "3", "--part", "2/2"}));
  EXPECT_FALSE(fs::exists(path("two/match.json")));
  output_of(match("two", {"--threads", "2", "--part", "1/2"}));
  EXPECT_TRUE(read("one/match.json") == read("two/match.json"));
  EXPECT_EQ(files("one/bodies"), files("two/bodies"));
  // A damaged draw is simulated again.
  for (const std::string& file : files("one/parts")) {
    if (file.ends_with(".found")) write("one/parts/" + file, "damaged");
  }
  output_of(match("one"));
  EXPECT_TRUE(read("one/match.json") == read("two/match.json"));
}

// The offset is a setting of the sensor, and movements are explored once for both.
TEST_F(MatchCommand, PlaysSensorsOfFewRecordings) {
  write_real();
  write("prior.toml",
        "[sweep]\ndesign = 'sobol'\npoints = 32\nrecordings = 2\n"
        "[inference]\naccepted = 0.25\nbodies = 2\npairs = 1\ntruths = 5\n"
        "[explore]\nbody = 'hardness'\nexplorations = 3\n[explore.hardness_probe]\nforce = 3.0\n"
        "potentiometer_noise = 0.05\n" +
            kOffset);
  output_of(match("out"));
  std::size_t recordings = 0;
  for (const std::string& file : files("out/recordings")) recordings += file.ends_with(".mcap");
  EXPECT_EQ(recordings, 3U) << "two for the draws and one for fresh settings";
  const Json json = Json::parse(read("out/match.json"));
  EXPECT_NEAR(json["unknowns"][0]["posterior"]["median"].get<double>(), 0.08, 0.01);
}

// The values of a list alternate in a sequence of Sobol; each is played on all recordings.
TEST_F(MatchCommand, PlaysEachValueOnAllRecordings) {
  write_real();
  write("prior.toml",
        "[sweep]\ndesign = 'sobol'\npoints = 16\nrecordings = 2\n"
        "[inference]\nbodies = 1\npairs = 1\ntruths = 1\n"
        "[explore]\nbody = 'hardness'\nexplorations = 2\n"
        "[unknown.force]\nkey = 'explore.hardness_probe.force'\ntext = 'x'\nvalues = [3.0, 4.0]\n" +
            kOffset);
  const std::string shown = output_of(match("out"));
  std::size_t of_draws = 0;
  for (const std::string& file : files("out/recordings"))
    of_draws += file.ends_with("-2011.mcap") || file.ends_with("-2012.mcap") ? 1 : 0;
  EXPECT_EQ(of_draws, 4U);
  EXPECT_EQ(shown.find("All draws play the same movements"), std::string::npos);
  write(
      "prior.toml",
      read("prior.toml").replace(read("prior.toml").find("recordings = 2"), 14, "recordings = 1"));
  EXPECT_NE(output_of(match("one")).find("All draws play the same movements"), std::string::npos);
}

TEST_F(MatchCommand, RefusesWhatHasNoEffectOrCannotBeCompared) {
  write_real();
  write_prior(8, "pairs = 2\n");
  EXPECT_NE(error_of(match("out")).find("'pairs' has no effect"), std::string::npos);
  write_prior(8, "recordings = 2\n");
  EXPECT_NE(error_of(match("out")).find("'recordings' has no effect"), std::string::npos);
  write_prior(8);
  EXPECT_NE(error_of(match("out", {"--data", "real.mcap"})).find("--data has no effect"),
            std::string::npos);
  write("sound.toml", "[explore]\nbody = 'texture'\nexplorations = 1\n");
  write("sounds.toml",
        "[sweep]\ndesign = 'sobol'\npoints = 2\n[unknown.noise]\nkey = "
        "'explore.texture_probe.servo_noise'\nlow = 1.0\nhigh = 2.0\ntext = 'x'\n");
  EXPECT_NE(error_of({"sweep", "sound.toml", "--over", "sounds.toml", "--match", "real.mcap",
                      "--out", "out"})
                .find("no common channel"),
            std::string::npos);
  write("prior.toml",
        "[sweep]\ndesign = 'sobol'\npoints = 8\n[unknown.rows]\nkey = "
        "'module.map.rows'\nvalues = [1, 2]\ntext = 'x'\n");
  EXPECT_NE(error_of(match("out")).find("'module.map.rows' has no effect"), std::string::npos);
}

}  // namespace
}  // namespace somato
