// The engine's sweeps beside the plain loop that anyone would write, in one run: times per spring or per
// vertex and their ratios. Google Benchmark's own options apply (--benchmark_filter=...).
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "force/edge_spring.h"
#include "integrate/dynamics.h"
#include "support/motion.h"
#include "support/setups.h"

namespace drape::bench {

namespace {

using namespace drape::test;

// A square metre of damped springs, blended altitudes and plates, stretched a little and crumpled a little.
struct Sheet {
    Model model;
    Points x, v;

    explicit Sheet(int side) : model(model_of(square(side - 1), full_fabric())) {
        x = 1.01 * model.cloths[0].mesh.rest + random_points(model.vertices(), 0.1 / side, 1);
        v = random_points(model.vertices(), 0.1, 2);
    }
    const std::vector<Spring>& springs() const { return model.cloths[0].network.edges; }
};

// one spring after the other, three doubles a vertex
void plain_sweep(const std::vector<Spring>& springs, const double* x, double* f) {
    for (const Spring& s : springs) {
        const double *p = x + 3 * s.a, *q = x + 3 * s.b;
        const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
        const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const double pull = s.stiffness * (length - s.rest_length) / length;
        double *fa = f + 3 * s.a, *fb = f + 3 * s.b;
        for (int c = 0; c < 3; ++c) {
            fa[c] -= pull * d[c];
            fb[c] += pull * d[c];
        }
    }
}

void plain_edges(benchmark::State& state) {
    const Sheet sheet(static_cast<int>(state.range(0)));
    Points f = Points::Zero(3, sheet.x.cols());
    for (auto _ : state) {
        plain_sweep(sheet.springs(), sheet.x.data(), f.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<long>(sheet.springs().size()));
}

void edges(benchmark::State& state) {
    const Sheet sheet(static_cast<int>(state.range(0)));
    const EdgeSweep sweep(sheet.springs(), 0);
    PaddedPoints x, f = PaddedPoints::Zero(4, sheet.x.cols());
    pad(sheet.x, x);
    for (auto _ : state) {
        sweep.pull(x, f);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<long>(sheet.springs().size()));
}

// everything that a damped cloth in free fall feels, from positions to accelerations
void all_forces(benchmark::State& state) {
    const Sheet sheet(static_cast<int>(state.range(0)));
    Dynamics dynamics(sheet.model, forces_of(sheet.model, {}), nullptr);
    Points a;
    for (auto _ : state) {
        dynamics.acceleration(sheet.x, sheet.v, 0, a);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<long>(sheet.springs().size()));
}

void sides(benchmark::internal::Benchmark* each) {
    for (const int side : {33, 129, 513}) each->Arg(side);
}

// the best of several repetitions, taken by turns, so that a busy moment hits all alike
constexpr int repetitions = 7;
BENCHMARK(plain_edges)->Apply(sides)->Repetitions(repetitions)->MinTime(0.05);
BENCHMARK(edges)->Apply(sides)->Repetitions(repetitions)->MinTime(0.05);
BENCHMARK(all_forces)->Apply(sides)->Repetitions(repetitions)->MinTime(0.05);

class BestTimes final : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            const double ns = 1e9 / run.counters.at("items_per_second");
            double& best = best_[{std::stoi(run.run_name.args), run.run_name.function_name}];
            if (best == 0 || ns < best) best = ns;
        }
    }
    void Finalize() override {
        std::puts("| vertices | plain loop, ns a spring | edge sweep | ratio | all forces, in edge sweeps |");
        std::puts("|---:|---:|---:|---:|---:|");
        for (const auto& [key, plain] : best_) {
            const auto& [side, name] = key;
            if (name != "plain_edges") continue;
            const auto edge = best_.find({side, "edges"}), all = best_.find({side, "all_forces"});
            if (edge == best_.end() || all == best_.end()) continue;
            std::printf("| %d x %d | %.2f | %.2f | %.2f | %.1f |\n", side, side, plain, edge->second,
                        plain / edge->second, all->second / edge->second);
        }
    }

private:
    std::map<std::pair<int, std::string>, double> best_;  // [ns]
};

}  // namespace
}  // namespace drape::bench

int main(int argc, char** argv) {
    std::string by_turns = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments(argv, argv + argc);
    arguments.insert(arguments.begin() + 1, by_turns.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    drape::bench::BestTimes best;
    benchmark::RunSpecifiedBenchmarks(&best);
}
