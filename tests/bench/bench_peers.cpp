// The hanging swatch of the standard problems against what else could integrate it: the least CPU time that
// reaches an error, one thread, all in one run. From the built system to the final positions is timed.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <deque>
#include <fstream>

#include "base/error.h"
#include "base/numbers.h"
#include "bench/drape_contestants.h"
#include "bench/plain_verlet.h"
#include "bench/sundials_solvers.h"
#include "bench/table.h"
#include "simulate/error_estimate.h"
#include "study/measure.h"
#include "study/sundials_reference.h"
#include "support/setups.h"

namespace drape::bench {

namespace {

struct Problem {
    const char* name = "";
    int divisions = 32;
    double stiffness = 500;             // [N/m]
    double time = 0.5;                  // [s]
    std::vector<double> errors = {};    // to be reached, the largest first [m]
    double reference_tolerance = 1e-8;  // of SUNDIALS
};

constexpr double loose = 1e-2;  // the error that stiff cloth is raced to [m]

std::vector<Problem> problems() {
    return {{.name = "33 x 33, 500 N/m, 0.5 s", .errors = {1e-4, 1e-6}, .reference_tolerance = 1e-10},
            {.name = "33 x 33, 50000 N/m, 0.2 s", .stiffness = 50000, .time = 0.2, .errors = {loose}},
            {.name = "65 x 65, 50000 N/m, 0.2 s",
             .divisions = 64,
             .stiffness = 50000,
             .time = 0.2,
             .errors = {loose}}};
}

constexpr double plain_first_step = 1.15;  // over the longest that is known to be stable
constexpr double reference_fineness = 4;   // times the steps that stability asks for
// Times the plain loop's CPU to the same error: a setting that needs more is given up, and with it whatever
// its ladder holds beyond.
constexpr double most_over_plain = 6;
constexpr double dear = 1;  // such entries are timed once [CPU s]

struct Reference {
    Points x;
    double bar = 0;  // RMS distance of the two runs [m]
    std::string how;
};

Reference make_reference(const Setup& setup, const SpringSystem& system, double time, double tolerance) {
    const Simulation stable(with_steps(setup, "srkn6", 1));
    const int steps = static_cast<int>(std::ceil(reference_fineness * time / stable.longest_step()));
    Simulation fine(with_steps(setup, "srkn6", steps));
    test::run(fine);
    const Outcome other = run_dormand_prince(system, time, tolerance, INFINITY);
    return {other.x, distance_between(other.x, fine.state().x).rms,
            cat("SUNDIALS ", sundials_version(), ", explicit pair 5(4), tolerances ", tolerance,
                "; against drape srkn6, ", steps, " steps")};
}

// One problem, all its contestants.
class Race {
public:
    Race(const Problem& problem, int rounds) : problem_(problem) {
        // peers give no frames on the way, so drape at fixed steps is not asked for any either
        whole_ = test::swatch(problem.divisions, problem.stiffness);
        frames_ = whole_;
        frames_.frames = static_cast<int>(std::lround(problem.time * frames_.frame_rate));
        whole_.frame_rate = 1 / problem.time;
        whole_.frames = 1;
        system_ = spring_system(whole_);
        reference_ = make_reference(whole_, system_, problem.time, problem.reference_tolerance);
        enter();
        climb_all();
        for (int round = 1; round < rounds; ++round) race_all();
    }
    Race(const Race&) = delete;
    Race& operator=(const Race&) = delete;
    const Problem& problem() const { return problem_; }
    const Reference& reference() const { return reference_; }

    // CPU of the cheapest whose name starts so [s]; NaN if none reaches the error
    double least(double error, std::string_view name) const {
        double least = NAN;
        for (const Contestant& contestant : contestants_)
            if (const Entry* best = taking_part(contestant, error) && contestant.name.starts_with(name)
                                        ? cheapest(contestant, error)
                                        : nullptr)
                least = std::fmin(least, best->cpu);
        return least;
    }
    double least_fixed(double error) const {
        double least = NAN;
        for (const Contestant& contestant : contestants_)
            if (contestant.name.starts_with("drape "))
                least = std::fmin(least, this->least(error, contestant.name));
        return least;
    }

    void add_rows(Table& table) const {
        for (const double error : problem_.errors)
            for (const Contestant& contestant : contestants_)
                if (taking_part(contestant, error)) table.rows.push_back(row(contestant, error));
    }

private:
    static bool taking_part(const Contestant& contestant, double error) {
        return !contestant.only_for || *contestant.only_for == error;
    }

    void enter() {
        const Simulation stable(with_steps(whole_, "verlet", 1));
        contestants_.push_back(
            plain_verlet(system_, problem_.time, problem_.time / (plain_first_step * stable.longest_step())));
        for (Contestant& contestant : sundials_contestants(system_, problem_.time))
            contestants_.push_back(std::move(contestant));
        for (Contestant& contestant : fixed_settings(whole_)) contestants_.push_back(std::move(contestant));
        for (const double error : problem_.errors) contestants_.push_back(to_tolerance(frames_, error));
        if (problem_.errors.front() == loose) contestants_.push_back(projections_with_error(whole_, loose));
        contestants_.push_back(nothing_asked(frames_));
    }

