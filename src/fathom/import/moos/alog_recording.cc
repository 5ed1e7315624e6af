// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/moos/alog_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/table/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr std::size_t kMostVariables = 5000;
constexpr std::size_t kLongestVariable = 1000;  // [bytes] of a name
constexpr std::size_t kMostNamed = 40;          // variables in a remark

// pLogger writes the first seconds twice: variables by name, then all of them. A line is looked for
// among so many first ones.
constexpr std::size_t kMostRemembered = 100000;

constexpr std::string_view kBetweenWords = " \t";

std::string_view WithoutBlanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kBetweenWords), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(kBetweenWords) + 1);
}

// Takes the first word off a line.
std::string_view NextWord(std::string_view* line) {
  *line = WithoutBlanks(*line);
  const std::string_view word = line->substr(0, line->find_first_of(kBetweenWords));
  line->remove_prefix(word.size());
  return word;
}

// The number of a value: NaN for one that is none yet. Nothing for a text.
std::optional<double> AlogNumber(std::string_view value) {
  for (const std::string_view none : {"nan", "-nan", "inf", "-inf"}) {
    if (value == none) return std::numeric_limits<double>::quiet_NaN();
  }
  return ParseFiniteNumber(value);
}

// What the lines say of the file itself.
struct AlogWalk {
  std::optional<double> start;       // LOGSTART [s since 1970]
  std::optional<double> first_time;  // of the first sound line
  std::size_t num_repeated = 0;
  std::size_t num_unsound = 0;
  std::uint64_t unsound_bytes = 0;
  std::uint64_t first_unsound = 0;  // where the first such line begins
  std::uint64_t end = 0;            // up to here the file was walked over
};

// `take(variable, time, value)`: of each sound line, once.
template <typename Take>
AlogWalk ForEachAlogLine(const std::filesystem::path& path, const Take& take) {
  ByteFile file(path);
  TextLines lines(&file);
  AlogWalk walk;
  std::unordered_set<std::size_t> seen;
  bool is_marked = false;  // numbers are written D:1.5, texts S:words
  const auto next = [&] {
    try {
      return lines.Next();
    } catch (const InputError&) {  // no text from here on
      return false;
    }
  };
  while (next() && lines.has_end()) {
    std::string_view rest = WithoutBlanks(lines.text());
    const std::uint64_t offset = lines.offset();
    walk.end = lines.next_offset();
    if (rest.empty()) continue;
    if (rest.front() == '%') {
      is_marked = is_marked || rest == "%% DATATYPE MARKING ON";
      NextWord(&rest);
      if (NextWord(&rest) == "LOGSTART" && !walk.start) {
        walk.start = ParseFiniteNumber(WithoutBlanks(rest));
      }
      continue;
    }
    const std::size_t hash = std::hash<std::string_view>()(rest);
    const auto time = ParseFiniteNumber(NextWord(&rest));
    const std::string_view variable = NextWord(&rest);
    const std::string_view source = NextWord(&rest);
    if (!time || source.empty() || variable.size() > kLongestVariable) {
      if (walk.num_unsound++ == 0) walk.first_unsound = offset;
      walk.unsound_bytes += walk.end - offset;
      continue;
    }
    if (seen.contains(hash)) {
      ++walk.num_repeated;
      continue;
    }
    if (seen.size() < kMostRemembered) seen.insert(hash);
    if (!walk.first_time) walk.first_time = time;
    rest = WithoutBlanks(rest);
    if (is_marked && rest.starts_with("D:")) rest.remove_prefix(2);
    take(variable, *time, rest);
  }
  return walk;
}

// Some logs have stamps since 1970, as MOOS-IvP's own tools know: LOGSTART is then one of them.
std::optional<double> UtcOfZero(const AlogWalk& walk) {
  constexpr double kEarliest = 1e8;  // [s since 1970]: nobody dived before 1973
  constexpr double kClose = 1000.0;  // [s] that a log may hold from before its start
  const bool is_utc = walk.start && walk.first_time && *walk.first_time > kEarliest &&
                      *walk.first_time > *walk.start - kClose;
  return is_utc ? 0.0 : walk.start;
}

struct AlogVariable {
  ChannelStamps numbers;
  std::size_t num_texts = 0;
};

// "<begin>MODE 3, APPCAST 40.", cut after 40 variables; nothing if there is none.
void TellVariables(std::string_view begin,
                   std::vector<std::string> counts,
                   std::vector<std::string>* remarks) {
  if (counts.empty()) return;
  const std::size_t num_more = counts.size() - std::min(counts.size(), kMostNamed);
  counts.resize(counts.size() - num_more);
  if (num_more > 0) counts.push_back(fmt::format("{} more", num_more));
  remarks->push_back(fmt::format("{}{}.", begin, fmt::join(counts, ", ")));
}

