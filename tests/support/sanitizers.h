// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Defines INDEXBOOLEAN_THREAD_SANITIZER where the tests are built with it.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define INDEXBOOLEAN_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define INDEXBOOLEAN_THREAD_SANITIZER
#endif
#endif
