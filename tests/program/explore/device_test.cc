// Devices at serial lines, which the program emulates itself at pseudo-terminals.

#include "program/support/emulation_test.h"
#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

namespace somato {
namespace {

const std::string kEndless = "100000";  // explorations, of which some are interrupted

class Device : public EmulationTest {
 protected:
  Device() {
    write("materials.toml",
          "[material.bark]\nhardness = \"hard\"\nstiffness = 40.0\n"
          "[material.moss]\nhardness = \"soft\"\nstiffness = 3.0\n");
  }

  // The hardness probe before bark and moss, with d.toml.
  ProgramRun with_probe(const std::string& bus, const std::function<void()>& work,
                        int signal = SIGINT) const {
    return with_emulation({"--body", "hardness", "--bus", bus, "--objects", "materials.toml"}, work,
                          signal);
  }

  Words explore(const std::string& explorations) const {
    return {"explore",        "--device",   "d.toml", "--objects", "materials.toml",
            "--explorations", explorations, "-o",     "felt.mcap"};
  }

  Recording recorded() const {
    auto recording = read_recording(path("felt.mcap"));
    EXPECT_TRUE(recording) << to_string(recording.error());
    return recording ? *recording : Recording();
  }

  // The recording up to then is whole, and the last states are beside it.
  void expect_stopped_by_a_hang_up(const ProgramRun& done) const {
    EXPECT_NE(done.exit_code, 0);
    // While the next material is placed, the first sign may be a port that has gone.
    const bool is_hung_up =
        done.err.find("the line has hung up; check the cable") != std::string::npos;
    const bool is_gone = done.err.find("cannot open the port") != std::string::npos;
    EXPECT_TRUE(is_hung_up || is_gone) << done.err;
    EXPECT_GE(recorded().explorations.size(), 1U);
    EXPECT_NE(done.err.find("were not begun"), std::string::npos) << done.err;
    // Between two explorations there are no states of a fault.
    if (done.err.find("felt.mcap.fault.csv") == std::string::npos) return;
    const std::string states = read("felt.mcap.fault.csv");
    EXPECT_TRUE(states.starts_with("time")) << states.substr(0, 100);
    EXPECT_GT(std::count(states.begin(), states.end(), '\n'), 10);
  }

  Words live(const std::string& objects, const std::string& explorations) const {
    return {"live",      "--model", "out/system.somato", "--device",  "d.toml",
            "--objects", objects,   "--explorations",    explorations};
  }

