// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_definition.h"

#include <string_view>

namespace fathom {

// From the description that a stream of a pocolog file carries: the type with all types in it as
// Typelib writes them to XML. Padding follows from offsets and sizes; Typelib writes all of it but
// that at the end of the type. A type that is no compound has one member, "value". An alias stands
// for its type, an enum for its number, /base/Time for a time. Throws InputError, naming the type,
// for a text that is no such description, for a type that is not there, holds itself, or cannot be
// written down (opaque types, pointers), and beyond 1000 types.
// Source: typelib/memory_layout.cc of https://github.com/orocos-toolchain/typelib.
MessageDefinition ParseTypelibDefinition(std::string_view type, std::string_view text);

}  // namespace fathom
