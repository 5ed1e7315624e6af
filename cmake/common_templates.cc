// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_templates.h"

#define FATHOM_TEMPLATE template
#include "common_templates.inc"
#undef FATHOM_TEMPLATE
