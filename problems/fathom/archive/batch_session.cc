// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/batch_session.h"

namespace fathom {

RunBook BookOf(BatchSession* session) {
  return {.find =
              [session](const std::string& key) {
                const std::lock_guard lock(session->mutex);
                return session->store->FindRun(key);
              },
          .keep =
              [session](const RunRecord& run) {
                const std::lock_guard lock(session->mutex);
                session->store->KeepRun(run);
              }};
}

}  // namespace fathom