  // The last reading of `live` for each thing.
  std::vector<std::string> read_live(const std::string& objects) const {
    const std::string lines = output_of(live(objects, "1"));
    std::vector<std::string> read;
    for (std::size_t begin = 0; begin < lines.size();) {
      const std::size_t end = lines.find('\n', begin);
      const auto line = nlohmann::json::parse(lines.substr(begin, end - begin));
      if (line.at("final") == true) read.push_back(line.at("value").get<std::string>());
      begin = end + 1;
    }
    return read;
  }
};

TEST_F(Device, IsCheckedExploresIsTrainedOnAndRecognizes) {
  const ProgramRun emulated = with_probe("ssc32", [&] {
    const std::string checked = output_of({"device", "check", "d.toml"});
    EXPECT_NE(checked.find("servo \"stick\": channel 0, off"), std::string::npos) << checked;
    EXPECT_NE(checked.find(" within a period, median "), std::string::npos) << checked;
    EXPECT_NE(checked.find("The device can explore.\n"), std::string::npos) << checked;
    EXPECT_EQ(output_of(explore("2")), "felt.mcap: 4 explorations of 2 things, 1 frame each\n");
    write("study.toml",
          "[study]\nname = 'hardness'\nlabel = 'material'\nseeds = 1\n"
          "[module.stick]\ntype = 'channel'\nchannel = 'potentiometer'\n"
          "[module.end]\ntype = 'last'\ninput = 'stick'\n"
          "[module.map]\ntype = 'som'\ninput = 'end'\nrows = 1\ncolumns = 4\n"
          "normalize_input = false\niterations = 200\n");
    output_of({"run", "study.toml", "--data", "felt.mcap", "--out", "out"});
    EXPECT_EQ(read_live("materials.toml"), (Words{"bark", "moss"}));
  });
  EXPECT_EQ(emulated.exit_code, 0) << emulated.err;
  EXPECT_NE(emulated.out.find("At the end, 0 of 1 servos were on.\n"), std::string::npos)
      << emulated.out << emulated.err;
  // Now its ports are gone, which is said once.
  for (const Words& words : {explore("3"), live("materials.toml", "3")}) {
    const ProgramRun gone = run(words);
    EXPECT_NE(gone.exit_code, 0);
    const std::size_t first = gone.err.find("cannot open the port");
    EXPECT_NE(first, std::string::npos) << gone.err;
    EXPECT_EQ(gone.err.find("cannot open the port", first + 1), std::string::npos) << gone.err;
  }
}

// Its microphone is a stream of samples beside the line of its servo.
TEST_F(Device, TheTextureProbeIsTrainedOnAndRecognizes) {
  write("sounds.toml",
        "[material.bark]\nhardness = \"hard\"\nloss = 0.02\nroughness = 40\n"
        "correlation_length = 1.0\n"
        "[material.moss]\nhardness = \"soft\"\nloss = 0.4\nroughness = 5\n"
        "correlation_length = 0.1\n");
  with_emulation({"--body", "texture", "--bus", "sts", "--objects", "sounds.toml"}, [&] {
    EXPECT_EQ(output_of({"explore", "--device", "d.toml", "--objects", "sounds.toml",
                         "--explorations", "1", "-o", "felt.mcap"}),
              "felt.mcap: 2 explorations of 2 things, 8192 frames each\n");
    write("study.toml",
          "[study]\nname = 'texture'\nlabel = 'material'\nseeds = 1\n"
          "[module.sound]\ntype = 'channel'\nchannel = 'sound'\n"
          "[module.spectrum]\ntype = 'spectrum'\ninput = 'sound'\nsegment_length = 4096\n"
          "bands = 0\n"
          "[module.map]\ntype = 'som'\ninput = 'spectrum'\nrows = 1\ncolumns = 4\n"
          "iterations = 200\n");
    output_of({"run", "study.toml", "--data", "felt.mcap", "--out", "out"});
    EXPECT_EQ(read_live("sounds.toml"), (Words{"bark", "moss"}));
  });
}

// Two emulations of the same seed are the same on every machine.
TEST_F(Device, ExploresTheSameInTheTimeOfTheHost) {
  Recording first;
  for (int i = 0; i < 2; ++i) {
    with_probe("dynamixel", [&] { output_of(explore("2")); });
    ASSERT_EQ(recorded().explorations.size(), 4U);
    if (i == 0) first = recorded();
  }
  EXPECT_EQ(first.explorations, recorded().explorations);
}

TEST_F(Device, EmulatesTheTimeThatIsAskedFor) {
  const auto written = [&](const Words& clock) {
    ProgramWorld world;
    world.interrupt_at = "Press Ctrl-C to end";
    Words words{"emulate", "--body", "hardness", "-o", "d.toml"};
    words.insert(words.end(), clock.begin(), clock.end());
    EXPECT_EQ(run(words, world).exit_code, 0);
    return read("d.toml");
  };
  const std::string real = written({});
  EXPECT_NE(real.find("\nclock = 1\n"), std::string::npos) << real;
  EXPECT_NE(real.find("\nmissed = 3\n"), std::string::npos) << real;  // 0.06 s of 20 ms each
  const std::string fast = written({"--clock", "10"});
  EXPECT_NE(fast.find("\nclock = 10\n"), std::string::npos) << fast;
  EXPECT_NE(fast.find("\nmissed = 30\n"), std::string::npos) << fast;
  EXPECT_EQ(fast.find("clock_port"), std::string::npos) << fast;
  const std::string of_host = written({"--clock", "host"});
  EXPECT_NE(of_host.find("\nclock_port = \"/dev/pts/"), std::string::npos) << of_host;
  EXPECT_EQ(of_host.find("\nmissed"), std::string::npos) << of_host;
  // The file of another emulation says nothing about this one.
  std::filesystem::rename(path("d.toml"), path("host.toml"));
  const std::string again = written({"--device", "host.toml", "--clock", "2"});
  EXPECT_NE(again.find("\nclock_port = \"\"\n"), std::string::npos) << again;
  expect_refused(2, {{{"emulate", "--body", "hardness", "--clock", "guest", "-o", "d.toml"},
                      {"--clock", "'host'"}}});
}

TEST_F(Device, ExploresOnOtherBuses) {
  for (const std::string& bus : names_of_buses()) {
    if (bus == "ssc32") continue;  // the bus of the other tests
    const ProgramRun emulated = with_probe(bus, [&] {
      const std::string checked = output_of({"device", "check", "d.toml"});
      EXPECT_NE(checked.find("The device can explore.\n"), std::string::npos) << checked;
      output_of(explore("1"));
    });
    ASSERT_EQ(recorded().explorations.size(), 2U);
    const auto reading = [&](std::size_t exploration) {
      return recorded().explorations[exploration].channels[0].frames(0, 0);
    };
    EXPECT_LT(reading(0), 0.5F * reading(1));  // the stick reaches further into moss
    EXPECT_NE(emulated.out.find("At the end, 0 of 1 servos were on.\n"), std::string::npos)
        << emulated.out << emulated.err;
  }
}

TEST_F(Device, StopsWhenItsLinesHangUpAndKeepsWhatWasExplored) {
  for (const std::string& bus : names_of_buses()) {
    SCOPED_TRACE(bus);
    ProgramRun done;
    std::thread exploring;
    with_probe(
        bus,
        [&] {
          std::promise<void> has_explored;
          std::future<void> explored = has_explored.get_future();
          exploring = std::thread([&, has_explored = std::move(has_explored)]() mutable {
            ProgramWorld world;
            world.terminal = true;
            world.interrupt_at = " left";  // after the first exploration
            world.interrupt_with = 0;
            world.before_interrupt = [&](const std::string&) { has_explored.set_value(); };
            done = run(explore(kEndless), world);
          });
          explored.wait();
        },
        SIGKILL);
    exploring.join();
    expect_stopped_by_a_hang_up(done);
  }
}

TEST_F(Device, IsSwitchedOffBySignals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT}) {
    ProgramRun done;
    const ProgramRun emulated = with_probe("dynamixel", [&] {
      ProgramWorld world;
      world.terminal = true;
      world.interrupt_at = " left";
      world.interrupt_with = signal;
      done = run(explore(kEndless), world);
    });
    if (signal == SIGINT) {
      EXPECT_EQ(done.exit_code, 130) << done.err;
      EXPECT_GE(recorded().explorations.size(), 1U);
    } else {
      EXPECT_NE(done.exit_code, 0);
    }
    EXPECT_NE(emulated.out.find("At the end, 0 of 1 servos were on.\n"), std::string::npos)
        << "signal " << signal << "\n"
        << emulated.out << done.err;
  }
}

