#include "som/processes.h"

#include <dlfcn.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "som/data.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

// Set by the launchers of MPICH (also that of Slurm) and Open MPI.
constexpr const char* kSizes[] = {"PMI_SIZE", "OMPI_COMM_WORLD_SIZE"};
constexpr const char* kLibrary = "libsomato_mpi.so";
constexpr const char* kFoldersFromProgram[] = {"", SOMATO_LIBRARY_FOLDER};

std::size_t launched_processes() {
  for (const char* name : kSizes) {
    const char* const text = std::getenv(name);
    if (!text) continue;
    std::size_t size = 1;
    const std::string_view digits(text);
    std::from_chars(digits.data(), digits.data() + digits.size(), size);
    return size;
  }
  return 1;
}

JoinProcesses find_library() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* folder : kFoldersFromProgram) {
    const auto path = program / folder / kLibrary;
    if (!std::filesystem::exists(path, ignored)) continue;
    // Global: libraries of MPI load further ones that use their names.
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (!library) continue;
    return reinterpret_cast<JoinProcesses>(dlsym(library, kJoinProcesses));
  }
  return nullptr;
}

JoinedProcesses* joined = nullptr;

// The exit code has been given to the launcher by then, which ends the others.
void end_others() {
  std::fflush(nullptr);
  if (joined) joined->end_all(EXIT_FAILURE);
}

}  // namespace

Result<Processes> Processes::join() {
  Processes processes;
  if (launched_processes() < 2) return processes;
  const JoinProcesses join = find_library();
  if (!join) {
    return fail(ErrorKind::kSystem,
                "several processes were started, but this program was built without MPI", {},
                "start one process, or build Somato where MPI is installed (docs/clusters.md)");
  }
  processes.group_ = joined = join();
  std::atexit(end_others);
  if (!processes.group_->is_first()) be_quiet();
  log_progress();  // the launcher connects standard error to a pipe
  return processes;
}

Result<void> Processes::leave(Result<void> done) const {
  if (!group_ || (!done && !group_->has_failed())) return done;
  // The first process reports the failure of all.
  if (!done && !group_->is_first()) std::freopen("/dev/null", "w", stderr);
  joined->leave();
  joined = nullptr;
  return done;
}

Result<std::size_t> threads_of(const Arguments& arguments, const JoinedProcesses* processes) {
  const bool divided = processes && !arguments.has("threads");
  return read_threads(arguments).map([&](std::size_t threads) {
    return divided ? std::max<std::size_t>(threads / processes->on_this_machine(), 1) : threads;
  });
}

Result<void> refuse_several_processes(const std::string& command) {
  if (launched_processes() < 2) return {};
  return fail(
      ErrorKind::kUsage, "the command runs in one process only", command,
      "start it without mpiexec; 'som train', 'som quality' and 'som map' share their rows");
}

}  // namespace somato::program
