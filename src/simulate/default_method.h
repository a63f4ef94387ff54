// What a run takes that asks for neither a method nor a tolerance.
#pragma once

#include <string>

namespace drape {

class Dynamics;

struct MethodChoice {
    std::string method;
    std::string because;
};

// The explicit method that suits the forces.
MethodChoice explicit_choice(const Dynamics& dynamics);

// Its implicit stand-in, for steps far beyond the explicit limit.
inline constexpr const char* implicit_choice = "tr_bdf2";

// Implicit steps damp motion that explicit ones resolve: they are taken only where these are predicted to
// cost more than so many times as much.
inline constexpr double explicit_worth = 4;

}  // namespace drape
