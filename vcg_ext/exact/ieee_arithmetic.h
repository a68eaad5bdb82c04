// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the flags that a unit is compiled with; out: an error, where a double would not be what the
// error bounds of exact_number.h take it for. What no compiler tells, that products are not fused
// into sums, CMake asks for with the core.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "exact decisions need IEEE arithmetic: compile without -ffast-math"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "exact decisions need infinities and NaN: compile without -ffinite-math-only"
#endif
#if FLT_EVAL_METHOD != 0
#error "exact decisions need doubles that are rounded at once: compile for SSE2, not for the x87"
#endif
