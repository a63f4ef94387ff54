// Code that may crash, hang or eat memory on a bad file runs in a process of its own, so that the worst it
// can do is fail: it gets limits on memory and CPU time, and only the bytes it returns come back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace drape {

struct Limits {
    std::uint64_t memory = 0;  // [bytes]
    int cpu = 0;               // [s]
};

// What `work` returns. An Error it throws is thrown here. Throws Error "needs more than ..." or "crashes ..."
// when it ends in another way.
std::string run_isolated(const Limits& limits, const std::function<std::string()>& work);

}  // namespace drape
