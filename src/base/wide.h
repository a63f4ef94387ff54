// DRAPE_WIDE: compiles a function once per vector width and picks at start-up what the machine has.
// The arithmetic is the same IEEE operations in the same order at every width (contraction is off), so the
// results are the same bits everywhere. Where a test asks for one width, DRAPE_WIDTH ("avx2") or
// DRAPE_NARROW, there is no choice; nor is there under the sanitizers, whose runtime is not up yet when it is
// made, and where the loader cannot choose.
#pragma once

#ifdef DRAPE_WIDTH
#define DRAPE_WIDE __attribute__((target(DRAPE_WIDTH)))
#elif !defined(DRAPE_NARROW) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define DRAPE_WIDE __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define DRAPE_WIDE
#endif
