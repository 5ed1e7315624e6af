// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/message/message_definition.h"

namespace fathom {

std::size_t SizeOf(MemberKind kind) {
  switch (kind) {
    case MemberKind::kBool:
    case MemberKind::kInt8:
    case MemberKind::kUint8:
    case MemberKind::kPadding:
      return 1;
    case MemberKind::kInt16:
    case MemberKind::kUint16:
      return 2;
    case MemberKind::kInt32:
    case MemberKind::kUint32:
    case MemberKind::kFloat32:
      return 4;
    case MemberKind::kInt64:
    case MemberKind::kUint64:
    case MemberKind::kFloat64:
    case MemberKind::kTime:
    case MemberKind::kDuration:
    case MemberKind::kMicroseconds:
      return 8;
    case MemberKind::kString:
    case MemberKind::kWideString:
    case MemberKind::kMessage:
      return 0;
  }
  return 0;
}

}  // namespace fathom
