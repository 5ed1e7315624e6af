// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

// Before a function that computes with numbers that carry derivatives: GCC leaves each operation on
// them as a call otherwise, which takes three times as long. With a sanitizer's checks in each of
// them it would compile for ten minutes. Such a function stays one by itself inside another.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define FATHOM_FLATTENED [[gnu::flatten, gnu::noinline]]
#else
#define FATHOM_FLATTENED
#endif
