#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_sparse.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>

#include "bench/sundials_problem.h"
#include "bench/sundials_solvers.h"

namespace drape::bench {

namespace {

// d2E/dx_a^2 of a spring: c n n' + c (1 - l0/l) (I - n n')
Mat3 spring_block(const PlainSpring& spring, const double* x) {
    const Vec3 along = Eigen::Map<const Vec3>(x + 3 * spring.a) - Eigen::Map<const Vec3>(x + 3 * spring.b);
    const double length = along.norm(), across = 1 - spring.rest_length / length;
    const Vec3 n = along / length;
    return spring.stiffness * (across * Mat3::Identity() + (1 - across) * n * n.transpose());
}

// The Jacobian of (v, a(x)) by columns, with the zeros of its diagonal in the pattern, since the systems to
// be solved are of 1 - gamma J:
//   column of x_i:  row x_i (0), then the rows of a of i and its neighbours
//   column of v_i:  row x_i (1), row v_i (0)
class JacobianPattern {
public:
    explicit JacobianPattern(const SpringSystem& system) : neighbours_(system.inverse_mass.size()) {
        for (size_t i = 0; i < neighbours_.size(); ++i) neighbours_[i].push_back(static_cast<int>(i));
        for (const PlainSpring& spring : system.springs) {
            neighbours_[static_cast<size_t>(spring.a)].push_back(spring.b);
            neighbours_[static_cast<size_t>(spring.b)].push_back(spring.a);
        }
        for (std::vector<int>& list : neighbours_) {
            std::sort(list.begin(), list.end());
            entries_ += 3 * (1 + 3 * static_cast<sunindextype>(list.size())) + 6;
        }
    }
    sunindextype entries() const { return entries_; }

    void fill(const SpringSystem& system, const double* x, SUNMatrix jacobian) const {
        sunindextype* starts = SUNSparseMatrix_IndexPointers(jacobian);
        sunindextype* rows = SUNSparseMatrix_IndexValues(jacobian);
        double* values = SUNSparseMatrix_Data(jacobian);
        const auto half = static_cast<sunindextype>(system.x.size());
        sunindextype next = 0, column = 0;
        const auto put = [&](sunindextype row, double value) {
            rows[next] = row;
            values[next++] = value;
        };
        for (const std::vector<int>& list : neighbours_) {
            for (int c = 0; c < 3; ++c) {
                starts[column] = next;
                put(column++, 0);
                for (const int j : list)
                    for (int r = 0; r < 3; ++r) put(half + 3 * j + r, 0);
            }
        }
        for (; column < 2 * half; ++column) {
            starts[column] = next;
            put(column - half, 1);
            put(column, 0);
        }
        starts[column] = next;
        for (const PlainSpring& spring : system.springs) {
            const Mat3 block = spring_block(spring, x);
            add(system, spring.a, spring.a, -block, starts, values);
            add(system, spring.a, spring.b, block, starts, values);
            add(system, spring.b, spring.a, block, starts, values);
            add(system, spring.b, spring.b, -block, starts, values);
        }
    }

private:
    // to the acceleration of `row` by the position of `column`
    void add(const SpringSystem& system, int row, int column, const Mat3& block, const sunindextype* starts,
             double* values) const {
        const std::vector<int>& list = neighbours_[static_cast<size_t>(column)];
        const auto place = std::lower_bound(list.begin(), list.end(), row) - list.begin();
        const double inverse_mass = system.inverse_mass[static_cast<size_t>(row)];
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                values[starts[3 * column + c] + 1 + 3 * place + r] += inverse_mass * block(r, c);
    }

    std::vector<std::vector<int>> neighbours_;  // of each vertex with itself, in order
    sunindextype entries_ = 0;
};

// What CVODE's callbacks are handed.
struct Implicit {
    SundialsProblem problem;
    JacobianPattern pattern;

