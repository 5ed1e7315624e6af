// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/message/message_decoder.h"

#include "fathom/import/recording/number_type.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kCdrHeader = 4;
constexpr std::int64_t kMostListed = 32;  // elements of a sequence
constexpr std::size_t kMostDecodedFields = 500;
constexpr std::size_t kMostEmpty = 10000;

// Reads a message from its first byte to its last.
class Cursor {
 public:
  Cursor(std::string_view message, MessageEncoding encoding)
      : bytes_(message),
        is_cdr_(encoding == MessageEncoding::kCdr),
        has_long_lengths_(encoding == MessageEncoding::kTypelib) {
    if (!is_cdr_) return;
    // 00 00: big endian; 00 01: little endian; other second bytes are newer kinds of either.
    if (bytes_.size() < kCdrHeader || bytes_[0] != 0) {
      is_good_ = false;
      return;
    }
    is_swapped_ = (bytes_[1] & 1) == 0;
    // Of version 2 of CDR numbers of 8 bytes stand at multiples of 4.
    if (static_cast<unsigned char>(bytes_[1]) >= 6) largest_step_ = 4;
    at_ = kCdrHeader;
  }

  bool is_good() const { return is_good_; }

  // A message or one within it begins. Those that take no bytes are few, or the definition is made
  // to have us count for ever.
  void Enter() {
    if (++num_entered_ > bytes_.size() + kMostEmpty) is_good_ = false;
  }

  std::size_t at() const { return at_; }

  template <typename T>
  T Read() {
    Align(sizeof(T));
    if (!Has(sizeof(T))) return T{};
    at_ += sizeof(T);
    return NumberAt<T>(bytes_, at_ - sizeof(T), is_swapped_);
  }

  double Read(NumberType type) {
    const std::size_t size = SizeOf(type);
    Align(size);
    if (!Has(size)) return 0.0;
    at_ += size;
    return NumberAt(type, bytes_, at_ - size, is_swapped_);
  }

  // `count` numbers at once, as ReadNumber() would give them one by one; empty if they are not
  // there, or have their bytes in the other order.
  std::string_view TakeDoubles(std::uint64_t count) {
    if (is_swapped_ || count == 0) return {};
    Align(sizeof(double));
    if (count > BytesLeft() / sizeof(double)) return {};
    const std::string_view taken =
        bytes_.substr(at_, static_cast<std::size_t>(count) * sizeof(double));
    at_ += taken.size();
    return taken;
  }

  // Of a text or a sequence.
  std::uint64_t ReadLength() {
    return has_long_lengths_ ? Read<std::uint64_t>() : Read<std::uint32_t>();
  }

  // Those there are of `count` bytes.
  void SkipPadding(std::uint64_t count) {
    at_ += static_cast<std::size_t>(std::min<std::uint64_t>(count, BytesLeft()));
  }

  // `count` numbers of `size` bytes, each of `align` at most.
  void Skip(std::uint64_t count, std::size_t size, std::size_t align) {
    if (count == 0) return;
    Align(align);
    if (count > BytesLeft() / size) {
      is_good_ = false;
      return;
    }
    at_ += static_cast<std::size_t>(count) * size;
  }

  void SkipText(std::size_t character) { Skip(ReadLength(), character, 1); }

 private:
  std::size_t BytesLeft() const { return bytes_.size() - std::min(at_, bytes_.size()); }

  void Align(std::size_t size) {
    if (!is_cdr_) return;
    const std::size_t step = std::min(size, largest_step_);
    const std::size_t behind = (at_ - kCdrHeader) % step;
    if (behind != 0) at_ += step - behind;
  }

  bool Has(std::size_t count) {
    if (at_ > bytes_.size() || count > bytes_.size() - at_) is_good_ = false;
    return is_good_;
  }

  std::string_view bytes_;
  bool is_cdr_;
  bool has_long_lengths_;
  bool is_swapped_ = false;
  bool is_good_ = true;
  std::size_t largest_step_ = 8;
  std::size_t at_ = 0;
  std::size_t num_entered_ = 0;
};

double ReadNumber(const MessageMember& member, Cursor* cursor) {
  switch (member.kind) {
    case MemberKind::kNumber:
      return cursor->Read(member.number);
    case MemberKind::kTime: {
      const auto seconds = cursor->Read<std::uint32_t>();
      return seconds + 1e-9 * cursor->Read<std::uint32_t>();
    }
    case MemberKind::kDuration: {
      const auto seconds = cursor->Read<std::int32_t>();
      return seconds + 1e-9 * cursor->Read<std::int32_t>();
    }
    case MemberKind::kMicroseconds:
      return static_cast<double>(cursor->Read<std::int64_t>()) / 1e6;
    case MemberKind::kString:
    case MemberKind::kWideString:
    case MemberKind::kPadding:
    case MemberKind::kMessage:
      break;
  }
  return 0.0;
}