// The keys arrive from a terminal, again and again until the program ends.
TEST_F(Device, IsSwitchedOffByTheStopKey) {
  for (const std::string key : {" ", "\\033"}) {
    ProgramRun done;
    const ProgramRun emulated = with_probe("ssc32", [&] {
      std::string words = program();
      for (const std::string& word : explore(kEndless)) words += " " + word;
      done = run_other({"sh", "-c",
                        "while printf '" + key + "'; do sleep 0.2; done | script -qec '" + words +
                            "' /dev/null"});
    });
    EXPECT_EQ(done.exit_code, 130) << done.out << done.err;
    EXPECT_NE(emulated.out.find("At the end, 0 of 1 servos were on.\n"), std::string::npos);
  }
}

TEST_F(Device, StopsWhenTheDiskIsFull) {
  for (const std::string& bus : names_of_buses()) {
    SCOPED_TRACE(bus);
    ProgramRun done;
    const ProgramRun emulated = with_probe(bus, [&] {
      ProgramWorld world;
      world.largest_file = 300;
      done = run(explore("1"), world);
    });
    EXPECT_NE(done.exit_code, 0);
    EXPECT_NE(done.err.find("felt.mcap"), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(path("felt.mcap")));
    EXPECT_NE(emulated.out.find("At the end, 0 of 1 servos were on.\n"), std::string::npos)
        << emulated.out << emulated.err;
  }
}

