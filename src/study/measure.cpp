#include "study/measure.h"

#include "base/timer.h"

namespace drape {

MeasuredPass measure_pass(const Setup& setup, double most_cpu, const AtFrame& at_frame) {
    Simulation simulation(setup);
    MeasuredPass pass;
    pass.step = simulation.step();
    const double start = simulation.energies().total();
    const long sweeps_before = simulation.dynamics().sweeps();
    while (simulation.frame() < simulation.frames()) {
        const WallTimer wall;
        const FrameReport frame = simulation.advance();
        pass.wall_seconds += wall.seconds();
        pass.cpu_seconds += frame.cpu_seconds;
        pass.steps += frame.steps;
        pass.trouble = frame.trouble;
        if (!pass.trouble.empty()) break;
        if (at_frame) at_frame(simulation.state());
        pass.cut_short = pass.cpu_seconds > most_cpu && simulation.frame() < simulation.frames();
        if (pass.cut_short) break;
    }
    pass.frames = simulation.frame();
    pass.sweeps = simulation.dynamics().sweeps() - sweeps_before;
    pass.solver = simulation.solver_work();
    const EnergyFlow& flow = simulation.flow();
    pass.energy_drift = simulation.energies().total() - start - flow.driven + flow.dissipated;
    pass.end = simulation.state();
    return pass;
}

Setup with_steps(Setup setup, std::string_view method, int steps) {
    setup.method = method;
    setup.step = 1 / setup.frame_rate / steps;
    return setup;
}

}  // namespace drape
