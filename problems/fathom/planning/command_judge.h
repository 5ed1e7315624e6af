// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/wrench_block.h"

#include <vector>

namespace fathom {

// What a search asks of commands, each a sequence of blocks. Not for several threads at once: what
// was computed for one command spares work for the next.
class CommandJudge {
 public:
  virtual ~CommandJudge() = default;

  // How much a command is worth, one that ends before the plan does among them; minus infinity:
  // nothing. Without blocks: what no command is worth.
  virtual double WorthOf(const std::vector<WrenchBlock>& blocks) = 0;

  // Whether a command as long as the plan keeps the limits: for one model, likely to break them,
  // which costs little, and for all.
  virtual bool KeptByOne(const std::vector<WrenchBlock>& blocks) = 0;
  virtual bool KeptByAll(const std::vector<WrenchBlock>& blocks) = 0;

  // As much of a block as there are thrusters for.
  virtual WrenchBlock Given(WrenchBlock block) const { return block; }
};

}  // namespace fathom
