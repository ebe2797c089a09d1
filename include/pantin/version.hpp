// SPDX-License-Identifier: MIT
// The version of the library, for the preprocessor (https://semver.org). The one place that says it: the
// Makefile, the program and the man pages take it from here.
#pragma once

#define PANTIN_VERSION_MAJOR 0
#define PANTIN_VERSION_MINOR 1
#define PANTIN_VERSION_PATCH 0
#define PANTIN_RELEASE_DATE "2026-11-28"

#define PANTIN_TEXT_OF(number) #number
#define PANTIN_JOINED(major, minor, patch)                                                                   \
    PANTIN_TEXT_OF(major) "." PANTIN_TEXT_OF(minor) "." PANTIN_TEXT_OF(patch)
// "0.1.0"
#define PANTIN_VERSION PANTIN_JOINED(PANTIN_VERSION_MAJOR, PANTIN_VERSION_MINOR, PANTIN_VERSION_PATCH)
