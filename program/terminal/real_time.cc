#include "terminal/real_time.h"

#include <fmt/format.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "somato/core/check.h"

namespace somato::program {
namespace {

const char* const kPermissions =
    "permit both: lines 'USER - rtprio 40' and 'USER - memlock unlimited' in a file of "
    "/etc/security/limits.d, then log in again; LimitRTPRIO=40 and LimitMEMLOCK=infinity in a unit "
    "of systemd; --cap-add SYS_NICE --cap-add IPC_LOCK for a container; or omit '--realtime'";

bool has_capability(unsigned number) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> data{};
  if (syscall(SYS_capget, &header, data.data()) != 0) return false;
  return (data.at(CAP_TO_INDEX(number)).effective & CAP_TO_MASK(number)) != 0;
}

rlim_t limit_of(int resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_cur : 0;
}

std::string text_of(rlim_t limit) {
  return limit == RLIM_INFINITY ? "unlimited" : fmt::format("{}", limit);
}

bool set_priority(int policy, int priority) {
  sched_param parameter{};
  parameter.sched_priority = priority;
  return sched_setscheduler(0, policy, &parameter) == 0;  // of the calling thread
}

// Empty if the threads of this program may have the priority. It is tried out: a group of processes
// may be without a share of real time although its limits permit it.
std::string problem_of_priority() {
  if (set_priority(SCHED_FIFO, kRealTimePriority)) {
    require(set_priority(SCHED_OTHER, 0), "the ordinary priority cannot be refused");
    return {};
  }
  return fmt::format("the priority {} is refused ({}): RLIMIT_RTPRIO is {}, and CAP_SYS_NICE is {}",
                     kRealTimePriority, std::generic_category().message(errno),
                     text_of(limit_of(RLIMIT_RTPRIO)),
                     has_capability(CAP_SYS_NICE) ? "given" : "missing");
}

// With a limit, an allocation would fail later, during the session.
std::string problem_of_memory() {
  const rlim_t limit = limit_of(RLIMIT_MEMLOCK);
  if (limit == RLIM_INFINITY || has_capability(CAP_IPC_LOCK)) return {};
  return fmt::format(
      "the memory cannot be locked: RLIMIT_MEMLOCK is {} bytes instead of unlimited, and "
      "CAP_IPC_LOCK is missing",
      limit);
}

}  // namespace

Result<void> prepare_real_time() {
  std::string problem = problem_of_priority();
  const std::string of_memory = problem_of_memory();
  if (!problem.empty() && !of_memory.empty()) problem += "; ";
  problem += of_memory;
  if (problem.empty() && mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    problem =
        fmt::format("the memory cannot be locked: {}", std::generic_category().message(errno));
  }
  if (problem.empty()) return {};
  return fail(ErrorKind::kSystem, std::move(problem), "--realtime", kPermissions);
}

void take_real_time_priority() {
  require(set_priority(SCHED_FIFO | SCHED_RESET_ON_FORK, kRealTimePriority),
          "the real-time priority was refused after it had been permitted");
}

}  // namespace somato::program