bool IsTwoNumbers(MemberKind kind) {
  return kind == MemberKind::kTime || kind == MemberKind::kDuration;
}

// Bytes of a number; 0 of texts and messages. A time is its two halves of 4 bytes each.
std::size_t SizeOf(const MessageMember& member) {
  if (member.kind == MemberKind::kNumber) return SizeOf(member.number);
  return IsTwoNumbers(member.kind) || member.kind == MemberKind::kMicroseconds ? 8 : 0;
}

bool IsTime(MemberKind kind) { return IsTwoNumbers(kind) || kind == MemberKind::kMicroseconds; }

bool HoldsNumbers(MemberKind kind) {
  return kind != MemberKind::kString && kind != MemberKind::kWideString &&
         kind != MemberKind::kPadding;
}

// How many elements the member has in this message.
std::uint64_t CountOf(const MessageMember& member, Cursor* cursor) {
  if (member.length == kNoArray) return 1;
  if (member.length == kSequence) return cursor->ReadLength();
  return static_cast<std::uint64_t>(member.length);
}

void SkipMessage(const MessageDefinition& definition, std::size_t type, Cursor* cursor);

// The elements of a member that nobody asks for.
void SkipElements(const MessageDefinition& definition,
                  const MessageMember& member,
                  std::uint64_t count,
                  Cursor* cursor) {
  if (member.kind == MemberKind::kPadding) {
    cursor->SkipPadding(count);
    return;
  }
  if (const std::size_t size = SizeOf(member); size > 0) {
    cursor->Skip(count, size, IsTwoNumbers(member.kind) ? 4 : size);
    return;
  }
  for (std::uint64_t i = 0; i < count && cursor->is_good(); ++i) {
    const std::size_t before = cursor->at();
    if (member.kind == MemberKind::kMessage) {
      SkipMessage(definition, member.message, cursor);
    } else {
      cursor->SkipText(member.kind == MemberKind::kWideString ? 2 : 1);
    }
    // A message of nothing takes no bytes: any number of them is there at once.
    if (cursor->at() == before) return;
  }
}

void SkipMessage(const MessageDefinition& definition, std::size_t type, Cursor* cursor) {
  cursor->Enter();
  for (const MessageMember& member : definition[type].members) {
    SkipElements(definition, member, CountOf(member, cursor), cursor);
    if (!cursor->is_good()) return;
  }
}

std::string ElementName(const std::string& name, const MessageMember& member, std::uint64_t i) {
  return member.length == kNoArray ? name : fmt::format("{}[{}]", name, i);
}

void ListMessage(const MessageDefinition& definition,
                 std::size_t type,
                 const std::string& prefix,
                 Cursor* cursor,
                 std::vector<Field>* fields) {
  cursor->Enter();
  for (const MessageMember& member : definition[type].members) {
    const std::uint64_t count = CountOf(member, cursor);
    const std::uint64_t num_listed =
        !HoldsNumbers(member.kind) || fields->size() >= kMostDecodedFields
            ? 0
            : std::min<std::uint64_t>(count, member.length == kSequence ? kMostListed : 64);
    for (std::uint64_t i = 0; i < num_listed && cursor->is_good(); ++i) {
      const std::string name = ElementName(prefix + member.name, member, i);
      if (member.kind == MemberKind::kMessage) {
        ListMessage(definition, member.message, name + ".", cursor, fields);
      } else {
        ReadNumber(member, cursor);
        if (!cursor->is_good()) break;
        fields->push_back({name, IsTime(member.kind) ? "s" : "", 0});
      }
    }
    SkipElements(definition, member, count - num_listed, cursor);
    if (!cursor->is_good()) return;
  }
}

}  // namespace

std::vector<Field> NumbersOf(const MessageDefinition& definition,
                             MessageEncoding encoding,
                             std::string_view message) {
  std::vector<Field> fields;
  Cursor cursor(message, encoding);
  ListMessage(definition, 0, "", &cursor, &fields);
  return fields;
}

// What is asked of a message at some place in the tree.
struct MessageDecoder::Plan {
  // A number: an element of a member, and where it goes.
  struct Number {
    std::uint64_t element = 0;
    std::size_t value = 0;
  };
  struct Inner;
  // Of the member of this index, by element.
  struct Member {
    std::size_t index = 0;
    std::vector<Number> numbers;
    std::vector<Inner> messages;

    // Whether each of `count` elements is asked for, once.
    bool AsksForAll(std::uint64_t count) const { return numbers.size() == count && is_each_once; }
    bool is_each_once = true;  // element k is numbers[k]
  };
  std::vector<Member> members;  // by index, only those that something is asked of

  Member& Of(std::size_t index);

  void Add(const MessageDefinition& definition,
           std::size_t type,
           std::string_view path,
           std::size_t value);

  void Decode(const MessageDefinition& definition,
              std::size_t type,
              Cursor* cursor,
              std::vector<double>* values) const;
};

