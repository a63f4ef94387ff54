// DRAPE_ASSERT(condition): our own bugs. On in the `checked` and `sanitize` builds, free in `release`.
// Bad input is never asserted on: it is an Error (error.h).
#pragma once

#ifdef DRAPE_ASSERTS
#include <cstdio>
#include <cstdlib>
#define DRAPE_ASSERT(condition)                                                                            \
    do {                                                                                                   \
        if (!(condition)) {                                                                                \
            std::fprintf(stderr, "drape: bug: %s:%d: %s does not hold\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                                  \
        }                                                                                                  \
    } while (false)
#else
#define DRAPE_ASSERT(condition) static_cast<void>(0)
#endif
