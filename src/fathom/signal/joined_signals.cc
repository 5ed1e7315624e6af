// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/joined_signals.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/dof_of_log.h"

#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

void RequireAlike(const Log& log, const Signals& signals, const Signals& first) {
  if (signals.force_unit != first.force_unit || signals.source != first.source) {
    throw InputError(fmt::format(
        "{}: its command unit or source differs from the first log's ({} from {}, expected {} "
        "from {}).",
        log.path.string(),
        signals.force_unit,
        NameInText(signals.source),
        first.force_unit,
        NameInText(first.source)));
  }
}

void NameLogIn(const Log& log, std::vector<std::string>* remarks) {
  for (std::string& remark : *remarks) {
    remark = fmt::format("{}: {}", log.path.filename().string(), remark);
  }
}

template <typename T>
void MoveInto(std::vector<T>* to, std::vector<T> from) {
  for (T& one : from) to->push_back(std::move(one));
}

}  // namespace

JoinedSignals JoinSignals(std::span<const Log> logs,
                          std::optional<Dof> dof,
                          std::optional<Source> source) {
  JoinedSignals joined;
  if (logs.empty()) return joined;
  const Dof common_dof = DofOfAll(logs, dof);
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const Source own_source = source ? *source : BestSourceOf(logs[k], common_dof);
    Signals own = SignalsOf(logs[k], common_dof, {.source = own_source});
    if (logs.size() > 1) NameLogIn(logs[k], &own.remarks);
    if (k == 0) {
      joined.all = std::move(own);
    } else {
      RequireAlike(logs[k], own, joined.all);
      MoveInto(&joined.all.train, std::move(own.train));
      MoveInto(&joined.all.held_out, std::move(own.held_out));
      MoveInto(&joined.all.remarks, std::move(own.remarks));
    }
    joined.log_of_train.resize(joined.all.train.size(), k);
    joined.log_of_held_out.resize(joined.all.held_out.size(), k);
  }
  return joined;
}

}  // namespace fathom
