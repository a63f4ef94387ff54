// Which steps each method is tried with. Explicit methods start at 0.98 of their longest stable step, methods
// that are stable with any step at one step a frame; each goes on with shorter ones until its error reaches
// the reference's bar, its steps are as short as is of use, or the budget ends. The cheapest rung of any
// method comes first, so that a small budget is shared fairly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/probe.h"
#include "study/rung.h"

namespace drape {

struct RefusedMethod {
    const Method* method = nullptr;
    std::string why;
};

class Ladder {
public:
    // `fine`: cost allows rungs that are a factor of sqrt 2 apart instead of 2
    Ladder(const Setup& setup, const Probe& probe, const std::vector<const Method*>& methods, bool fine);

    std::optional<Rung> next() const;  // the cheapest that is left; none: all is done

    // What became of the rung that next() gave; a method whose error is below the bar, or which was left out,
    // ends there.
    void done(const Rung& rung);

    const std::vector<RefusedMethod>& refused() const { return refused_; }  // scenes like this

private:
    struct Row {
        const Method* method = nullptr;
        double first = 1, ratio = 2;  // steps a frame of the first rung; from rung to rung
        int rung = 0, most = 0, failed = 0;
        double seconds_per_step = 0;
        int told = 0;  // steps a frame of the last whole pass, 0 if none was run
        int steps() const;
        double predicted_cpu() const;
    };
    std::vector<Row> rows_;
    std::vector<RefusedMethod> refused_;
    double frame_time_ = 0;  // [s]
};

}  // namespace drape
