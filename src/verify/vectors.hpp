// SPDX-License-Identifier: MIT
// The reference vectors that are compiled in: inputs and outputs of every stage (testdata/vectors/README.md).
#pragma once

#include <span>

#include "pantin/verify.hpp"

namespace pantin {

// The files of the archive by their names below `vectors`.
Files stored_vectors();

// The regular files of a gzipped tar archive (RFC 1952; POSIX.1-1988 ustar), in memory. Error(internal) when
// it is damaged.
Files read_archive(std::span<const unsigned char> bytes);

} // namespace pantin
