// Ways to meet a tolerance and what a pass of each is predicted to cost: how `auto` chooses. No clock is
// asked, so the same scene goes the same way everywhere.
#pragma once

#include <optional>
#include <string>

#include "simulate/simulation.h"

namespace drape {

// A method, the steps of its passes, and when to believe them.
struct Way {
    std::string method;
    std::optional<double> step;  // of its first pass [s]; none = the method's own
    std::string because;         // why it is taken
    double seconds = 0;          // predicted CPU of its first pass, simulation alone [s]
    double refinement = 1.25;    // between its first passes
    size_t least_passes = 2;     // before an error is stated
};

// In the order in which they are tried; where a method was asked for there is only the usual one.
struct Ways {
    std::optional<Way> rough;  // promises the tolerance for less than the usual way: loose, on stiff cloth
    Way usual;
    std::optional<Way> fine;  // of higher order: where the usual way would have to refine much
};

// What it costs to take a way until an error can be stated [s].
double seconds_to_judge(const Way& way);

// `tolerance` [m].
Ways ways_to(const Setup& setup, double tolerance);

// The same where time counts instead: what is rough is there for the case that nothing else fits.
Ways ways_within_budget(const Setup& setup);

// The setup of a pass along the way, with `refine` times the steps of its first pass.
Setup pass_along(const Way& way, Setup setup, double refine);

}  // namespace drape
