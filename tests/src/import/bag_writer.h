// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// Writes bags of ROS 1 for tests, from the description of the format (wiki.ros.org, "Bags/Format/
// 2.0").
namespace bag {

// As "none", "bz2", "lz4" or "zstd".
std::string Compressed(const std::string& compression, const std::string& text);

std::string WithLength(const std::string& text);

std::string Record(const std::vector<std::pair<std::string, std::string>>& fields,
                   const std::string& data);

std::string Connection(std::uint32_t number,
                       const std::string& topic,
                       const std::string& type,
                       const std::string& definition);

// Written down half a second later than stated.
std::string Message(std::uint32_t number, std::uint32_t seconds, const std::string& data);

std::string Chunk(const std::string& compression, const std::string& records);

// Of such messages of a connection in the chunk before it, one in each second.
std::string Index(std::uint32_t number, std::uint32_t first_second, std::uint32_t count);

// The first bytes of a file; 0: it was not closed.
std::string Head(std::uint64_t index_at = 1000);

}  // namespace bag
}  // namespace fathom
