// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sampled_profile.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <utility>

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fmt/format.h>
#include <sys/time.h>

namespace fathom {
namespace {

constexpr int kDeepest = 48;
constexpr int kMostSamples = 50000;
constexpr int kMicroseconds = 2000;  // between samples, if the system's clock is as fine

// Filled by the signal handler, which must not allocate.
struct Sample {
  std::array<void*, kDeepest> frames;
  int depth = 0;
};
Sample* g_samples = nullptr;
volatile std::sig_atomic_t g_num_samples = 0;

void TakeSample(int /*signal*/) {
  if (g_num_samples >= kMostSamples) return;
  Sample& sample = g_samples[g_num_samples];
  sample.depth = backtrace(sample.frames.data(), kDeepest);
  g_num_samples = g_num_samples + 1;
}

void SetTimer(int microseconds) {
  itimerval interval = {};
  interval.it_interval.tv_usec = interval.it_value.tv_usec = microseconds;
  setitimer(ITIMER_PROF, &interval, nullptr);
}

double CpuTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string NameOf(void* address) {
  Dl_info info = {};
  if (dladdr(address, &info) == 0 || info.dli_sname == nullptr) return "";
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status), std::free);
  return status == 0 ? name.get() : info.dli_sname;
}

// Index of the label that a function belongs to; labels.size() if there is none.
size_t LabelOf(const std::string& function, const std::vector<ProfileLabel>& labels) {
  for (size_t k = 0; k < labels.size(); ++k) {
    for (const std::string& part : labels[k].functions) {
      if (function.find(part) != std::string::npos) return k;
    }
  }
  return labels.size();
}

}  // namespace

SampledProfile::SampledProfile(std::vector<ProfileLabel> stages, std::vector<ProfileLabel> kinds)
    : stages_(std::move(stages)), kinds_(std::move(kinds)) {
  static std::vector<Sample> samples(kMostSamples);
  g_samples = samples.data();
  g_num_samples = 0;
  std::array<void*, 2> warm_up;  // loads what backtrace() needs before a signal does
  backtrace(warm_up.data(), static_cast<int>(warm_up.size()));
}

void SampledProfile::Start() {
  struct sigaction action = {};
  action.sa_handler = TakeSample;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  begin_ = CpuTime();
  SetTimer(kMicroseconds);
}

void SampledProfile::Stop() {
  SetTimer(0);
  duration_ = CpuTime() - begin_;
}

std::vector<std::vector<double>> SampledProfile::Seconds() const {
  std::vector<std::vector<double>> seconds(stages_.size() + 1,
                                           std::vector<double>(kinds_.size() + 1, 0.0));
  std::map<void*, std::pair<size_t, size_t>> known;  // stage and kind of an address
  for (int i = 0; i < g_num_samples; ++i) {
    const Sample& sample = g_samples[i];
    size_t stage = stages_.size(), kind = kinds_.size();
    for (int k = 0; k < sample.depth; ++k) {  // from the innermost
      void* const frame = sample.frames[k];
      auto found = known.find(frame);
      if (found == known.end()) {
        const std::string name = NameOf(frame);
        found =
            known.emplace(frame, std::pair(LabelOf(name, stages_), LabelOf(name, kinds_))).first;
      }
      if (found->second.first < stages_.size()) stage = found->second.first;
      if (kind == kinds_.size()) kind = found->second.second;
    }
    seconds[stage][kind] += duration_ / g_num_samples;
  }
  return seconds;
}

std::string SampledProfile::Table(double count) const {
  const auto seconds = Seconds();
  std::string text = fmt::format("{:24}", "CPU seconds");
  for (const ProfileLabel& kind : kinds_) text += fmt::format("{:>14}", kind.name);
  text += fmt::format("{:>14}{:>14}\n", "other", "all");
  std::vector<double> sums(kinds_.size() + 2, 0.0);
  const auto row = [&](const std::string& name, const std::vector<double>& values) {
    text += fmt::format("{:24}", name);
    for (const double value : values) text += fmt::format("{:14.3f}", value);
    text += "\n";
  };
  for (size_t stage = 0; stage <= stages_.size(); ++stage) {
    std::vector<double> values;
    double sum = 0.0;
    for (const double value : seconds[stage]) {
      values.push_back(value / count);
      sum += value / count;
    }
    values.push_back(sum);
    for (size_t k = 0; k < sums.size(); ++k) sums[k] += values[k];
    row(stage < stages_.size() ? stages_[stage].name : "other", values);
  }
  row("all", sums);
  return text;
}

}  // namespace fathom
