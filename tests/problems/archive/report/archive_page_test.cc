// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_page.h"

#include <gtest/gtest.h>
TEST(A, B) {}
