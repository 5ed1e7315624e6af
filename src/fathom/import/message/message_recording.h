// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_container.h"
#include "fathom/import/message/message_definition.h"
#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// What a message type is made of, by the text that the file holds. Throws InputError, naming the
// type, for a text that does not say it.
using DefinitionParser = MessageDefinition (*)(std::string_view type, std::string_view text);

// A file of messages of ROS or Rock as a recording; docs/import.md. A channel is a topic. Its
// stamps are the times at which the messages were written down; the map may take those of the
// messages' headers instead. Fields are the numbers of the first message by their paths,
// "pose.pose.position.x", "data[3]".
std::unique_ptr<Recording> OpenMessageRecording(const std::filesystem::path& path,
                                                std::unique_ptr<MessageContainer> container,
                                                DefinitionParser parse);

}  // namespace fathom