class AlogRecording final : public Recording {
 public:
  explicit AlogRecording(const std::filesystem::path& path);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  std::filesystem::path path_;
  Contents contents_;
};

AlogRecording::AlogRecording(const std::filesystem::path& path) : path_(path) {
  std::map<std::string, AlogVariable, std::less<>> variables;
  std::size_t num_others = 0;
  const AlogWalk walk =
      ForEachAlogLine(path, [&](std::string_view name, double time, std::string_view value) {
        auto at = variables.find(name);
        if (at == variables.end() && variables.size() < kMostVariables) {
          at = variables.emplace(name, AlogVariable()).first;
        }
        if (at == variables.end()) {
          ++num_others;
        } else if (AlogNumber(value)) {
          at->second.numbers.Add(time);
        } else {
          ++at->second.num_texts;
        }
      });
  contents_.format = "alog";
  contents_.size_bytes = ByteFile(path).size();
  contents_.read_bytes = walk.end - walk.unsound_bytes;
  contents_.utc_of_zero = UtcOfZero(walk);
  std::vector<std::string> mixed, texts;
  for (const auto& [name, variable] : variables) {
    Channel channel;
    variable.numbers.WriteTo(&channel);
    if (channel.count == 0) {
      texts.push_back(fmt::format("{} {}", Printable(name), variable.num_texts));
      continue;
    }
    if (variable.num_texts > 0) {
      mixed.push_back(fmt::format(
          "{} {} of {}", Printable(name), variable.num_texts, variable.num_texts + channel.count));
    }
    channel.name = name;
    channel.type = "double";
    channel.fields = {{"value", ""}};
    contents_.channels.push_back(std::move(channel));
  }
  if (contents_.channels.empty()) {
    throw InputError(path.string() +
                     ": holds no line with a number, expected an .alog of MOOS, whose lines are "
                     "'time variable source value'.");
  }
  auto& remarks = contents_.remarks;
  if (walk.num_unsound > 0) {
    remarks.push_back(
        fmt::format("{} not of the form 'time variable source value', the first at byte {}: "
                    "passed over.",
                    Plural(walk.num_unsound, "line"),
                    walk.first_unsound));
  }
  if (walk.end < contents_.size_bytes) {
    remarks.push_back(
        fmt::format("the log is cut or damaged at byte {}: what is before it is read.", walk.end));
  }
  if (!walk.start) {
    remarks.emplace_back("there is no LOGSTART in seconds: the UTC of the stamps is not known.");
  }
  TellVariables("values that are texts are not read: ", std::move(mixed), &remarks);
  TellVariables("variables of texts alone are not read: ", std::move(texts), &remarks);
  if (num_others > 0) {
    remarks.push_back(fmt::format("{} of further variables than the first {} are not read.",
                                  Plural(num_others, "line"),
                                  kMostVariables));
  }
  if (walk.num_repeated > 0) {
    remarks.push_back(
        Plural(walk.num_repeated, "line") +
        " of the same time, variable, source and value as an earlier one: read once.");
  }
}

std::vector<std::string> AlogRecording::Read(std::span<const Selection> selections,
                                             const SampleSink& sink) const {
  std::map<std::string, std::vector<std::size_t>, std::less<>> wanted;  // selections by variable
  for (std::size_t i = 0; i < selections.size(); ++i) {
    wanted[FindChannel(contents_, path_, selections[i]).name].push_back(i);
  }
  std::vector<double> values;
  ForEachAlogLine(path_, [&](std::string_view name, double time, std::string_view value) {
    const auto at = wanted.find(name);
    if (at == wanted.end()) return;
    const auto number = AlogNumber(value);
    if (!number) return;
    for (const std::size_t i : at->second) {
      values.assign(selections[i].fields.size(), *number);
      sink(i, time, values);
    }
  });
  return {};
}

}  // namespace

bool LooksLikeAlog(std::string_view first_bytes) {
  const auto has = [&](std::string_view text) {
    return first_bytes.find(text) != std::string_view::npos;
  };
  // The table of the same logger (.slog) has the same head, and its columns behind it.
  return first_bytes.starts_with("%%") && (has("%% LOGSTART") || has("%% LOG FILE:")) &&
         !has("\n%%   (1) TIME");
}

std::unique_ptr<Recording> OpenAlog(const std::filesystem::path& path) {
  return std::make_unique<AlogRecording>(path);
}

}  // namespace fathom
