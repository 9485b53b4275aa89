#include "base/mpi/joined_processes.h"

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace somato {
namespace {

// MPI counts elements with 32 bits, and needs memory for those that it combines.
constexpr std::size_t kAtOnce = std::size_t{1} << 22;

// Errors of MPI end all processes.
class MpiProcesses final : public JoinedProcesses {
 public:
  MpiProcesses() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &on_this_machine_);
    MPI_Comm_free(&machine);
  }

  std::size_t rank() const override { return static_cast<std::size_t>(rank_); }
  std::size_t size() const override { return static_cast<std::size_t>(size_); }
  std::size_t on_this_machine() const override {
    return static_cast<std::size_t>(on_this_machine_);
  }

  void sum(std::span<std::int64_t> values) override { reduce(values, MPI_INT64_T, MPI_SUM); }
  void maximize(std::span<double> values) override { reduce(values, MPI_DOUBLE, MPI_MAX); }

  void bring_to_first(std::size_t process, std::span<char> bytes) override {
    const auto sender = static_cast<int>(process);
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), kAtOnce))) {
      const auto count = static_cast<int>(std::min(bytes.size(), kAtOnce));
      if (rank_ == sender) MPI_Send(bytes.data(), count, MPI_CHAR, 0, 0, MPI_COMM_WORLD);
      if (rank_ == 0) {
        MPI_Recv(bytes.data(), count, MPI_CHAR, sender, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      }
    }
  }

  void leave() override { MPI_Finalize(); }
  void end_all(int exit_code) override { MPI_Abort(MPI_COMM_WORLD, exit_code); }

 private:
  template <typename T>
  static void reduce(std::span<T> values, MPI_Datatype type, MPI_Op operation) {
    while (!values.empty()) {
      const std::size_t count = std::min(values.size(), kAtOnce);
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(count), type, operation,
                    MPI_COMM_WORLD);
      values = values.subspan(count);
    }
  }

  int rank_ = 0;
  int size_ = 1;
  int on_this_machine_ = 1;
};

}  // namespace
}  // namespace somato

extern "C" somato::JoinedProcesses* somato_join_processes() {
  static somato::MpiProcesses processes;
  return &processes;
}