    void climb_all() {
        for (const double error : problem_.errors) {
            climb(contestants_[0], reference_.x, error, INFINITY);
            const double allowed = most_over_plain * least(error, contestants_[0].name);
            for (size_t i = 1; i < contestants_.size(); ++i)
                climb(contestants_[i], reference_.x, error, allowed);
        }
    }

    void race_all() {
        std::vector<Entry*> running;
        for (const double error : problem_.errors)
            for (Contestant& contestant : contestants_)
                if (taking_part(contestant, error))
                    for (Entry* entry : candidates(contestant, error)) running.push_back(entry);
        race(running, dear);
    }

    std::vector<std::string> row(const Contestant& contestant, double error) const {
        const std::string asked = figure(error);
        if (const Entry* best = cheapest(contestant, error))
            return {problem_.name,
                    asked,
                    contestant.name,
                    best->setting,
                    figure(best->error, 2),
                    best->told ? figure(*best->told, 2) : "",
                    figure(best->cpu),
                    best->apart > 0 ? figure(best->apart) : "",
                    figure(best->cpu / least(error, contestants_[0].name))};
        const Entry* nearest = nullptr;
        const Entry* last = nullptr;
        for (const Entry& entry : contestant.entries) {
            if (std::isfinite(entry.error) && (!nearest || entry.error < nearest->error)) nearest = &entry;
            if (std::isfinite(entry.cpu)) last = &entry;
        }
        return {problem_.name,
                asked,
                contestant.name,
                last ? "not reached with " + last->setting : "",
                nearest ? figure(nearest->error, 2) : "",
                nearest && nearest->told ? figure(*nearest->told, 2) : "",
                last ? "> " + figure(last->cpu) : "",
                "",
                last ? "> " + figure(last->cpu / least(error, contestants_[0].name)) : ""};
    }

    Problem problem_;
    Setup whole_, frames_;  // in one frame; in frames as a user asks for them
    SpringSystem system_;
    Reference reference_;
    std::vector<Contestant> contestants_;  // the plain loop first
};

struct Target {
    std::string what;
    double measured = NAN, limit = 0;
    bool at_least = false;

    std::string text() const {
        const bool met = at_least ? measured >= limit : measured <= limit;
        return cat(met ? "met     " : "missed  ", what, ": ", figure(measured), " (",
                   at_least ? "at least " : "at most ", limit, ")");
    }
};

std::vector<Target> targets(const std::deque<Race>& races) {
    std::vector<Target> all;
    for (const Race& race : races) {
        const std::string where = cat(race.problem().name, ": ");
        for (const double error : race.problem().errors) {
            const double plain = race.least(error, "plain"), fixed = race.least_fixed(error);
            const std::string to = cat("to ", error, " m, ");
            if (error == 1e-4) {
                all.push_back({where + to + "fixed setting over the plain loop", fixed / plain, 0.6});
                all.push_back({where + to + "SUNDIALS' best over the fixed setting",
                               race.least(error, "SUNDIALS") / fixed, 5, true});
            }
            if (error == 1e-6) {
                const std::string more = "to 1e-6 m over that to 1e-4 m";
                const char* delivery = "drape, to a tolerance";
                all.push_back({where + "fixed setting " + more, fixed / race.least_fixed(1e-4), 2});
                all.push_back({where + "run to a tolerance " + more,
                               race.least(error, delivery) / race.least(1e-4, delivery), 2});
            }
            if (error == loose) {
                all.push_back({where + to + "fixed setting over the plain loop", fixed / plain, 0.2});
                all.push_back({where + to + "the same with its error estimated",
                               race.least(error, "drape, xpbd and its error") / plain, 0.5});
            }
        }
    }
    return all;
}

int run(int argc, char** argv) {
    CLI::App app("least CPU time to an error: drape against a plain Verlet loop and SUNDIALS");
    int rounds = 5, only = 0;
    std::string csv;
    bool markdown = false;
    app.add_option("--rounds", rounds, "timings of each, in turn with all others; the least counts")
        ->check(CLI::Range(1, 100));
    app.add_option("--problem", only, "one of the three problems alone")->check(CLI::Range(1, 3));
    app.add_option("--csv", csv, "also write the table to this file");
    app.add_flag("--markdown", markdown, "the table as Markdown");
    CLI11_PARSE(app, argc, argv);

    Table table;
    table.head = {"problem", "error asked, m",   "contestant",
                  "setting", "error reached, m", "stated, m",
                  "CPU s",   "twin, CPU s",      "over the plain loop"};
    std::deque<Race> races;
    for (size_t i = 0; i < problems().size(); ++i) {
        if (only > 0 && static_cast<size_t>(only) != i + 1) continue;
        const Race& race = races.emplace_back(problems()[i], rounds);
        std::printf("%s: reference %s: error bar %s m RMS\n", race.problem().name,
                    race.reference().how.c_str(), figure(race.reference().bar, 2).c_str());
        std::fflush(stdout);
        race.add_rows(table);
    }
    std::printf("\n%s\n", (markdown ? table.markdown() : table.text()).c_str());
    for (const Target& target : targets(races)) std::printf("%s\n", target.text().c_str());
    if (!csv.empty() && !(std::ofstream(csv) << table.csv())) throw Error(cat(csv, ": cannot be written"));
    return 0;
}

}  // namespace

}  // namespace drape::bench

int main(int argc, char** argv) {
    try {
        return drape::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_peers: %s\n", error.what());
        return 1;
    }
}
