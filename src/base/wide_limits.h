// SPDX-License-Identifier: MIT
// Least and most numbers in math.h are met with "at least", lanes only know "less": they get the floats next to those.
// For base/wide_math.h.
#ifndef SOLE_BASE_WIDE_LIMITS_H
#define SOLE_BASE_WIDE_LIMITS_H

#define SOLE_BELOW_LEAST 0x1.197996p-40f  // the largest float below 1e-12
#define SOLE_ABOVE_MOST 0x1.c363cep+127f  // the smallest above 3e38
#define SOLE_BELOW_LENGTH 0x1.79ca0ep-67f // the largest below 1e-20

#endif
