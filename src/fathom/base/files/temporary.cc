// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/temporary.h"

#include "fathom/base/input_error.h"

#include <csignal>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// All temporaries that exist. Never destroyed: the thread that waits for signals outlives main().
struct Registry {
  std::mutex mutex;
  std::multiset<fs::path> paths;
};
Registry& TheRegistry() {
  static auto* const registry = new Registry;
  return *registry;
}

fs::path Resolved(const fs::path& place) {
  std::error_code error;
  if (!fs::is_symlink(place, error)) return place;
  const fs::path target = fs::weakly_canonical(place, error);
  return error ? place : target;
}

fs::path NameBeside(const fs::path& place) {
  fs::path name = place.stem();
  name += ".part" + std::to_string(getpid());
  name += place.extension();  // some writers go by it
  return place.parent_path() / name;
}

void WaitAndRemove(sigset_t signals) {
  int signal = 0;
  if (sigwait(&signals, &signal) != 0) return;
  Registry& registry = TheRegistry();
  // Held to the end: nothing takes its place, and no temporary is made, while these go.
  const std::lock_guard lock(registry.mutex);
  for (const fs::path& path : registry.paths) {
    std::error_code error;
    // Once more where another thread has put a file into the folder meanwhile.
    for (int i = 0; i < 100 && fs::exists(path, error); ++i) fs::remove_all(path, error);
  }
  // Ends as it would have without this thread, for whoever asks why.
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  raise(signal);
}

}  // namespace

Temporary::Temporary(const fs::path& place)
    : named_(place), place_(Resolved(place)), path_(NameBeside(place_)) {
  Registry& registry = TheRegistry();
  const std::lock_guard lock(registry.mutex);
  registry.paths.insert(path_);
}

Temporary::~Temporary() {
  Registry& registry = TheRegistry();
  const std::lock_guard lock(registry.mutex);
  std::error_code error;
  fs::remove_all(path_, error);
  registry.paths.erase(registry.paths.find(path_));
}

void Temporary::TakePlace() const {
  const std::lock_guard lock(TheRegistry().mutex);
  std::error_code error;
  const bool is_folder = fs::is_directory(path_, error);
  if (is_folder) fs::remove_all(place_, error);
  if (!error) fs::rename(path_, place_, error);
  if (!error) return;
  throw InputError(named_.string() + ": cannot write this " + (is_folder ? "folder" : "file") +
                   ": " + error.message() + ".");
}

void RemoveTemporariesOnInterrupt() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    sigaddset(&signals, signal);
  }
  if (pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) return;
  std::thread(WaitAndRemove, signals).detach();
}

}  // namespace fathom