    Implicit(const SpringSystem& system, double most_cpu) : problem(system, most_cpu), pattern(system) {}
};

int slope(realtype time, N_Vector y, N_Vector out, void* implicit) {
    return sundials_slope(time, y, out, &static_cast<Implicit*>(implicit)->problem);
}

int fill_jacobian(realtype, N_Vector y, N_Vector, SUNMatrix jacobian, void* implicit, N_Vector, N_Vector,
                  N_Vector) {
    const auto& own = *static_cast<const Implicit*>(implicit);
    own.pattern.fill(own.problem.system(), N_VGetArrayPointer(y), jacobian);
    return 0;
}

int jacobian_times(N_Vector direction, N_Vector product, realtype, N_Vector y, N_Vector, void* implicit,
                   N_Vector) {
    const SpringSystem& system = static_cast<const Implicit*>(implicit)->problem.system();
    const auto half = static_cast<std::ptrdiff_t>(system.x.size());
    const double* d = N_VGetArrayPointer(direction);
    double* out = N_VGetArrayPointer(product);
    const double* x = N_VGetArrayPointer(y);
    std::copy(d + half, d + 2 * half, out);
    std::fill(out + half, out + 2 * half, 0.0);
    for (const PlainSpring& spring : system.springs) {
        const Vec3 moved =
            Eigen::Map<const Vec3>(d + 3 * spring.a) - Eigen::Map<const Vec3>(d + 3 * spring.b);
        const Vec3 force = spring_block(spring, x) * moved;
        Eigen::Map<Vec3>(out + half + 3 * spring.a) -=
            system.inverse_mass[static_cast<size_t>(spring.a)] * force;
        Eigen::Map<Vec3>(out + half + 3 * spring.b) +=
            system.inverse_mass[static_cast<size_t>(spring.b)] * force;
    }
    return 0;
}

// CVODE up to the final time; `attach` gives it what solves its equations.
template <class Attach>
Outcome run_cvode(int family, Implicit& implicit, double time, double tolerance, Attach&& attach) {
    SundialsProblem& problem = implicit.problem;
    void* memory = CVodeCreate(family, problem.context());
    CVodeSetErrHandlerFn(
        memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
    CVodeInit(memory, slope, 0, problem.y());
    CVodeSetUserData(memory, &implicit);
    CVodeSStolerances(memory, tolerance, tolerance);
    CVodeSetMaxNumSteps(memory, -1);
    CVodeSetStopTime(memory, time);
    attach(memory);
    realtype reached = 0;
    const int code = CVode(memory, time, problem.y(), &reached, CV_NORMAL);
    CVodeFree(&memory);
    return problem.outcome(code);
}

}  // namespace

Outcome run_adams(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    Implicit implicit(system, most_cpu);
    SUNNonlinearSolver iteration =
        SUNNonlinSol_FixedPoint(implicit.problem.y(), 0, implicit.problem.context());
    Outcome outcome = run_cvode(CV_ADAMS, implicit, time, tolerance,
                                [&](void* memory) { CVodeSetNonlinearSolver(memory, iteration); });
    SUNNonlinSolFree(iteration);
    return outcome;
}

Outcome run_bdf_direct(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    Implicit implicit(system, most_cpu);
    const SUNContext context = implicit.problem.context();
    const auto unknowns = static_cast<sunindextype>(2 * system.x.size());
    SUNMatrix matrix = SUNSparseMatrix(unknowns, unknowns, implicit.pattern.entries(), CSC_MAT, context);
    SUNLinearSolver solver = SUNLinSol_KLU(implicit.problem.y(), matrix, context);
    Outcome outcome = run_cvode(CV_BDF, implicit, time, tolerance, [&](void* memory) {
        CVodeSetLinearSolver(memory, solver, matrix);
        CVodeSetJacFn(memory, fill_jacobian);
    });
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    return outcome;
}

Outcome run_bdf_krylov(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    Implicit implicit(system, most_cpu);
    SUNLinearSolver solver =
        SUNLinSol_SPGMR(implicit.problem.y(), SUN_PREC_NONE, 0, implicit.problem.context());
    Outcome outcome = run_cvode(CV_BDF, implicit, time, tolerance, [&](void* memory) {
        CVodeSetLinearSolver(memory, solver, nullptr);
        CVodeSetJacTimes(memory, nullptr, jacobian_times);
    });
    SUNLinSolFree(solver);
    return outcome;
}

}  // namespace drape::bench
