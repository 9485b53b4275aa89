// Runs a case once for each line on the standard input, and answers each line with a line of JSON:
// bench/run.py alternates between this program and the other programs.
//
//     workloads list --scale N                        the cases, as JSON
//     workloads sets                                  the instruction sets of this machine, as JSON
//     workloads write CASE FOLDER --scale N           samples.npy and initial.npy of the case
//     workloads write-large FILE ROWS COLUMNS         a file of uniform numbers
//     workloads serve CASE --scale N --threads N --set NAME
//
// Lines: `run` trains or searches once, `weights FILE` saves the map of the last run, `quit` ends.

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/core/dense_rows.h"
#include "base/kernels/instruction_set.h"
#include "job.h"
#include "somato/files/npy.h"
#include "somato/maps/som_training.h"
#include "t_mpsom_job.h"
#include "workload_list.h"

namespace somato::bench {
namespace {

struct CommandLine {
  std::vector<std::string> words;
  std::map<std::string, std::string> flags;

  std::size_t number(const std::string& flag, std::size_t otherwise) const {
    const auto found = flags.find(flag);
    return found == flags.end() ? otherwise : std::stoul(found->second);
  }
};

CommandLine read_command_line(std::span<char*> arguments) {
  CommandLine line;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string word = arguments[i];
    if (word.starts_with("--") && i + 1 < arguments.size()) {
      line.flags[word.substr(2)] = arguments[++i];
    } else {
      line.words.push_back(word);
    }
  }
  return line;
}

// Reads the peak of this program only: getrusage() includes the program that started it.
long peak_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:" && status >> word) return std::stol(word);
  }
  return 0;
}

template <typename T>
T value_or_end(Result<T> result) {
  if (result) return std::move(*result);
  std::cerr << to_string(result.error()) << '\n';
  std::exit(1);
}

Workload workload_of(const CommandLine& line) {
  for (Workload& workload : all_workloads(line.number("scale", 1))) {
    if (workload.name == line.words.at(1)) return std::move(workload);
  }
  std::cerr << "no case '" << line.words.at(1) << "'\n";
  std::exit(2);
}

// How many elements of its inputs the map of a case keeps weights for.
std::size_t stored_elements(const Workload& workload) {
  if (workload.kind != DataKind::kSparse) return workload.features;
  return value_or_end(untrained_som(workload.parameters, make_samples(workload)))
      .elements()
      .count();
}

void print_list(std::size_t scale) {
  std::string separator = "[";
  for (const Workload& w : all_workloads(scale)) {
    const SomParameters p = value_or_end(resolve(w.parameters, w.samples, w.features));
    fmt::print(
        R"({}{{"name": "{}", "samples": {}, "features": {}, "rows": {}, "columns": {}, )"
        R"("hexagonal": {}, "batch": {}, "sparse": {}, "steps": {}, "stored": {}, "radius_start": {}, )"
        R"("radius_end": {}, "learning_rate_start": {}, "learning_rate_end": {}}})",
        separator, w.name, w.samples, w.features, *p.rows, *p.columns,
        p.lattice == Lattice::kHexagonal, w.is_batch(), w.kind == DataKind::kSparse, p.steps(),
        stored_elements(w), *p.radius_start, *p.radius_end, p.learning_rate_start,
        p.learning_rate_end);
    separator = ",\n ";
  }
  for (const std::string name : {"t_mpsom", "t_mpsom_large"}) {
    const TMpsomParameters p = t_mpsom_parameters(name, scale).value();
    std::size_t elements = 0;
    for (const std::size_t size : p.input_sizes) elements += size;
    fmt::print(R"({}{{"name": "{}", "weights": {}, "steps": {}}})", separator, name,
               p.neurons() * elements, p.iterations);
  }
  fmt::print("]\n");
}

void print_sets() {
  std::string separator = "[";
  for (const InstructionSet set : available_instruction_sets()) {
    fmt::print("{}\"{}\"", std::exchange(separator, ", "), name_of(set));
  }
  fmt::print("]\n");
}

void write_case(const Workload& workload, const std::string& folder) {
  const Samples samples = make_samples(workload);
  value_or_end(write_npy(folder + "/samples.npy", dense_rows(samples)).map([] { return 0; }));
  value_or_end(
      write_npy(folder + "/initial.npy", initial_weights(workload, samples)).map([] { return 0; }));
}

void choose_set(const std::string& name) {
  for (const auto& [set, its_name] : named_instruction_sets()) {
    if (its_name == name) use_instruction_set(set);
  }
}

void answer_run(Job& job) {
  const double begin = now();
  const double seconds_of_part = job.run();
  const double seconds = seconds_of_part > 0.0 ? seconds_of_part : now() - begin;
  fmt::print(R"({{"seconds": {:.9f}, "peak_kib": {}, "set": "{}"}})", seconds, peak_kib(),
             name_of(instruction_set()));
}

void answer_weights(const Job& job, const std::string& path) {
  value_or_end(write_npy(path, job.weights()).map([] { return 0; }));
  fmt::print(R"({{"written": true}})");
}

std::unique_ptr<Job> job_of(const CommandLine& line) {
  if (const auto parameters = t_mpsom_parameters(line.words.at(1), line.number("scale", 1))) {
    return make_t_mpsom_job(*parameters);
  }
  return make_job(workload_of(line), line.number("threads", 1));
}

int serve(const CommandLine& line) {
  if (const auto set = line.flags.find("set"); set != line.flags.end()) choose_set(set->second);
  const std::unique_ptr<Job> job = job_of(line);
  fmt::print("{{\"ready\": true}}\n");
  std::fflush(stdout);
  for (std::string command; std::getline(std::cin, command) && command != "quit";) {
    if (command.starts_with("weights ")) {
      answer_weights(*job, command.substr(8));
    } else {
      answer_run(*job);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  return 0;
}

int run(const CommandLine& line) {
  const std::string what = line.words.empty() ? "" : line.words[0];
  if (what == "serve") return serve(line);
  if (what == "list") return print_list(line.number("scale", 1)), 0;
  if (what == "sets") return print_sets(), 0;
  if (what == "write") return write_case(workload_of(line), line.words.at(2)), 0;
  if (what == "write-large") {
    const auto rows = std::stoul(line.words.at(2));
    const auto columns = std::stoul(line.words.at(3));
    return value_or_end(write_large_npy(line.words.at(1), rows, columns).map([] { return 0; }));
  }
  std::cerr << "workloads: list, sets, write, write-large or serve\n";
  return 2;
}

}  // namespace
}  // namespace somato::bench

int main(int count, char** arguments) {
  return somato::bench::run(
      somato::bench::read_command_line({arguments, static_cast<std::size_t>(count)}));
}