struct MessageDecoder::Plan::Inner {
  std::uint64_t element = 0;
  Plan plan;
};

MessageDecoder::Plan::Member& MessageDecoder::Plan::Of(std::size_t index) {
  const auto place =
      std::lower_bound(members.begin(), members.end(), index, [](const Member& m, std::size_t i) {
        return m.index < i;
      });
  if (place != members.end() && place->index == index) return *place;
  Member member;
  member.index = index;
  return *members.insert(place, std::move(member));
}

void MessageDecoder::Plan::Add(const MessageDefinition& definition,
                               std::size_t type,
                               std::string_view path,
                               std::size_t value) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  std::string_view name = path.substr(0, dot);
  std::uint64_t element = 0;
  if (const std::size_t open = name.find('['); open != std::string_view::npos) {
    std::from_chars(name.data() + open + 1, name.data() + name.size(), element);
    name = name.substr(0, open);
  }
  const auto is_before = [](const auto& entry, std::uint64_t e) { return entry.element < e; };
  const auto& types_members = definition[type].members;
  for (std::size_t i = 0; i < types_members.size(); ++i) {
    if (types_members[i].name != name) continue;
    if (types_members[i].kind == MemberKind::kMessage) {
      if (dot == path.size()) continue;
      std::vector<Inner>& inner = Of(i).messages;
      auto place = std::lower_bound(inner.begin(), inner.end(), element, is_before);
      if (place == inner.end() || place->element != element) {
        place = inner.insert(place, Inner{element, {}});
      }
      place->plan.Add(definition, types_members[i].message, path.substr(dot + 1), value);
    } else {
      std::vector<Number>& numbers = Of(i).numbers;
      numbers.insert(std::lower_bound(numbers.begin(), numbers.end(), element, is_before),
                     {element, value});
      bool* is_each_once = &Of(i).is_each_once;
      *is_each_once = true;
      for (std::size_t k = 0; k < numbers.size(); ++k) *is_each_once &= numbers[k].element == k;
    }
  }
}

void MessageDecoder::Plan::Decode(const MessageDefinition& definition,
                                  std::size_t type,
                                  Cursor* cursor,
                                  std::vector<double>* values) const {
  const auto& types_members = definition[type].members;
  auto wanted = members.begin();
  for (std::size_t i = 0; i < types_members.size() && cursor->is_good(); ++i) {
    const MessageMember& member = types_members[i];
    const std::uint64_t count = CountOf(member, cursor);
    const bool is_double =
        member.kind == MemberKind::kNumber && member.number == NumberType::kFloat64;
    std::uint64_t done = 0;
    if (wanted != members.end() && wanted->index == i) {
      if (is_double && wanted->AsksForAll(count)) {
        const std::string_view raw = cursor->TakeDoubles(count);
        for (; done * sizeof(double) < raw.size(); ++done) {
          (*values)[wanted->numbers[done].value] =
              NumberAt<double>(raw, static_cast<std::size_t>(done) * sizeof(double));
        }
      }
      double number = 0.0;
      for (const Number& asked : std::span(wanted->numbers).subspan(done)) {
        if (asked.element >= count) break;
        // The same number may be asked for twice.
        if (asked.element >= done) {
          if (asked.element > done) {
            SkipElements(definition, member, asked.element - done, cursor);
          }
          // Most numbers are of this kind.
          number = is_double ? cursor->Read<double>() : ReadNumber(member, cursor);
          if (!cursor->is_good()) return;
          done = asked.element + 1;
        }
        (*values)[asked.value] = number;
      }
      for (const Inner& inner : wanted->messages) {
        if (inner.element >= count) break;
        if (inner.element > done) {
          SkipElements(definition, member, inner.element - done, cursor);
        }
        inner.plan.Decode(definition, member.message, cursor, values);
        done = inner.element + 1;
      }
      ++wanted;
    }
    if (count > done) SkipElements(definition, member, count - done, cursor);
  }
}

MessageDecoder::MessageDecoder(const MessageDefinition& definition,
                               MessageEncoding encoding,
                               const std::vector<std::string>& paths)
    : definition_(&definition),
      encoding_(encoding),
      num_values_(paths.size()),
      plan_(std::make_unique<Plan>()) {
  for (std::size_t i = 0; i < paths.size(); ++i) plan_->Add(definition, 0, paths[i], i);
}

MessageDecoder::~MessageDecoder() = default;
MessageDecoder::MessageDecoder(MessageDecoder&&) noexcept = default;
MessageDecoder& MessageDecoder::operator=(MessageDecoder&&) noexcept = default;

bool MessageDecoder::Decode(std::string_view message, std::vector<double>* values) const {
  values->assign(num_values_, std::numeric_limits<double>::quiet_NaN());
  Cursor cursor(message, encoding_);
  plan_->Decode(*definition_, 0, &cursor, values);
  return cursor.is_good();
}

}  // namespace fathom
