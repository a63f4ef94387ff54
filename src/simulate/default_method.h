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

// Its implicit stand-in.
inline constexpr const char* implicit_choice = "tr_bdf2";

// For a step that someone insists on, so many times the explicit limit: the trapezoid rule within TR-BDF2
// gains energy where stiff springs turn by much in a step (the stability maps show it), backward Euler
// cannot.
inline constexpr const char* bounded_choice = "backward_euler";
inline constexpr double far_beyond = 30;

// Implicit steps damp motion that explicit ones resolve: they are taken only where these are predicted to
// cost more than so many times as much.
inline constexpr double explicit_worth = 4;

}  // namespace drape
