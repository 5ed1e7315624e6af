// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/process/run_child.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <optional>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <glog/logging.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

// One end of a pipe, or a process, closed in the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { Close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void Close() {
    if (is_open()) close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor read;
  Descriptor write;
};

Pipe MakePipe() {
  std::array<int, 2> ends = {-1, -1};
  PCHECK(pipe2(ends.data(), O_CLOEXEC) == 0);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

// Beyond the limit there is a signal or a failed request; one unit beyond that, SIGKILL.
void SetLimit(int resource, double value) {
  if (!std::isfinite(value)) return;
  const auto most = static_cast<rlim_t>(std::ceil(value));
  const rlimit limit = {most, most + 1};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

// In the child, which shares its parent's memory: only calls to the system, and nothing is changed.
// Does not return.
[[noreturn]] void BecomeProgram(
    const ChildCommand& command, char* const* argv, pid_t parent, int out, int err, int failure) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it died before it could be heard of
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  SetLimit(RLIMIT_CPU, command.limits.cpu_time);
  if (kLimitsMemory) SetLimit(RLIMIT_AS, command.limits.memory);
  SetLimit(RLIMIT_CORE, 0.0);
  const int empty = open("/dev/null", O_RDONLY);
  if (empty >= 0 && dup2(empty, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
      dup2(err, STDERR_FILENO) >= 0) {
    execvp(command.program.c_str(), argv);
  }
  const int error = errno;
  [[maybe_unused]] const auto written = write(failure, &error, sizeof error);
  _exit(127);
}

// Reads what is there; keeps the last `most` bytes. Closes the pipe at its end.
void Drain(Descriptor* pipe, std::size_t most, std::string* text) {
  std::array<char, 65536> buffer;
  const ssize_t n = read(pipe->number(), buffer.data(), buffer.size());
  if (n < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (n <= 0) {
    pipe->Close();
    return;
  }
  text->append(buffer.data(), static_cast<std::size_t>(n));
  if (text->size() > 2 * most) text->erase(0, text->size() - most);
}

void SetNonBlocking(const Descriptor& pipe) {
  PCHECK(fcntl(pipe.number(), F_SETFL, O_NONBLOCK) == 0);
}

// The most address space that a living process has had [bytes]; 0 if that is not known.
double PeakAddressSpace(pid_t pid) {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmPeak:")) return 1024.0 * std::strtod(line.c_str() + 7, nullptr);
  }
  return 0.0;
}

// Whether the child has ended; it stays to be waited for.
bool HasEnded(pid_t pid) {
  siginfo_t info = {};
  while (waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) != 0) {
    PCHECK(errno == EINTR);
  }
  return info.si_pid == pid;
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Watch {
  bool was_killed = false;          // at its limit of wall time
  double peak_address_space = 0.0;  // as far as it was seen [bytes]
};

// Takes in what the child writes until it ends, or is killed because its time is over.
Watch WatchUntilItEnds(pid_t pid,
                       const ChildCommand& command,
                       Clock::time_point start,
                       Descriptor* out,
                       Descriptor* err,
                       ChildResult* result) {
  Watch watch;
  const double limit = command.limits.wall_time;
  // The pipes close a little before the child has ended: it is waited for by itself. The header of
  // pidfd_open() is not for C++ in glibc 2.36.
  const Descriptor end(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
  for (int pause_ms = 1; !HasEnded(pid); pause_ms = std::min(2 * pause_ms, 20)) {
    if (std::isfinite(command.limits.memory)) {
      watch.peak_address_space = std::max(watch.peak_address_space, PeakAddressSpace(pid));
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds > limit && !watch.was_killed) {
      kill(-pid, SIGKILL);
      watch.was_killed = true;
    }
    std::array<pollfd, 3> polled = {pollfd{out->number(), POLLIN, 0},
                                    pollfd{err->number(), POLLIN, 0},
                                    pollfd{end.number(), POLLIN, 0}};
    // Of a closed pipe the number is below 0, which poll() passes over.
    if (poll(polled.data(), polled.size(), pause_ms) <= 0) continue;
    if (polled[0].revents != 0) Drain(out, command.most_output, &result->out);
    if (polled[1].revents != 0) Drain(err, command.most_output, &result->err);
  }
  return watch;
}

void KeepLast(std::size_t most, std::string* text) {
  if (text->size() > most) text->erase(0, text->size() - most);
}

ChildEnd EndOf(const ChildResult& result, const Watch& watch, const ChildLimits& limits) {
  constexpr double kNear = 0.8;  // of the limit; what a failed request asked for is not seen
  if (watch.was_killed || result.signal == SIGXCPU ||
      (result.signal == SIGKILL && result.cpu_seconds > limits.cpu_time)) {
    return ChildEnd::kTimedOut;
  }
  const double memory = std::max(watch.peak_address_space, result.peak_memory);
  if (kLimitsMemory && result.exit_code != 0 && memory >= kNear * limits.memory) {
    return ChildEnd::kOutOfMemory;
  }
  return result.signal != 0 ? ChildEnd::kSignalled : ChildEnd::kExited;
}

// Why the program could not be started; nothing if it was.
std::optional<int> FailureToStart(const Descriptor& pipe) {
  int error = 0;
  ssize_t n = 0;
  do {
    n = read(pipe.number(), &error, sizeof error);
  } while (n < 0 && errno == EINTR);
  if (n == sizeof error) return error;
  return std::nullopt;
}

}  // namespace

ChildResult RunChild(const ChildCommand& command) {
  std::vector<std::string> words = {command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  Pipe out = MakePipe(), err = MakePipe(), failure = MakePipe();
  const auto start = Clock::now();
  const pid_t parent = getpid();
  // The child borrows this process' memory until it becomes the program: a copy would cost more
  // than many a program takes.
  const pid_t pid = vfork();
  PCHECK(pid >= 0);
  if (pid == 0) {
    BecomeProgram(command,
                  argv.data(),
                  parent,
                  out.write.number(),
                  err.write.number(),
                  failure.write.number());
  }
  setpgid(pid, pid);  // here too: it may be killed before it got so far itself
  out.write.Close();
  err.write.Close();
  failure.write.Close();

  ChildResult result;
  const std::optional<int> error = FailureToStart(failure.read);
  if (command.on_start && !error) command.on_start(pid);
  SetNonBlocking(out.read);
  SetNonBlocking(err.read);
  const Watch watch = WatchUntilItEnds(pid, command, start, &out.read, &err.read, &result);
  // What it started and left behind must not go on, nor hold the pipes open.
  kill(-pid, SIGKILL);
  for (Descriptor* pipe : {&out.read, &err.read}) {
    std::string* text = pipe == &out.read ? &result.out : &result.err;
    std::size_t before = 0;
    do {
      before = text->size();
      if (pipe->is_open()) Drain(pipe, command.most_output, text);
    } while (pipe->is_open() && text->size() != before);
    KeepLast(command.most_output, text);
  }
  int status = 0;
  rusage usage = {};
  while (wait4(pid, &status, 0, &usage) < 0) PCHECK(errno == EINTR);

  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  result.cpu_seconds = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
  result.peak_memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
  if (error) {
    result.err = std::strerror(*error);
    return result;
  }
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + result.signal;
  result.end = EndOf(result, watch, command.limits);
  return result;
}

}  // namespace fathom
