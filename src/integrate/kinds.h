// The makers of every method, for the table in methods.cpp, and the steps they share.
#pragma once

#include "integrate/method.h"

namespace drape {

std::unique_ptr<Integrator> make_symplectic_euler();
std::unique_ptr<Integrator> make_verlet();
std::unique_ptr<Integrator> make_takahashi_imada();
std::unique_ptr<Integrator> make_srkn4();
std::unique_ptr<Integrator> make_srkn6();
std::unique_ptr<Integrator> make_rk4();
std::unique_ptr<Integrator> make_embedded_rk();
std::unique_ptr<Integrator> make_xpbd();
std::unique_ptr<Integrator> make_backward_euler_1();
std::unique_ptr<Integrator> make_backward_euler();
std::unique_ptr<Integrator> make_bdf2();
std::unique_ptr<Integrator> make_tr_bdf2();
std::unique_ptr<Integrator> make_projective_dynamics();

double symplectic_euler_longest_step(const Spectrum&);
double verlet_longest_step(const Spectrum&);
double takahashi_imada_longest_step(const Spectrum&);
double srkn4_longest_step(const Spectrum&);
double srkn6_longest_step(const Spectrum&);
double rk4_longest_step(const Spectrum&);
double embedded_rk_longest_step(const Spectrum&);
double xpbd_longest_step(const Spectrum&);
inline double unlimited_step(const Spectrum&) {
    return INFINITY;
}

// v += h a, then friction's impulses of the time h
void kick(Dynamics& dynamics, State& state, const Points& a, double h);

// x += h v, t += h, pins to their places
void drift(Dynamics& dynamics, State& state, double h);

}  // namespace drape
