// Two passes advanced by a frame each, on two threads where there are two.
#pragma once

#include <future>
#include <utility>

#include "simulate/simulation.h"

namespace drape {

inline std::pair<FrameReport, FrameReport> advance_both(Simulation& first, Simulation& second, int threads) {
    if (threads < 2) {
        FrameReport report = first.advance();
        return {std::move(report), second.advance()};
    }
    std::future<FrameReport> other = std::async(std::launch::async, [&] { return second.advance(); });
    FrameReport report = first.advance();
    return {std::move(report), other.get()};
}

}  // namespace drape
