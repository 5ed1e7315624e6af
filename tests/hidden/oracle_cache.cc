// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "oracle_cache.h"

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>

namespace fathom::hidden {
namespace {

constexpr int kOracleVersion = 1;  // to be raised with the oracle's code

class Fingerprint {
 public:
  void Add(double x) { hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211ull; }
  void Add(const std::vector<double>& numbers) {
    for (const double x : numbers) Add(x);
  }
  void Add(const Stream& stream) {
    Add(stream.time);
    for (const auto& column : stream.values) Add(column);
  }
  std::string Text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 14695981039346656037ull + kOracleVersion;
};

std::string FingerprintOf(const HiddenLog& hidden) {
  Fingerprint print;
  print.Add(*hidden.log.command);
  print.Add(*hidden.log.velocity);
  if (hidden.log.pose) print.Add(*hidden.log.pose);
  print.Add(hidden.truth.train_to);
  print.Add(hidden.truth.noise.model.velocity.white_std);
  print.Add(hidden.truth.noise.model.velocity.coloured.std);
  print.Add(hidden.truth.noise.model.disturbance.std);
  for (const ActiveEffect& effect : hidden.truth.model.effects) print.Add(effect.values);
  return print.Text();
}

double Number(std::istream& in) {
  std::string text;
  in >> text;
  return std::strtod(text.c_str(), nullptr);  // "nan" and "inf" too
}

}  // namespace

OracleCache::OracleCache(const std::filesystem::path& file) : file_(file) {
  if (file_.empty()) return;
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string print;
    words >> print;
    OracleAnswer answer;
    answer.baseline_delta_bic = Number(words);
    answer.rival_delta_bic = Number(words);
    answer.chi2_per_sample = Number(words);
    answer.held_out_baseline = Number(words);
    answer.held_out_truth = Number(words);
    answer.seconds = Number(words);
    words >> answer.rival;
    answers_[print] = answer;
  }
}

OracleAnswer OracleCache::Ask(const HiddenLog& hidden) {
  if (file_.empty() || hidden.plan.hidden == HiddenClass::kNothing) return AskOracle(hidden);
  const std::string print = FingerprintOf(hidden);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = answers_.find(print);
    if (found != answers_.end()) return found->second;
  }
  const OracleAnswer answer = AskOracle(hidden);
  const std::lock_guard<std::mutex> lock(mutex_);
  answers_[print] = answer;
  std::ofstream out(file_, std::ios::app);
  out << fmt::format("{} {} {} {} {} {} {} {}\n",
                     print,
                     answer.baseline_delta_bic,
                     answer.rival_delta_bic,
                     answer.chi2_per_sample,
                     answer.held_out_baseline,
                     answer.held_out_truth,
                     answer.seconds,
                     answer.rival);
  return answer;
}

}  // namespace fathom::hidden