TEST_F(Device, MonitorPrintsWhatIsMeasured) {
  with_probe("sts", [&] {
    const std::string shown = output_of({"device", "monitor", "d.toml", "--seconds", "2"});
    EXPECT_NE(shown.find("stick"), std::string::npos) << shown;
    EXPECT_NE(shown.find("potentiometer"), std::string::npos) << shown;
    EXPECT_EQ(shown.find('\033'), std::string::npos);
  });
}

TEST_F(Device, CalibrateWritesTheFile) {
  with_probe("sts", [&] {
    const std::string before = read("d.toml");
    write("said", "+ 2\nzero\n+ 3\nat 6\nnonsense\nquit\n");
    ProgramWorld world;
    world.input_from = path("said");
    const ProgramRun unchanged = run({"device", "calibrate", "d.toml", "--servo", "stick"}, world);
    EXPECT_EQ(unchanged.exit_code, 0) << unchanged.err;
    EXPECT_NE(unchanged.out.find("The file is unchanged."), std::string::npos) << unchanged.out;
    EXPECT_NE(unchanged.out.find("This is not possible here."), std::string::npos);
    EXPECT_EQ(read("d.toml"), before);
    write("said", "+ 2\nzero\n+ 3\nat 6\nsave\n");
    const ProgramRun saved = run({"device", "calibrate", "d.toml", "--servo", "stick"}, world);
    EXPECT_EQ(saved.exit_code, 0) << saved.err;
    // It stood at 5 mm, 2047 on the bus with 360 steps per mm: 2767 at 7 mm, and what were 3 mm
    // further are 6 mm.
    EXPECT_NE(read("d.toml").find("scale = 180\n"), std::string::npos) << read("d.toml");
    EXPECT_NE(read("d.toml").find("zero = 2767\n"), std::string::npos) << read("d.toml");
  });
}

TEST_F(Device, RefusesWhatIsNoDevice) {
  expect_refused(1, {{{"device", "check", "none.toml"}, {"none.toml: cannot open"}}});
  write("empty.toml", "name = \"x\"\n");
  write("typo.toml",
        "name = \"x\"\n[servos]\nbus = \"sts\"\nport = \"/dev/none\"\n[servo.a]\nchanel = 1\n");
  write("gone.toml",
        "name = \"x\"\nexplore = \"holding\"\n[frames]\nformat = \"lines\"\n"
        "port = \"/dev/none\"\nelements = 1\n[sensor.a]\nfrom = \"frames\"\nelements = [\"a\"]\n");
  expect_refused(2, {{{"device", "check", "typo.toml"}, {"typo.toml:6", "channel"}}});
  expect_refused(1, {{{"device", "check", "gone.toml"}, {"/dev/none", "No such file"}},
                     {{"device", "check", "gone.toml", "--reboot"}, {"/dev/none"}}});
  expect_refused(2, {{{"explore", "--device", "gone.toml", "--body", "lucs2", "-o", "x.mcap"},
                      {"--body", "no effect with --device"}},
                     {{"explore", "--device", "gone.toml", "--seed", "3", "-o", "x.mcap"},
                      {"--seed", "no effect with --device"}},
                     {{"emulate", "--body", "probes", "-o", "d.toml"}, {"only one body"}},
                     {{"emulate", "--body", "lucs3", "--bus", "scc32", "-o", "d.toml"},
                      {"--bus", "did you mean 'ssc32'"}}});
}

TEST_F(Device, NamesTheBoardThatIsNotTheDeclaredOne) {
  with_probe("dynamixel", [&] {
    std::string text = read("d.toml");
    text.replace(text.find("\"dynamixel\""), 11, "\"sts\"");
    write("d.toml", text);
    const ProgramRun done = run({"device", "check", "d.toml"});
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("does not answer"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("check its power"), std::string::npos) << done.err;
  });
}

}  // namespace
}  // namespace somato
